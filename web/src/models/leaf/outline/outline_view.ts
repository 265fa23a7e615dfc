/**
 * `<panicle-outline>`: a leaf's outline with its points, over the flat leaf. It draws what it is given and tells what a
 * person does to it; the document stays with the page. A handle's name is the point's number.
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

/** Within so many CSS pixels a double click means the margin, or a point's dot. */
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
	/** Of the last growth. */
	declare veins: FlatVeins | undefined;
	/** How long the leaf is. */
	declare millimetres: number;
	/** Whether both sides move as one. */
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
		// Others have changed it meanwhile: what is held is another point now.
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

	/** The base, point 0, is where the petiole joins: it stays. */
	protected places(): [string, Place][] {
		const frame = this.#frame;
		const all = (this.points ?? []).map((point, i): [string, Place] => [`${i}`, frame ? inView(frame, point) : point]);
		return all.slice(1);
	}

	/** Lengths of the leaf. */
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
		// The chosen point takes the focus.
		void this.updateComplete.then(() => this.element(`${this.#chosen}`)?.focus({ preventScroll: true }));
		return true;
	}

	/** On a point's dot it changes the kind, on the margin it puts a point in. */
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

	/** A step of keys or buttons is told and said. */
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
