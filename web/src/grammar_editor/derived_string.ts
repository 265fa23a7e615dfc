import { html, LitElement, nothing, type PropertyValues } from "lit";
import type { DerivationTrace, TraceEntry } from "../plant/derivation_trace";
import { partsOfModule } from "./trace_words";

/** Modules per page key. */
const PAGE = 40;
/** Distance from an end of the window at which scrolling loads the next window, in CSS pixels. */
const NEAR = 120;

/** Events of the list of modules. */
export interface StringEvents {
	choose(index: number): void;
	point(index: number | undefined): void;
	/** Another part of the string becomes visible. */
	look(about: number): void;
	/** Move to the parent, or to the first child. */
	up(): void;
	down(): void;
	/** Moves to the production that rewrites the chosen module, or that wrote it. */
	open(): void;
}

/**
 * Shows the string of a step as a list of modules, of which one window is loaded. The list is one stop of the Tab key:
 * the focus stays on the list while modules are replaced, and aria-activedescendant names the chosen one.
 */
export class DerivedString extends LitElement {
	static override properties = {
		page: { attribute: false },
		busy: { attribute: false },
		chosen: { attribute: false },
		pointed: { attribute: false },
		line: { attribute: false },
		label: { attribute: false },
		events: { attribute: false },
	};
	declare page: DerivationTrace | undefined;
	/** Whether another window is loading. */
	declare busy: boolean;
	declare chosen: number | undefined;
	declare pointed: number | undefined;
	/** Line of the production whose modules are marked. */
	declare line: number | undefined;
	declare label: string;
	declare events: StringEvents;

	/** Step and chosen module that were last scrolled into view. */
	#seen: readonly unknown[] = [];
	/** Module that keeps its place on the screen while the window is replaced. */
	#anchor: { readonly index: number; readonly top: number } | undefined;

	/** Renders into the element itself, so that the page's style applies. */
	protected override createRenderRoot(): this {
		return this;
	}

	/** Renders the modules of the loaded window as options of a list box. */
	protected override render(): unknown {
		const { page, chosen } = this;
		const active = page && chosen !== undefined && page.modules[chosen - page.first] ? `module-${chosen}` : nothing;
		return html`<div
			class="derived" role="listbox" tabindex="0" aria-label=${this.label} aria-busy=${this.busy} aria-orientation="horizontal"
			aria-activedescendant=${active} aria-describedby="derived-keys"
			@keydown=${this.#press} @click=${this.#click} @pointerover=${this.#over} @pointerleave=${() => this.events.point(undefined)} @scroll=${this.#scroll}
		>${page?.modules.map((module, index) => this.#module(module, page.first + index, page))}</div>`;
	}

	/** Draws one module of the string; classes mark how productions of the current line affect it. */
	#module(module: TraceEntry, index: number, { counts, step }: DerivationTrace): unknown {
		const { text, fires, production, answer } = module;
		const [symbol, parameters] = partsOfModule(text);
		const { line } = this;
		const classes = [
			"module",
			/^[[\]]$/.test(symbol) && "branch",
			fires && "fires",
			line !== undefined && fires?.line === line && "rewritten",
			line !== undefined && production?.line === line && "written",
			answer && "answered",
			index === this.pointed && "pointed",
		];
		return html`<span
			class=${classes.filter(Boolean).join(" ")} id="module-${index}" role="option" data-index=${index}
			aria-selected=${index === this.chosen} aria-posinset=${index + 1} aria-setsize=${counts[step]}
		>${symbol}${parameters ? html`<i>${parameters}</i>` : nothing}</span>`;
	}

	/**
	 * Restores the scroll position after more modules have been added before the visible ones, and scrolls to the chosen
	 * module once.
	 */
	protected override updated(changed: PropertyValues): void {
		const { page, chosen } = this;
		if (!page) return;
		if (changed.has("page") && this.#anchor) this.#restorePosition(this.#anchor);
		this.#anchor = undefined;
		const seen = [page.step, chosen];
		if (chosen === undefined || seen.every((each, index) => each === this.#seen[index])) return;
		const option = this.#option(chosen);
		if (!option) return;
		this.#seen = seen;
		option.scrollIntoView({ block: "nearest", inline: "nearest" });
	}

	/** The scrolling list. */
	get #list(): HTMLElement | null {
		return this.querySelector(".derived");
	}

	/** Returns the element of a module; null if the module is outside the window. */
	#option(index: number): HTMLElement | null {
		return this.querySelector(`[data-index="${index}"]`);
	}

	/**
	 * Scrolls so that a module is where it was before the window was replaced.
	 * @param top its former distance from the list's upper edge, CSS pixels
	 */
	#restorePosition({ index, top }: { readonly index: number; readonly top: number }): void {
		const [list, option] = [this.#list, this.#option(index)];
		if (list && option) list.scrollTop += option.offsetTop - list.scrollTop - top;
	}

	/**
	 * Requests modules before or behind the received ones when the list is scrolled near its end. The first visible
	 * module is noted, so that `updated` can restore its place.
	 */
	readonly #scroll = (): void => {
		const { page, busy } = this;
		const list = this.#list;
		if (!page || !list || busy) return;
		const { scrollTop, clientHeight, scrollHeight } = list;
		const before = scrollTop < NEAR && page.first > 0;
		const behind =
			scrollTop + clientHeight > scrollHeight - NEAR && page.first + page.modules.length < page.counts[page.step];
		if (!before && !behind) return;
		const inSight = [...list.querySelectorAll<HTMLElement>(".module")].find(
			({ offsetTop, offsetHeight }) => offsetTop + offsetHeight > scrollTop,
		);
		const index = Number(inSight?.dataset.index ?? page.first);
		this.#anchor = { index, top: (inSight?.offsetTop ?? 0) - scrollTop };
		this.events.look(index);
	};

	/** Returns the index of the module under an event; undefined between modules. */
	#indexAt(event: Event): number | undefined {
		const option = (event.target as Element).closest<HTMLElement>(".module");
		return option ? Number(option.dataset.index) : undefined;
	}

	/** Chooses the clicked module. */
	#click(event: Event): void {
		const index = this.#indexAt(event);
		if (index !== undefined) this.events.choose(index);
	}

	/** Reports the module under a mouse or a pen. */
	#over(event: PointerEvent): void {
		if (event.pointerType !== "touch") this.events.point(this.#indexAt(event));
	}

	/** Moves the selection in the string by arrow and page keys. */
	#press(event: KeyboardEvent): void {
		const { page, chosen, events } = this;
		if (!page || event.altKey || event.ctrlKey || event.metaKey) return;
		const last = page.counts[page.step] - 1;
		const from = chosen ?? -1;
		const to: Readonly<Record<string, number>> = {
			ArrowLeft: from - 1,
			ArrowRight: from + 1,
			PageUp: from - PAGE,
			PageDown: from + PAGE,
			Home: 0,
			End: last,
		};
		const next = to[event.key];
		if (next !== undefined) events.choose(Math.max(0, Math.min(next, last)));
		else if (event.key === "ArrowUp") events.up();
		else if (event.key === "ArrowDown") events.down();
		else if (event.key === "Enter") events.open();
		else return;
		event.preventDefault();
	}
}

customElements.define("panicle-derived", DerivedString);
