import { html, LitElement, nothing, svg } from "lit";
import { added, type CurveFrame, type CurvePoint, frameOf, inText, moved, removed, valueAt } from "./curve";
import { text } from "./messages.generated";
import type { Curve } from "./outline";

/** Size of the drawing in its own units, and margin for the points. */
const WIDTH = 260;
const HEIGHT = 110;
const EDGE = 12;
const SAMPLES = 64;
/** Above this number of points, the curve is drawn without handles, and only its text can be edited. */
const MAX_POINTS = 100;
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

	/** Renders into the element itself, so that the page's style applies. */
	protected override createRenderRoot(): this {
		return this;
	}

	/** Renders the curve with draggable points; a curve with more than MAX_POINTS points can only be seen. */
	protected override render(): unknown {
		const { name, points } = this.curve;
		const frame = this.#framed;
		const [dx, dy] = [frame.right - frame.left, frame.high - frame.low];
		const x = (value: number) => EDGE + ((value - frame.left) / dx) * WIDTH;
		const y = (value: number) => EDGE + ((frame.high - value) / dy) * HEIGHT;
		const editable = points.length <= MAX_POINTS;
		const line = Array.from({ length: SAMPLES + 1 }, (_, index) => {
			const at = frame.left + (index / SAMPLES) * dx;
			return `${x(at).toFixed(1)},${y(valueAt(points, at)).toFixed(1)}`;
		}).join(" ");
		return html`<div class="curve" role="group" aria-label=${text("curve", { name })}>
			<div class="curve-head">
				<span>${name}</span>
				${editable ? html`<button class="button quiet" type="button" @click=${this.#halve}>${text("curve_add")}</button>` : nothing}
			</div>
			<svg viewBox="0 0 ${WIDTH + 2 * EDGE} ${HEIGHT + 2 * EDGE}" @dblclick=${editable ? this.#add : nothing}>
				<rect x=${EDGE} y=${EDGE} width=${WIDTH} height=${HEIGHT} />
				<polyline points=${line} />
				${(editable ? points : []).map(
					([px, py], at) => svg`<circle
						cx=${x(px)} cy=${y(py)} r="6" tabindex="0" role="slider" aria-label=${text("curve_point", { number: at + 1, count: points.length })}
						aria-valuenow=${py} aria-valuemin=${frame.low} aria-valuemax=${frame.high} aria-valuetext=${`${px}, ${py}`}
						@pointerdown=${(event: PointerEvent) => this.#drag(event, at)} @keydown=${(event: KeyboardEvent) => this.#press(event, at)}
						@keyup=${this.settle} @blur=${this.settle}
					></circle>`,
				)}
			</svg>
			${
				editable
					? html`<p class="unseen">${text("curve_keys")}</p>`
					: html`<p>${text("curve_long", { count: points.length })}</p>`
			}
		</div>`;
	}

	/** The range of the drawing: fixed during a drag, else that of the points. */
	get #framed(): CurveFrame {
		return this.#frame ?? frameOf(this.curve.points);
	}

	/** Writes changed points into the text. */
	#writePoints(points: readonly CurvePoint[]): void {
		if (points !== this.curve.points) this.write(this.curve.name, inText(points, this.#framed));
	}

	/** Drags the point of an index; the view keeps its scale until the pointer is released. */
	#drag(event: PointerEvent, index: number): void {
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
			(next) => this.#writePoints(moved(this.curve.points, index, this.#pointAt(next), this.#framed)),
			{ signal },
		);
		circle.addEventListener("pointerup", end, { signal });
		circle.addEventListener("pointercancel", end, { signal });
	}

	/** Handles a key on the point of an index: arrows move it, Delete and Backspace remove it. */
	#press(event: KeyboardEvent, index: number): void {
		const { points } = this.curve;
		const way = KEYS[event.key];
		if (way) {
			event.preventDefault();
			const { left, right, low, high } = this.#framed;
			const by = event.shiftKey ? 10 * STEP : STEP;
			const to = [
				points[index][0] + way[0] * by * (right - left),
				points[index][1] + way[1] * by * (high - low),
			] as const;
			this.#writePoints(moved(points, index, to, this.#framed));
		} else if (event.key === "Delete" || event.key === "Backspace") {
			event.preventDefault();
			this.#writePoints(removed(points, index));
			this.settle();
		}
	}

	/** Adds a point where the drawing was clicked twice. */
	#add(event: MouseEvent): void {
		this.#writePoints(added(this.curve.points, this.#pointAt(event), this.#framed));
		this.settle();
	}

	/** Adds a point in the middle of the widest gap, for use without a pointer. */
	#halve(): void {
		const { points } = this.curve;
		const gaps = points.slice(1).map(([x], at) => x - points[at][0]);
		const at = gaps.indexOf(Math.max(...gaps));
		const x = points[at][0] + gaps[at] / 2;
		this.#writePoints(added(points, [x, valueAt(points, x)], this.#framed));
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
