/** The handles of growth areas over the 3-D view, and the stroke that draws the main branch. */
import type { Change, EditorState } from "../../../ui/editor_context";
import { placeUnder } from "../../../ui/handles/handle_ways";
import type { HandleVector } from "../../../ui/handles/plant_handle";
import { PlantInteraction } from "../../../ui/handles/plant_interaction";
import type { Point } from "../../../ui/handles/point";
import type { ToolInteraction, ToolView } from "../../../ui/tool";
import type { GrammarPlant } from "../grammar_plant";
import type { GrammarSpecimen } from "../specimen";
import type { Triple } from "./area";
import { placesOf, strokeFork, strokePath, withPath } from "./area_edits";
import { areaHandles } from "./area_handles";
import { type AreaContext, type AreaState, areaTool, choose, hasAreas } from "./area_tool";

/** CSS pixels between two places of a stroke. */
const FINE = 6;

type State = EditorState<GrammarSpecimen, GrammarPlant>;

export class AreaInteraction implements ToolInteraction<GrammarSpecimen, GrammarPlant> {
	readonly #view: ToolView;
	readonly #context: AreaContext;
	readonly #handles: PlantInteraction<GrammarSpecimen, GrammarPlant>;
	/** Document before the stroke. */
	#before: GrammarSpecimen | undefined;
	#stroke: Triple[] | undefined;
	/** Whether the stroke draws a fork, by the tool's state at its start. */
	#strokeIsFork = false;
	#last: Point = { x: 0, y: 0 };
	#drawing: AreaState["drawing"];

	/** Creates the handles and listens for strokes until `dispose`. */
	constructor(view: ToolView, context: AreaContext) {
		this.#view = view;
		this.#context = context;
		this.#handles = new PlantInteraction<GrammarSpecimen, GrammarPlant>(view, context, {
			editedDetails: ({ areas, path, from }) => ({ areas, path, from }),
			focused: (id) => this.#chooseFocused(id),
		});
		// In the capturing phase, so that the view does not turn under a stroke.
		view.canvas.addEventListener("pointerdown", this.#beginStroke, { capture: true });
		view.canvas.addEventListener("pointermove", this.#extendStroke);
		view.canvas.addEventListener("pointerup", this.#endStroke);
		view.canvas.addEventListener("lostpointercapture", this.#endStroke);
	}

	/** Shows the handles for the tool's state, or prepares for a stroke. */
	update({ specimen }: State): void {
		const { handles: wanted, chosen, path = false, drawing } = this.#context.toolState(areaTool);
		const handles = wanted && hasAreas(specimen);
		this.#drawing = handles ? drawing : undefined;
		this.#view.canvas.style.cursor = this.#drawing ? "crosshair" : "";
		const shown = handles && !drawing ? areaHandles(specimen, { area: chosen, path, removable: true }) : undefined;
		this.#handles.set(shown, handles);
	}

	/** Stops listening and gives the camera controls back. */
	dispose(): void {
		const { canvas } = this.#view;
		canvas.removeEventListener("pointerdown", this.#beginStroke, { capture: true });
		canvas.removeEventListener("pointermove", this.#extendStroke);
		canvas.removeEventListener("pointerup", this.#endStroke);
		canvas.removeEventListener("lostpointercapture", this.#endStroke);
		canvas.style.cursor = "";
		this.#view.orbiting = true;
		this.#handles.dispose();
	}

	/** Chooses the area whose centre's handle has received the focus. */
	#chooseFocused(id: string): void {
		const [, area] = /^area-(\d+)$/.exec(id) ?? [];
		const index = area === undefined ? undefined : Number(area);
		if (index !== undefined && index !== this.#context.toolState(areaTool).chosen) choose(this.#context, index);
	}

	/**
	 * Returns the point under the pointer in the plane through the centre of the main branch's places that faces the
	 * camera; undefined where the ray misses it.
	 */
	#pointUnder({ clientX, clientY }: PointerEvent): Triple | undefined {
		const { left, top, width, height } = this.#view.canvas.getBoundingClientRect();
		const places = placesOf(this.#context.state.specimen);
		const mean = (k: number) => places.reduce((sum, at) => sum + at[k], 0) / Math.max(1, places.length);
		const centre: HandleVector = [mean(0), mean(1), mean(2)];
		const facing = this.#view.rayThrough(width / 2, height / 2).direction;
		const horizontalLength = Math.hypot(facing[0], facing[2]) || 1;
		const right: HandleVector = [-facing[2] / horizontalLength, 0, facing[0] / horizontalLength];
		const up: HandleVector = [
			right[1] * facing[2] - right[2] * facing[1],
			right[2] * facing[0] - right[0] * facing[2],
			right[0] * facing[1] - right[1] * facing[0],
		];
		const found = placeUnder(centre, [right, up], this.#view.rayThrough(clientX - left, clientY - top));
		return found && [found[0], Math.max(0, found[1]), found[2]];
	}

	/** Begins a stroke if a branch is to be drawn; the view does not turn meanwhile. */
	readonly #beginStroke = (event: PointerEvent): void => {
		if (!this.#drawing || event.button !== 0 || this.#stroke) return;
		const at = this.#pointUnder(event);
		if (!at) return;
		this.#stroke = [at];
		this.#strokeIsFork = this.#drawing === "fork";
		this.#last = { x: event.clientX, y: event.clientY };
		this.#before = this.#context.state.specimen;
		this.#view.orbiting = false;
		this.#view.canvas.setPointerCapture(event.pointerId);
	};

	/** Extends the stroke; the plant regrows at once. */
	readonly #extendStroke = (event: PointerEvent): void => {
		const { clientX: x, clientY: y } = event;
		if (!this.#stroke || Math.hypot(x - this.#last.x, y - this.#last.y) < FINE) return;
		const at = this.#pointUnder(event);
		if (!at) return;
		this.#last = { x, y };
		this.#stroke.push(at);
		const change = this.#changeByStroke(this.#stroke);
		if (change) this.#context.edit(change);
	};

	/** Returns the change that a stroke makes: another path, or a further branch. Undefined where it is too short. */
	#changeByStroke(stroke: readonly Triple[]): Change | undefined {
		return this.#strokeIsFork && this.#before ? strokeFork(this.#before, stroke) : strokePath(stroke);
	}

	/**
	 * Ends a stroke: sets the drawn branch as one undo step, or restores the path from before if the stroke is too short.
	 */
	readonly #endStroke = (): void => {
		if (!this.#stroke) return;
		const drawn = this.#changeByStroke(this.#stroke);
		this.#stroke = undefined;
		this.#view.orbiting = true;
		if (drawn) this.#context.edit(drawn);
		else this.#context.edit(withPath(this.#before?.path, this.#before?.from));
		this.#context.settle();
		this.#context.setToolState(areaTool, { ...this.#context.toolState(areaTool), drawing: undefined, path: true });
	};
}
