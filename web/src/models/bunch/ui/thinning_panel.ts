import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { ControlElement } from "../../../ui/control_element";
import { icon } from "../../../ui/icons";
import type { Berries, BunchPlant } from "../bunch_plant";
import { fromTheTop, placeInWords, widthInWords } from "./berry_places";
import type { BunchContext } from "./context";
import { THIN } from "./icons";
import { mark, putBack, takeOff, thinning } from "./thinning";

/**
 * Panel for thinning without a pointer: a slider goes from berry to berry, from the top of the bunch down, and the
 * view highlights the berry; Delete or the button removes it.
 */
export class Thinning extends ControlElement<BunchContext> {
	#orderOf: Berries | undefined;
	#order: number[] = [];
	/** Last position of the slider, which stays when its berry is removed. */
	#at = 0;

	protected override draw(context: BunchContext): unknown {
		const { grown, specimen } = context.state;
		const { marked } = context.toolState(thinning);
		if (!grown || grown.berries.count === 0) return nothing;
		this.#follow(grown, marked);
		const berry = marked === undefined ? undefined : this.#order[this.#at];
		const words = berry === undefined ? "No berry is marked" : described(grown.berries, this.#at, berry);
		const removed = specimen.thinned.length;
		return html`<h3>Thinning by hand</h3>
			<div class="thinning">
				<label for=${this.idOf("slide")}>Berry</label>
				<input
					type="range" id=${this.idOf("slide")} min="1" max=${grown.berries.count} step="1" .value=${live(String(this.#at + 1))}
					aria-valuetext=${words} aria-describedby=${this.idOf("help")} aria-keyshortcuts="Delete"
					@input=${this.#slide} @focus=${() => this.#mark(this.#at)} @keydown=${this.#keyDown}
				>
				<p class="marked">${words}</p>
				<span class="unseen" id=${this.idOf("help")}>Arrow keys go from berry to berry, from the top down; Delete takes it off. 1 … ${grown.berries.count}.</span>
			</div>
			<div class="actions">
				<button class="button" type="button" ?disabled=${berry === undefined} @click=${this.#remove}>${icon(THIN)}Remove</button>
				<button class="button" type="button" ?disabled=${removed === 0} @click=${() => putBack(context)}>Put all back</button>
				<span class="removed" role="status">${removed === 0 ? "None removed" : `${removed} removed`}</span>
			</div>`;
	}

	protected override updated(): void {
		const { grown } = this.context.state;
		const share = grown && grown.berries.count > 1 ? this.#at / (grown.berries.count - 1) : 0;
		this.querySelector<HTMLElement>("input[type=range]")?.style.setProperty("--done", `${share * 100}%`);
	}

	override connectedCallback(): void {
		super.connectedCallback();
		this.addEventListener("focusout", this.#left);
	}

	/**
	 * Removes the highlight when the focus moves elsewhere; if it moves nowhere, a press on a button may have taken
	 * it.
	 */
	readonly #left = ({ relatedTarget }: FocusEvent): void => {
		if (relatedTarget instanceof Node && !this.contains(relatedTarget)) mark(this.context, undefined);
	};

	/** Updates the order and the slider's position from the grown berries and the highlight. */
	#follow({ berries }: BunchPlant, marked: number | undefined): void {
		if (berries !== this.#orderOf) {
			this.#orderOf = berries;
			this.#order = fromTheTop(berries);
		}
		const at = marked === undefined ? -1 : this.#order.findIndex((berry) => berries.ids[berry] === marked);
		this.#at = Math.min(at < 0 ? this.#at : at, this.#order.length - 1);
	}

	#idAt(place: number): number | undefined {
		return this.#orderOf?.ids[this.#order[place]];
	}

	#mark(place: number): void {
		this.#at = place;
		mark(this.context, this.#idAt(place));
	}

	#slide(event: Event): void {
		this.#mark(Number((event.target as HTMLInputElement).value) - 1);
	}

	#keyDown(event: KeyboardEvent): void {
		if (event.key === "Escape") mark(this.context, undefined);
		if (event.key !== "Delete" && event.key !== "Backspace") return;
		event.preventDefault();
		this.#remove();
	}

	readonly #remove = (): void => {
		const id = this.#idAt(this.#at);
		const next = this.#idAt(this.#at + 1) ?? this.#idAt(this.#at - 1);
		if (id !== undefined) takeOff(this.context, id, next);
	};
}

/** Describes a berry: "Berry 12 of 143, at the top, front left, 18 mm". */
function described(berries: Berries, place: number, berry: number): string {
	return `Berry ${place + 1} of ${berries.count}, ${placeInWords(berries, berry)}, ${widthInWords(berries, berry)}`;
}

customElements.define("panicle-thinning", Thinning);
