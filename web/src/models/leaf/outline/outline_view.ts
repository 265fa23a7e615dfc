/**
 * `<panicle-outline>`: a leaf's outline with its points, over the flat leaf. It draws its properties and dispatches
 * the user's edits as events; the page owns the document. A handle's name is the index of its point.
 */
import { html, nothing, type PropertyValues } from "lit";
import { HandleView } from "../../../ui/handles/handle_view";
import { drawScaleBar } from "../../../ui/handles/scale_bar";
import { drawValue, valueStyle } from "../../../ui/handles/value_label";
import { type FlatVeins, showOutline } from "./outline_canvas";
import { outlineDrags } from "./outline_drag";
import { inReach, inView, type OutlineFrame, onLeaf, scaleBar, steadyFrame } from "./outline_frame";
import { ADD, LOCK, REMOVE, TURN } from "./outline_icons";
import { outlineStyle } from "./outline_style";
import { CROSSES, HELP, KIND_WORDS, placeInWords, pointInWords } from "./outline_words";
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

	protected readonly heading = "Outline";
	protected readonly help = HELP;
	#frame: OutlineFrame | undefined;
	#chosen = 1;
	protected readonly drags = outlineDrags({
		get: () => this.points ?? [],
		symmetry: () => this,
		reach: (to) => (this.#frame ? inReach(this.#frame, to) : to),
		input: (points) => this.#input(points),
		change: () => this.emit("outline-change"),
		refused: () => this.#refuse(),
	});

	constructor() {
		super();
		this.millimetres = 100;
		this.mirror = true;
	}

	protected override willUpdate(changed: PropertyValues<this>): void {
		const before = changed.get("points");
		// Another action has changed the number of points, so the dragged index means another point.
		if (this.drags.active && before && before.length !== this.points?.length) this.drop();
		if (!this.points) return;
		this.#chosen = Math.min(Math.max(this.#chosen, 1), this.points.length - 1);
		this.#frame = steadyFrame(this.#frame, curveOf(this.points), this.size, this.drags.active);
	}

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

	protected override below(): unknown {
		const kind = this.points?.[this.#chosen].kind ?? "smooth";
		return html`<div class="bar" role="toolbar" aria-label="Points of the outline">
			${this.#button(LOCK, "Both sides alike", () => this.emit("outline-mirror"), this.mirror)}
			${this.#button(TURN, `Kind of point, now ${KIND_WORDS[kind]}`, () => this.#press(turned))}
			${this.#button(ADD, "Add a point after the chosen one", () => this.#press(inserted))}
			${this.#button(REMOVE, "Remove the chosen point", () => this.#press(removed))}
		</div>`;
	}

	#button(drawing: unknown, label: string, click: () => void, pressed?: boolean) {
		return html`<button
			type="button" aria-label=${label} title=${label} aria-pressed=${pressed ?? nothing} @click=${click}
		>${drawing}</button>`;
	}

	protected override ink(canvas: HTMLCanvasElement): void {
		const { points, veins } = this;
		if (points && this.#frame) showOutline(canvas, { curve: curveOf(points), veins, frame: this.#frame });
	}

	/** Positions of all handles. Point 0, the base at the petiole, has none. */
	protected places(): [string, Place][] {
		const frame = this.#frame;
		const all = (this.points ?? []).map((point, i): [string, Place] => [`${i}`, frame ? inView(frame, point) : point]);
		return all.slice(1);
	}

	/** Maps CSS pixels to leaf lengths. */
	protected units(at: Place): Place {
		return this.#frame ? onLeaf(this.#frame, at) : at;
	}

	protected words(index: string): string {
		return pointInWords(this.points ?? [], Number(index));
	}

	protected key(_: string, event: KeyboardEvent): boolean {
		const step = this.points && !event.altKey && pressed(this.points, this.#chosen, event, this);
		if (!step) return false;
		event.stopPropagation();
		this.#take(step);
		// Focuses the chosen point.
		void this.updateComplete.then(() => this.element(`${this.#chosen}`)?.focus({ preventScroll: true }));
		return true;
	}

	/** A double click on a point's dot changes its kind, on the margin it adds a point. */
	protected doubled(index: string | undefined, at: Place): void {
		if (!this.points || !this.#frame) return;
		const place = index === undefined ? undefined : inView(this.#frame, this.points[Number(index)]);
		const margin = nearestSpan(this.points, onLeaf(this.#frame, at));
		if (place && Math.hypot(place.x - at.x, place.y - at.y) <= DOT_REACH) this.#press(turned);
		else if (margin.distance * this.#frame.scale <= MARGIN_REACH)
			this.#take(inserted(this.points, margin.span, this, onLeaf(this.#frame, at)));
	}

	protected override focused(index: string): void {
		this.#chosen = Number(index);
		this.requestUpdate();
	}

	#input(outline: OutlinePoints): void {
		this.points = outline;
		this.emit("outline-input", { outline });
	}

	#refuse(): void {
		this.announce(CROSSES);
		this.emit("outline-refused");
	}

	/** Applies an edit by key or button, dispatches events and announces its message. */
	#take({ points, chosen, message }: Step): void {
		if (points) {
			this.#input(points);
			this.emit("outline-change");
		}
		if (message === CROSSES) this.#refuse();
		else if (message) this.announce(message);
		if (chosen !== undefined) this.#chosen = chosen;
		this.requestUpdate();
	}

	#press(step: (points: OutlinePoints, chosen: number, symmetry: Symmetry) => Step): void {
		if (this.points) this.#take(step(this.points, this.#chosen, this));
	}
}

customElements.define("panicle-outline", OutlineView);
