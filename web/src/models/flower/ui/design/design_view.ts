/**
 * `<panicle-flower-design>`: one flat view of a designed flower with its handles. It draws a scene and reports changes
 * as events.
 */

import { html, svg } from "lit";
import { classMap } from "lit/directives/class-map.js";
import { DragSession } from "../../../../ui/handles/drag_session";
import { HandleView } from "../../../../ui/handles/handle_view";
import type { Point } from "../../../../ui/handles/point";
import { drawValue, valueStyle } from "../../../../ui/handles/value_label";
import type { Description } from "../../design/description";
import { text } from "../../messages.generated";
import { designStyle } from "./design_style";
import type { Scene, SceneHandle } from "./scene";

/**
 * `design-input`: live; carries the changed descriptions. `design-change`: a drag ended, or a key made a step.
 * `design-focus`: a handle got the focus; its id begins with its organ's name.
 */
export type DesignEvent = CustomEvent<{ descriptions: readonly Description[]; run?: string }>;

declare global {
	interface HTMLElementEventMap {
		"design-input": DesignEvent;
		"design-change": CustomEvent;
		"design-focus": CustomEvent<string>;
	}
}

const MARGIN = 12;

export class DesignView extends HandleView<string> {
	static override styles = [...HandleView.styles, valueStyle, designStyle];
	static override properties = {
		heading: { type: String },
		descriptions: { attribute: false },
		of: { attribute: false },
	};
	declare heading: string;
	/** Descriptions of all organs. */
	declare descriptions: readonly Description[] | undefined;
	/** Returns the scene of given descriptions. */
	declare of: ((descriptions: readonly Description[]) => Scene) | undefined;

	protected readonly help = text("handle_help");
	#scene: Scene | undefined;
	#scale = 1;
	#middle: Point = { x: 0, y: 0 };
	#chosen: string | undefined;
	protected readonly drags = new DragSession<string, readonly Description[]>({
		get: () => this.descriptions ?? [],
		place: (id) => this.#handle(id)?.at ?? { x: 0, y: 0 },
		pull: (descriptions, id, to) => {
			const handle = this.of?.(descriptions).handles.find((each) => each.id === id);
			return handle ? withDescription(descriptions, handle.pull(to)) : descriptions;
		},
		same: (one, other) => one === other,
		input: (descriptions) => this.#input(descriptions),
		change: () => this.emit("design-change"),
	});

	constructor() {
		super();
		this.heading = "";
	}

	/** Fits the scene into the view, and chooses the handle that is a stop of the Tab key. */
	protected override willUpdate(): void {
		if (!this.descriptions || !this.of) return;
		this.#scene = this.of(this.descriptions);
		// The view does not rescale during a drag, so that the handle stays under the pointer.
		if (this.drags.active) return;
		const { left, top, right, bottom } = this.#scene.box;
		const { width, height } = this.size;
		this.#scale = Math.max(
			0.01,
			Math.min((width - 2 * MARGIN) / (right - left), (height - 2 * MARGIN) / (bottom - top)),
		);
		this.#middle = { x: (left + right) / 2, y: (top + bottom) / 2 };
		const ids = this.#scene.handles.map(({ id }) => id);
		if (this.#chosen === undefined || !ids.includes(this.#chosen)) [this.#chosen] = ids;
	}

	/** Renders the scene's lines, its handles, and the value of the shown handle. */
	protected inside(): unknown {
		const scene = this.#scene;
		if (!scene) return undefined;
		const { width, height } = this.size;
		const to = `translate(${width / 2} ${height / 2}) scale(${this.#scale}) translate(${-this.#middle.x} ${-this.#middle.y})`;
		const places = [...this.places()];
		return html`<svg class="drawing" aria-hidden="true"><g transform=${to}>
				${scene.lines.map(
					({ d, kind, fill, chosen = false }) =>
						svg`<path class=${classMap({ [kind]: true, chosen })} d=${d} fill=${fill ? `#${fill}` : "none"}></path>`,
				)}
			</g></svg>
			${scene.handles.map((handle) =>
				this.drawHandle(handle.id, this.#inView(handle.at), {
					label: text("handle", { name: handle.label, value: handle.value }),
					tab: handle.id === this.#chosen,
				}),
			)}
			${scene.handles
				.filter(({ id }) => id === this.shown || this.drags.holds(id))
				.map((handle) =>
					drawValue(
						text("handle", { name: handle.label, value: handle.value }),
						this.#inView(handle.at),
						this.size,
						places.filter(([id]) => id !== handle.id).map(([, at]) => at),
					),
				)}`;
	}

