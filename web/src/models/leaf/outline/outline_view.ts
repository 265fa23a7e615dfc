/**
 * `<panicle-outline>`: a leaf's outline with its points, over the flat leaf. It draws its properties and dispatches
 * the user's edits as events; the page owns the document. A handle's name is the index of its point.
 */

import { html, nothing, type PropertyValues } from "lit";
import { HandleView } from "../../../ui/handles/handle_view";
import { drawScaleBar } from "../../../ui/handles/scale_bar";
import { drawValue, valueStyle } from "../../../ui/handles/value_label";
import { text } from "../messages.generated";
import { type FlatVeins, showOutline } from "./outline_canvas";
import { outlineDrags } from "./outline_drag";
import { inReach, inView, type OutlineFrame, onLeaf, scaleBar, steadyFrame } from "./outline_frame";
import { ADD, LOCK, REMOVE, TURN } from "./outline_icons";
import { outlineStyle } from "./outline_style";
import { kindInWords, placeInWords, pointInWords } from "./outline_words";
import type { OutlinePoints, Place, Symmetry } from "./points";
import { curveOf, nearestSpan } from "./spline";
import { inserted, pressed, removed, type Step, turned } from "./steps";

/** Largest distance of a double click from the margin and from a point's dot, CSS pixels. */
const MARGIN_REACH = 14;
const DOT_REACH = 7;

export class OutlineView extends HandleView<string> {
	static override styles = [...HandleView.styles, valueStyle, outlineStyle];
	static override properties = {
		points: { attribute: false },
		veins: { attribute: false },
		millimetres: { type: Number },
		mirror: { type: Boolean },
	};
	declare points: OutlinePoints | undefined;
	/** Veins of the last growth. */
	declare veins: FlatVeins | undefined;
	/** Length of the leaf. */
	declare millimetres: number;
	/** Whether both sides move together. */
	declare mirror: boolean;

