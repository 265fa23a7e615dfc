import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { ControlElement } from "../../../ui/control_element";
import { icon } from "../../../ui/icons";
import type { Berries, BunchPlant } from "../bunch_plant";
import { text } from "../messages.generated";
import { fromTheTop, placeInWords, roundedWidth } from "./berry_places";
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
	#position = 0;

	/**
	 * Renders a slider that goes from berry to berry, for users without a pointer, and buttons to remove and restore
	 * berries.
	 */
	protected override draw(context: BunchContext): unknown {
		const { grown, specimen } = context.state;
		const { marked } = context.toolState(thinning);
		if (!grown || grown.berries.count === 0) return nothing;
		this.#follow(grown, marked);
		const berry = marked === undefined ? undefined : this.#order[this.#position];
		const words = berry === undefined ? text("no_berry_selected") : describeBerry(grown.berries, this.#position, berry);
		const removed = specimen.thinned.length;
		return html`<h3>${text("thinning")}</h3>
			<div class="thinning">
				<label for=${this.idOf("slide")}>${text("berry")}</label>
				<input
					type="range" id=${this.idOf("slide")} min="1" max=${grown.berries.count} step="1" .value=${live(String(this.#position + 1))}
					aria-valuetext=${words} aria-describedby=${this.idOf("help")} aria-keyshortcuts="Delete"
					@input=${this.#slide} @focus=${() => this.#highlightAt(this.#position)} @keydown=${this.#keyDown}
				>
				<p class="marked">${words}</p>
				<span class="unseen" id=${this.idOf("help")}>${text("thinning_help", { count: grown.berries.count })}</span>
			</div>
			<div class="actions">
				<button class="button" type="button" ?disabled=${berry === undefined} @click=${this.#remove}>${icon(THIN)}${text("remove")}</button>
				<button class="button" type="button" ?disabled=${removed === 0} @click=${() => putBack(context)}>${text("restore_all")}</button>
				<span class="removed" role="status">${text("removed", { count: removed })}</span>
			</div>`;
	}

	/** Colours the part of the slider left of its position. */
	protected override updated(): void {
		const { grown } = this.context.state;
		const share = grown && grown.berries.count > 1 ? this.#position / (grown.berries.count - 1) : 0;
		this.querySelector<HTMLElement>("input[type=range]")?.style.setProperty("--done", `${share * 100}%`);
	}

	/** Starts to listen for a change of focus. */
	override connectedCallback(): void {
		super.connectedCallback();
		this.addEventListener("focusout", this.#focusLeft);
	}

	/**
	 * Removes the highlight when the focus moves elsewhere; if it moves nowhere, a press on a button may have taken
	 * it.
	 */
	readonly #focusLeft = ({ relatedTarget }: FocusEvent): void => {
		if (relatedTarget instanceof Node && !this.contains(relatedTarget)) mark(this.context, undefined);
	};

	/** Updates the order and the slider's position from the grown berries and the highlight. */
	#follow({ berries }: BunchPlant, marked: number | undefined): void {
		if (berries !== this.#orderOf) {
			this.#orderOf = berries;
			this.#order = fromTheTop(berries);
		}
		const at = marked === undefined ? -1 : this.#order.findIndex((berry) => berries.ids[berry] === marked);
		this.#position = Math.min(at < 0 ? this.#position : at, this.#order.length - 1);
	}

	/** Returns the id of the berry at a position of the slider, from 0; undefined beyond its ends. */
	#idAt(place: number): number | undefined {
		return this.#orderOf?.ids[this.#order[place]];
	}

	/** Moves the slider to a position and highlights its berry. */
	#highlightAt(place: number): void {
		this.#position = place;
		mark(this.context, this.#idAt(place));
	}

	/** Highlights the berry at which the slider has been moved. */
	#slide(event: Event): void {
		this.#highlightAt(Number((event.target as HTMLInputElement).value) - 1);
	}

	/** Removes the berry on Delete or Backspace; Escape removes the highlight. */
	#keyDown(event: KeyboardEvent): void {
		if (event.key === "Escape") mark(this.context, undefined);
		if (event.key !== "Delete" && event.key !== "Backspace") return;
		event.preventDefault();
		this.#remove();
	}

	/** Removes the berry at the slider and highlights the next one, or the one before if it was the last. */
	readonly #remove = (): void => {
		const id = this.#idAt(this.#position);
		const next = this.#idAt(this.#position + 1) ?? this.#idAt(this.#position - 1);
		if (id !== undefined) takeOff(this.context, id, next);
	};
}

/**
 * Describes a berry: "Berry 12 of 143, at the top, front left, 18 mm".
 * @param place position of the slider, from 0
 * @param berry index of the berry
 */
function describeBerry(berries: Berries, place: number, berry: number): string {
	return text("berry_described", {
		number: place + 1,
		count: berries.count,
		place: placeInWords(berries, berry),
		width: roundedWidth(berries, berry),
	});
}

customElements.define("panicle-thinning", Thinning);
