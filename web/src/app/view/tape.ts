/** The measuring tape: two clicks on the plant in the 3-D view measure the distance between two of its points. */
import { html, nothing, render, svg } from "lit";
import { PickPointer } from "../../ui/pick_pointer";
import { takeFocus } from "../../ui/take_focus";
import type { SolidView } from "../solid_view";
import type { Studio } from "../studio";
import type { ShownPlant } from "../studio_state";
import { type Extents, extentsOf } from "./extents";
import { formatLength } from "./length";
import { text } from "./messages.generated";

type Point = readonly [x: number, y: number, z: number];

/** Largest distance of a click from the plant, CSS pixels. */
const MOUSE_REACH = 4;
const TOUCH_REACH = 12;

export class Tape {
	readonly #view: SolidView;
	readonly #studio: Studio;
	readonly #place: HTMLElement;
	readonly #pointer: PickPointer<Readonly<{ x: number; y: number }>>;
	readonly #touch = matchMedia("(pointer: coarse)").matches;
	readonly #lifetime = new AbortController();
	readonly #leave: (() => void)[];
	/** The ends of the tape that are set, at most two, in the plant's metres. */
	#points: readonly Point[] = [];
	#shown: ShownPlant["grown"] | undefined;
	#extents: Extents | undefined;
	#measuring: ReturnType<typeof setTimeout> | undefined;

	/** @param place empty live region over the canvas */
	constructor(place: HTMLElement, view: SolidView, studio: Studio) {
		this.#place = place;
		this.#view = view;
		this.#studio = studio;
		// A plant that sways has no fixed lengths, and clicks measure instead of choosing parts.
		view.wind = false;
		view.picksParts = false;
		this.#pointer = new PickPointer(view, {
			name: "measuring",
			hovers: false,
			at: (x, y) => ({ x, y }),
			mark: () => {},
			take: ({ x, y }) => void this.#setPoint(x, y),
		});
		this.#pointer.enabled = true;
		this.#leave = [view.onDrawn(() => this.#draw()), studio.subscribe(() => this.#follow())];
		window.addEventListener("keydown", (event) => this.#press(event), this.#lifetime);
		this.#follow();
	}

	dispose(): void {
		clearTimeout(this.#measuring);
		this.#lifetime.abort();
		for (const leave of this.#leave) leave();
		this.#pointer.dispose();
		this.#view.picksParts = true;
		const hadFocus = this.#place.contains(document.activeElement);
		render(nothing, this.#place);
		if (hadFocus) takeFocus(this.#view.canvas, ".stage-chip");
	}

	/** Sets the next end; a third one begins a new distance. */
	async #setPoint(x: number, y: number): Promise<void> {
		const grown = this.#shown;
		const point = await this.#view.surfaceAt(x, y, this.#touch ? TOUCH_REACH : MOUSE_REACH);
		if (!point || grown !== this.#shown || this.#lifetime.signal.aborted) return;
		this.#points = this.#points.length === 1 ? [this.#points[0], point] : [point];
		this.#draw();
	}

	/** Escape removes the points; without points, it puts the tape away. */
	#press(event: KeyboardEvent): void {
		if (event.key !== "Escape" || event.defaultPrevented || !isFree(event)) return;
		event.preventDefault();
		if (this.#points.length === 0) {
			this.#studio.setAid(undefined);
			return;
		}
		this.#points = [];
		this.#draw();
	}

	/** Another plant has other points and another size, which is computed when the plant is at rest. */
	#follow(): void {
		const { shown, held } = this.#studio.state;
		if (shown?.grown !== this.#shown) {
			this.#points = [];
			this.#extents = undefined;
			this.#shown = shown?.grown;
			clearTimeout(this.#measuring);
			this.#measuring = undefined;
			this.#draw();
		}
		if (!shown || held || this.#extents || this.#measuring !== undefined) return;
		this.#measuring = setTimeout(() => {
			this.#extents = extentsOf(shown.model.parts(shown.grown, shown.from));
			this.#draw();
		});
	}

	#draw(): void {
		render([this.#drawLine(), this.#drawChip()], this.#place);
	}

	/** Draws the tape between its ends, for the eye alone: the chip has the length as text. */
	#drawLine(): unknown {
		const { offsetLeft, offsetTop } = this.#view.canvas;
		const ends = this.#points.map((point) => {
			const { x, y } = this.#view.project(point);
			return { x: x + offsetLeft, y: y + offsetTop };
		});
		const [from, to] = ends;
		return html`<svg class="tape-line" aria-hidden="true">
			${from && to ? ["halo", "line"].map((name) => svg`<line class=${name} x1=${from.x} y1=${from.y} x2=${to.x} y2=${to.y}></line>`) : nothing}
			${ends.map(({ x, y }) => svg`<circle cx=${x} cy=${y} r="5"></circle>`)}
			${from && to ? svg`<text x=${(from.x + to.x) / 2} y=${(from.y + to.y) / 2 - 10} text-anchor="middle">${this.#length}</text>` : nothing}
		</svg>`;
	}

	#drawChip(): unknown {
		const input = this.#touch ? "touch" : "mouse";
		const words = [
			() => text("tape_first", { input }),
			() => text("tape_second", { input }),
			() => text("tape_distance", { length: this.#length }),
		];
		const title = text("tape_close");
		return html`<div class="stage-chip tape" role="group" aria-label=${text("tape")}>
			<div>
				<p>${words[this.#points.length]()}</p>
				${this.#extents ? html`<p><small>${wholeInWords(this.#extents)}</small></p>` : nothing}
			</div>
			<button class="button icon quiet" type="button" aria-label=${title} title=${title} @click=${() => this.#studio.setAid(undefined)}
			><span aria-hidden="true">×</span></button>
		</div>`;
	}

	/** The distance between the two ends. */
	get #length(): string {
		const [[x, y, z], [toX, toY, toZ]] = this.#points;
		return formatLength(Math.hypot(toX - x, toY - y, toZ - z));
	}
}

const wholeInWords = ({ width, height, depth }: Extents): string =>
	text("tape_whole", { height: formatLength(height), width: formatLength(width), depth: formatLength(depth) });

/** Whether Escape is free for the tape: not in a dialog or a text field. */
function isFree({ target }: KeyboardEvent): boolean {
	if (document.querySelector("dialog[open]")) return false;
	return !(target as Partial<Element> | null)?.closest?.("input, select, textarea, [contenteditable]");
}