	/** Returns the handles' positions in the view. */
	protected places(): [string, Point][] {
		return (this.#scene?.handles ?? []).map(({ id, at }) => [id, this.#inView(at)]);
	}

	/** Converts a position in the view to the scene's units. */
	protected units({ x, y }: Point): Point {
		const { width, height } = this.size;
		return { x: (x - width / 2) / this.#scale + this.#middle.x, y: (y - height / 2) / this.#scale + this.#middle.y };
	}

	/** Returns a handle's name and value. */
	protected describe(id: string): string {
		const handle = this.#handle(id);
		return handle ? text("handle", { name: handle.label, value: handle.value }) : "";
	}

	/**
	 * Handles a key on a handle: Page Up and Page Down go to another one, arrows move it. Returns whether the key had an
	 * effect.
	 */
	protected key(id: string, { key, shiftKey }: KeyboardEvent): boolean {
		const handle = this.#handle(id);
		if (!handle || !this.descriptions) return false;
		if (key === "PageDown" || key === "PageUp") return this.#focusOther(key === "PageDown" ? 1 : -1);
		const [right, up] = STEPS[key] ?? [0, 0];
		if (right === 0 && up === 0) return false;
		const descriptions = withDescription(this.descriptions, handle.nudge(right, up, shiftKey));
		this.#input(descriptions);
		this.emit("design-change");
		const after = this.of?.(descriptions).handles.find((each) => each.id === id);
		if (after) this.announce(after.value);
		return true;
	}

	/** Does nothing: double clicks have no effect here. */
	protected doubled(): void {}

	/** Makes the focused handle the stop of the Tab key, and reports it. */
	protected override focused(id: string): void {
		this.#chosen = id;
		this.emit("design-focus", id);
		this.requestUpdate();
	}

	/** Moves the focus by that many handles, around the end; returns whether there is one to focus. */
	#focusOther(step: number): boolean {
		const ids = this.#scene?.handles.map(({ id }) => id) ?? [];
		const next = ids[(ids.indexOf(this.#chosen ?? "") + step + ids.length) % ids.length];
		this.element(next)?.focus({ preventScroll: true });
		return next !== undefined;
	}

	/** Returns the handle of an id in the present scene; undefined if there is none. */
	#handle(id: string): SceneHandle | undefined {
		return this.#scene?.handles.find((each) => each.id === id);
	}

	/** Converts a point of the scene to the view, in CSS pixels. */
	#inView({ x, y }: Point): Point {
		const { width, height } = this.size;
		return { x: (x - this.#middle.x) * this.#scale + width / 2, y: (y - this.#middle.y) * this.#scale + height / 2 };
	}

	/** Shows descriptions during a drag, and reports them. */
	#input(descriptions: readonly Description[]): void {
		this.descriptions = descriptions;
		this.emit("design-input", { descriptions });
	}
}

const STEPS: Readonly<Record<string, readonly [right: number, up: number]>> = {
	ArrowRight: [1, 0],
	ArrowLeft: [-1, 0],
	ArrowUp: [0, 1],
	ArrowDown: [0, -1],
};

/** Returns the descriptions with one organ's replaced. */
const withDescription = (descriptions: readonly Description[], one: Description): readonly Description[] =>
	descriptions.map((each) => (each.organ === one.organ ? one : each));

customElements.define("panicle-flower-design", DesignView);
