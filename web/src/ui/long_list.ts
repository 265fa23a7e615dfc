import { html, LitElement } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { VirtualRows } from "./virtual_rows";
import "./long_list.css";

/** Expected height of a row, in CSS pixels. */
const ROW_HEIGHT = 60;

/**
 * A scrolling list of which only the rows near the visible part are in the page. The focused row and its neighbours
 * stay in the page, so that the Tab key continues from it.
 */
export class LongList extends LitElement {
	static override properties = {
		label: { attribute: false },
		count: { attribute: false },
		row: { attribute: false },
	};
	/** The accessible name of the list. */
	declare label: string;
	declare count: number;
	/** Draws the row with an index. A new function redraws all rows. */
	declare row: (index: number) => unknown;

	/** Index of the row with the focus. */
	#focused: number | undefined;
	readonly #rows = new VirtualRows(this, {
		scroller: () => this.querySelector(".long-list"),
		list: () => this.querySelector<HTMLElement>(".rows"),
		rowHeight: ROW_HEIGHT,
	});

	/** Renders into the element itself, so that the page's style applies. */
	protected override createRenderRoot(): this {
		return this;
	}

	/**
	 * Renders the rows near the visible part, and the focused row with its neighbours, so that Tab and screen readers
	 * reach them.
	 */
	protected override render(): unknown {
		const at = this.#focused;
		const rows = this.#rows.rows(this.count, at === undefined ? [] : [at - 1, at, at + 1]);
		return html`<div class="long-list" tabindex="-1" @focusin=${this.#focus} @focusout=${this.#blur}>
			<div class="rows" role="list" aria-label=${this.label} .style=${`height: ${this.#rows.height}px`}>${repeat(
				rows,
				({ index }) => index,
				(row) => html`<div
					class="row" role="listitem" aria-posinset=${row.index + 1} aria-setsize=${this.count} data-index=${row.index}
					.style=${this.#rows.rowStyle(row)}
				>${this.row(row.index)}</div>`,
			)}</div>
		</div>`;
	}

	/** Measures the rows that were drawn. */
	protected override updated(): void {
		this.#rows.measure();
	}

	/** Records the row that gets the focus, which then stays in the page. */
	#focus({ target }: FocusEvent): void {
		const row = (target as Element).closest<HTMLElement>("[data-index]");
		this.#focused = row ? Number(row.dataset.index) : undefined;
		this.requestUpdate();
	}

	/** Forgets the row that loses the focus. */
	#blur(): void {
		this.#focused = undefined;
	}
}

customElements.define("panicle-long-list", LongList);