	protected readonly heading = text("outline");
	protected readonly help = text("outline_help");
	#frame: OutlineFrame | undefined;
	#chosen = 1;
	protected readonly drags = outlineDrags({
		get: () => this.points ?? [],
		symmetry: () => this,
		reach: (to) => (this.#frame ? inReach(this.#frame, to) : to),
		input: (points) => this.#showEdit(points),
		change: () => this.emit("outline-change"),
		refused: () => this.#refuse(),
	});

	constructor() {
		super();
		this.millimetres = 100;
		this.mirror = true;
	}

	/** Before rendering: cancels a drag whose point no longer exists, and fits the frame to the outline. */
	protected override willUpdate(changed: PropertyValues<this>): void {
		const before = changed.get("points");
		// Another action has changed the number of points, so the dragged index means another point.
		if (this.drags.active && before && before.length !== this.points?.length) this.drop();
		if (!this.points) return;
		this.#chosen = Math.min(Math.max(this.#chosen, 1), this.points.length - 1);
		this.#frame = steadyFrame(this.#frame, curveOf(this.points), this.size, this.drags.active);
	}

	/** Renders the scale, the handles of the points, and the position of the shown one. */
	protected inside(): unknown {
		const { points } = this;
		if (!points || !this.#frame) return undefined;
		const bar = scaleBar(this.#frame, this.millimetres);
		const corner = `translate(8 ${this.#frame.height - 5})`;
		return html`<svg class="drawing" aria-hidden="true">${drawScaleBar(bar.length, bar.label, corner)}</svg>
			${this.places().map(([index, place]) => {
				const at = Number(index);
				return this.drawHandle(index, place, {
					label: pointInWords(points, at),
					kind: points[at].kind,
					classes: { chosen: at === this.#chosen },
					tab: at === this.#chosen,
				});
			})}
			${this.places().map(([index, place]) => this.#drawValue(index, place))}`;
	}

	/** Renders a point's position beside it while it is pointed at or dragged, placed so that it hides no other point. */
	#drawValue(index: string, place: Place): unknown {
		const point = this.points?.[Number(index)];
		if (!point || (index !== this.shown && !this.drags.holds(index))) return undefined;
		const others = this.places().filter(([other]) => other !== index);
		return drawValue(
			placeInWords(point),
			place,
			this.size,
			others.map(([, at]) => at),
		);
	}

	/** Renders the bar of buttons below the drawing: symmetry, kind of the point, add, remove. */
	protected override below(): unknown {
		const kind = this.points?.[this.#chosen].kind ?? "smooth";
		return html`<div class="bar" role="toolbar" aria-label=${text("toolbar")}>
			${this.#button(LOCK, text("mirror"), () => this.emit("outline-mirror"), this.mirror)}
			${this.#button(TURN, text("kind_button", { kind: kindInWords(kind) }), () => this.#applyEdit(turned))}
			${this.#button(ADD, text("add_button"), () => this.#applyEdit(inserted))}
			${this.#button(REMOVE, text("remove_button"), () => this.#applyEdit(removed))}
		</div>`;
	}

	/**
	 * Renders a button with a drawing.
	 * @param pressed state of a button that toggles; absent for other buttons
	 */
	#button(drawing: unknown, label: string, click: () => void, pressed?: boolean) {
		return html`<button
			type="button" aria-label=${label} title=${label} aria-pressed=${pressed ?? nothing} @click=${click}
		>${drawing}</button>`;
	}

	/** Draws the leaf on the canvas below the handles. */
	protected override ink(canvas: HTMLCanvasElement): void {
		const { points, veins } = this;
		if (points && this.#frame) showOutline(canvas, { curve: curveOf(points), veins, frame: this.#frame });
	}

	/** Returns the positions of all handles, by name. Point 0, the base at the petiole, has none. */
	protected places(): [string, Place][] {
		const frame = this.#frame;
		const all = (this.points ?? []).map((point, i): [string, Place] => [`${i}`, frame ? inView(frame, point) : point]);
		return all.slice(1);
	}

	/** Converts a position in CSS pixels to leaf lengths. */
	protected units(at: Place): Place {
		return this.#frame ? onLeaf(this.#frame, at) : at;
	}

	/** Describes a point in words, for screen readers. */
	protected describe(index: string): string {
		return pointInWords(this.points ?? [], Number(index));
	}

	/** Applies the edit of a pressed key to the chosen point; returns whether the key causes one. */
	protected key(_: string, event: KeyboardEvent): boolean {
		const step = this.points && !event.altKey && pressed(this.points, this.#chosen, event, this);
		if (!step) return false;
		event.stopPropagation();
		this.#applyStep(step);
		// Focuses the chosen point.
		void this.updateComplete.then(() => this.element(`${this.#chosen}`)?.focus({ preventScroll: true }));
		return true;
	}

	/** Handles a double click: on a point's dot it changes the point's kind, on the margin it adds a point. */
	protected doubled(index: string | undefined, at: Place): void {
		if (!this.points || !this.#frame) return;
		const place = index === undefined ? undefined : inView(this.#frame, this.points[Number(index)]);
		const margin = nearestSpan(this.points, onLeaf(this.#frame, at));
		if (place && Math.hypot(place.x - at.x, place.y - at.y) <= DOT_REACH) this.#applyEdit(turned);
		else if (margin.distance * this.#frame.scale <= MARGIN_REACH)
			this.#applyStep(inserted(this.points, margin.span, this, onLeaf(this.#frame, at)));
	}

	/** Chooses the point whose handle receives the focus. */
	protected override focused(index: string): void {
		this.#chosen = Number(index);
		this.requestUpdate();
	}

	/** Shows an outline while it is edited, and reports it to the page. */
	#showEdit(outline: OutlinePoints): void {
		this.points = outline;
		this.emit("outline-input", { outline });
	}

	/** Reports that an edit was refused because the outline would have crossed itself. */
	#refuse(): void {
		this.announce(text("would_cross"));
		this.emit("outline-refused");
	}

	/** Applies an edit by key or button, dispatches events and announces its message. */
	#applyStep({ points, chosen, message }: Step): void {
		if (points) {
			this.#showEdit(points);
			this.emit("outline-change");
		}
		if (message === text("would_cross")) this.#refuse();
		else if (message) this.announce(message);
		if (chosen !== undefined) this.#chosen = chosen;
		this.requestUpdate();
	}

	/** Applies an edit (steps.ts) to the chosen point. */
	#applyEdit(step: (points: OutlinePoints, chosen: number, symmetry: Symmetry) => Step): void {
		if (this.points) this.#applyStep(step(this.points, this.#chosen, this));
	}
}

customElements.define("panicle-outline", OutlineView);
