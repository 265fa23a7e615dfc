import {
	defaultRangeExtractor,
	type VirtualItem,
	VirtualizerController,
	type VirtualizerOptions,
} from "@tanstack/lit-virtual";
import type { LitElement } from "lit";

export interface VirtualRowsOptions {
	/** The element that scrolls; null before it is in the page. */
	scroller(): Element | null;
	/** The element that holds the rows; null before it is in the page. */
	list(): HTMLElement | null;
	/** Expected height of a row that has not been measured, in CSS pixels. */
	readonly rowHeight: number;
	/** Space between two rows, in CSS pixels; 0 where absent. */
	readonly gap?: number;
}

/** Rows drawn before and after those that can be seen. */
const OVERSCAN = 2;

/**
 * Rows of a long list: only those near the visible part of the scroller are in the page. The host draws `rows()` with
 * their index in `data-index`, in a list of the height `height`, each row placed by `rowStyle`, and calls `measure`
 * after each update.
 */
export class VirtualRows {
	readonly #host: LitElement;
	readonly #options: VirtualRowsOptions;
	readonly #controller: VirtualizerController<Element, HTMLElement>;

	/** @param host element that renders the rows; updated when other rows come into view */
	constructor(host: LitElement, options: VirtualRowsOptions) {
		this.#host = host;
		this.#options = options;
		this.#controller = new VirtualizerController<Element, HTMLElement>(host, {
			count: 0,
			getScrollElement: () => options.scroller(),
			estimateSize: () => options.rowHeight,
			overscan: OVERSCAN,
			gap: options.gap ?? 0,
		});
	}

	/**
	 * Returns the rows to draw.
	 * @param count how many rows the whole list has
	 * @param pinned indices of rows that are drawn wherever the scroller is, such as the row with the focus
	 */
	rows(count: number, pinned: readonly number[] = []): readonly VirtualItem[] {
		this.#setOptions({
			count,
			rangeExtractor: (range) => withRows(defaultRangeExtractor(range), pinned, count),
		});
		return this.#virtualizer.getVirtualItems();
	}

	/** Height of the whole list, in CSS pixels. */
	get height(): number {
		return this.#virtualizer.getTotalSize();
	}

	/** Returns the inline style that puts a row in its place; the list is its containing block. */
	rowStyle({ start }: VirtualItem): string {
		return `transform: translateY(${start - this.#virtualizer.options.scrollMargin}px)`;
	}

	/** Forgets the measured heights, because all rows have others now. */
	forget(): void {
		this.#virtualizer.measure();
	}

	/** Measures the rows that were drawn, and how far the list is from the top of the scroller's content. */
	measure(): void {
		const [scroller, list] = [this.#options.scroller(), this.#options.list()];
		if (!scroller || !list) return;
		for (const row of list.querySelectorAll<HTMLElement>(":scope > [data-index]"))
			this.#virtualizer.measureElement(row);
		this.#virtualizer.measureElement(null);
		const top = list.getBoundingClientRect().top - scroller.getBoundingClientRect().top;
		const scrollMargin = Math.round(top - scroller.clientTop + scroller.scrollTop);
		if (scrollMargin === this.#virtualizer.options.scrollMargin) return;
		this.#setOptions({ scrollMargin });
		this.#host.requestUpdate();
	}

	/** The library's object that computes the visible range. */
	get #virtualizer() {
		return this.#controller.getVirtualizer();
	}

	/** Changes some of its options. */
	#setOptions(options: Partial<VirtualizerOptions<Element, HTMLElement>>): void {
		this.#virtualizer.setOptions({ ...this.#virtualizer.options, ...options });
	}
}

/** Returns the indices of visible rows and pinned rows together, in order. */
function withRows(rows: readonly number[], pinned: readonly number[], count: number): number[] {
	const isRow = (index: number) => index >= 0 && index < count;
	return [...new Set([...rows, ...pinned.filter(isRow)])].sort((a, b) => a - b);
}
