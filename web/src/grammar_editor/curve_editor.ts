import { html, LitElement, nothing, svg } from "lit";
import { formatCount } from "../ui/thousands";
import { added, type CurveFrame, type CurvePoint, frameOf, inText, moved, removed, valueAt } from "./curve";
import type { Curve } from "./outline";

/** Size of the drawing in its own units, and margin for the points. */
const WIDTH = 260;
const HEIGHT = 110;
const EDGE = 12;
const SAMPLES = 64;
/** Above this number of points, the curve is drawn without handles, and only its text can be edited. */
const MOST_POINTS = 100;
const KEYS: Readonly<Record<string, CurvePoint>> = {
	ArrowLeft: [-1, 0],
	ArrowRight: [1, 0],
	ArrowUp: [0, 1],
	ArrowDown: [0, -1],
};
/** Step of an arrow key, as a share of the frame; ten steps with Shift. */
const STEP = 0.01;

/** Editor of a curve: points are dragged, added by a double click and removed by Delete. */
export class CurveEditor extends LitElement {
	static override properties = {
		curve: { attribute: false },
		write: { attribute: false },
		settle: { attribute: false },
	};
	declare curve: Curve;
	/** Writes points into the text. */
	declare write: (name: string, points: string) => void;
	/** Ends the edit, so that the written points become one undo step. */
	declare settle: () => void;
	/** Frame during a drag, which stays constant. */
	#frame: CurveFrame | undefined;

	protected override createRenderRoot(): this {
		return this;
	}

	protected override render(): unknown {
		const { name, points } = this.curve;
		const frame = this.#framed;
		const [dx, dy] = [frame.right - frame.left, frame.high - frame.low];
		const x = (value: number) => EDGE + ((value - frame.left) / dx) * WIDTH;
		const y = (value: number) => EDGE + ((frame.high - value) / dy) * HEIGHT;
		const editable = points.length <= MOST_POINTS;
		const line = Array.from({ length: SAMPLES + 1 }, (_, index) => {
			const at = frame.left + (index / SAMPLES) * dx;
			return `${x(at).toFixed(1)},${y(valueAt(points, at)).toFixed(1)}`;
		}).join(" ");
		return html`<div class="curve" role="group" aria-label=${`Curve ${name}`}>
			<div class="curve-head">
				<span>${name}</span>
				${editable ? html`<button class="button quiet" type="button" @click=${this.#halve}>Add a point</button>` : nothing}
			</div>
			<svg viewBox="0 0 ${WIDTH + 2 * EDGE} ${HEIGHT + 2 * EDGE}" @dblclick=${editable ? this.#add : nothing}>
				<rect x=${EDGE} y=${EDGE} width=${WIDTH} height=${HEIGHT} />
				<polyline points=${line} />
				${(editable ? points : []).map(
					([px, py], at) => svg`<circle
						cx=${x(px)} cy=${y(py)} r="6" tabindex="0" role="slider" aria-label=${`CurvePoint ${at + 1} of ${points.length}`}
						aria-valuenow=${py} aria-valuemin=${frame.low} aria-valuemax=${frame.high} aria-valuetext=${`${px}, ${py}`}
						@pointerdown=${(event: PointerEvent) => this.#drag(event, at)} @keydown=${(event: KeyboardEvent) => this.#press(event, at)}
						@keyup=${this.settle} @blur=${this.settle}
					></circle>`,
				)}
			</svg>
			${
				editable
					? html`<p class="unseen">Arrow keys move a point, with Shift ten steps; Delete removes it.</p>`
					: html`<p>${formatCount(points.length)} points: edit them in the grammar’s text.</p>`
			}
		</div>`;
	}

	get #framed(): CurveFrame {
		return this.#frame ?? frameOf(this.curve.points);
	}

	#put(points: readonly CurvePoint[]): void {
		if (points !== this.curve.points) this.write(this.curve.name, inText(points, this.#framed));
	}

	#drag(event: PointerEvent, at: number): void {
		if (event.button !== 0) return;
		const circle = event.currentTarget as SVGElement;
		circle.setPointerCapture(event.pointerId);
		this.#frame = frameOf(this.curve.points);
		const ended = new AbortController();
		const { signal } = ended;
		const end = () => {
			ended.abort();
			this.#frame = undefined;
			this.settle();
			this.requestUpdate();
		};
		circle.addEventListener(
			"pointermove",
			(next) => this.#put(moved(this.curve.points, at, this.#pointAt(next), this.#framed)),
			{ signal },
		);
		circle.addEventListener("pointerup", end, { signal });
		circle.addEventListener("pointercancel", end, { signal });
	}

	#press(event: KeyboardEvent, at: number): void {
		const { points } = this.curve;
		const way = KEYS[event.key];
		if (way) {
			event.preventDefault();
			const { left, right, low, high } = this.#framed;
			const by = event.shiftKey ? 10 * STEP : STEP;
			const to = [points[at][0] + way[0] * by * (right - left), points[at][1] + way[1] * by * (high - low)] as const;
			this.#put(moved(points, at, to, this.#framed));
		} else if (event.key === "Delete" || event.key === "Backspace") {
			event.preventDefault();
			this.#put(removed(points, at));
			this.settle();
		}
	}

	#add(event: MouseEvent): void {
		this.#put(added(this.curve.points, this.#pointAt(event), this.#framed));
		this.settle();
	}

	/** Adds a point in the middle of the widest gap, for use without a pointer. */
	#halve(): void {
		const { points } = this.curve;
		const gaps = points.slice(1).map(([x], at) => x - points[at][0]);
		const at = gaps.indexOf(Math.max(...gaps));
		const x = points[at][0] + gaps[at] / 2;
		this.#put(added(points, [x, valueAt(points, x)], this.#framed));
		this.settle();
	}

	/** Returns a pointer's position in the curve's coordinates. */
	#pointAt({ clientX, clientY }: MouseEvent): CurvePoint {
		const { left, top, width, height } = (this.querySelector("svg") as SVGElement).getBoundingClientRect();
		const frame = this.#framed;
		const u = (((clientX - left) / width) * (WIDTH + 2 * EDGE) - EDGE) / WIDTH;
		const v = (((clientY - top) / height) * (HEIGHT + 2 * EDGE) - EDGE) / HEIGHT;
		return [frame.left + u * (frame.right - frame.left), frame.high - v * (frame.high - frame.low)];
	}
}

customElements.define("panicle-curve", CurveEditor);
