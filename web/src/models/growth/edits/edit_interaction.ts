/** Branches under the pointer, the handles of the chosen branch, and the stroke that draws it. */
import type { EditorState } from "../../../ui/editor_context";
import { placeUnder } from "../../../ui/handles/handle_ways";
import type { HandleVector, PlantHandle, PlantHandles } from "../../../ui/handles/plant_handle";
import { PlantInteraction } from "../../../ui/handles/plant_interaction";
import type { Point } from "../../../ui/handles/point";
import { PickPointer } from "../../../ui/pick_pointer";
import type { ToolInteraction, ToolView } from "../../../ui/tool";
import type { GrowthPlant } from "../growth_plant";
import { text } from "../messages.generated";
import type { GrowthSpecimen } from "../specimen";
import { type EditPoint, editPoint, withEdit } from "./branch_edit";
import {
	type Branch,
	type BranchPlace,
	bent,
	branchesOf,
	evenPoints,
	lengthOf,
	placeUnderRay,
	pointAt,
} from "./branches";
import { canShape, changeOf, choose, chosenBranch, type EditContext, editing, leave } from "./edit_state";

/** CSS pixels from a branch within which the pointer is on it. */
const REACH = 10;
/** CSS pixels between two places of a stroke. */
const FINE = 6;
/** Points of a bent and of a drawn branch. */
const BENT_POINTS = 6;
const DRAWN_POINTS = 12;
/** Shares of a branch's length at which an arrow key moves a handle, alone and with Shift. */
const STEP = 0.03;
const LARGE_STEP = 0.15;
/** Shares of a branch's length with handles. */
const MIDDLE = 0.5;
const TIP = 1;

const WAYS: readonly HandleVector[] = [
	[1, 0, 0],
	[0, 1, 0],
	[0, 0, 1],
];

export class EditInteraction implements ToolInteraction<GrowthSpecimen, GrowthPlant> {
	readonly #view: ToolView;
	readonly #context: EditContext;
	readonly #handles: PlantInteraction<GrowthSpecimen, GrowthPlant>;
	readonly #pointer: PickPointer<BranchPlace>;
	/** Points of the stroke in progress, in the plant's metres. */
	#stroke: EditPoint[] | undefined;
	#last: Point = { x: 0, y: 0 };
	#drawing = false;

	/** Listens to the pointer and to Escape until `dispose`. */
	constructor(view: ToolView, context: EditContext) {
		this.#view = view;
		this.#context = context;
		this.#handles = new PlantInteraction<GrowthSpecimen, GrowthPlant>(view, context, {
			editedDetails: ({ edits }) => ({ edits }),
		});
		this.#pointer = new PickPointer<BranchPlace>(view, {
			name: "picking-branch",
			at: (x, y) => this.#branchAt(x, y),
			mark: (place) => this.#mark(place?.address),
			take: (place) => choose(context, place),
		});
		// In the capturing phase, so that the view does not turn under a stroke.
		view.canvas.addEventListener("pointerdown", this.#beginStroke, { capture: true });
		view.canvas.addEventListener("pointermove", this.#extendStroke);
		view.canvas.addEventListener("pointerup", this.#endStroke);
		view.canvas.addEventListener("lostpointercapture", this.#endStroke);
		window.addEventListener("keydown", this.#keyDown);
	}

	/** Shows the branch under the pointer and the chosen one with its handles. */
	update({ specimen, grown }: EditorState<GrowthSpecimen, GrowthPlant>): void {
		const { on, chosen, marked, drawing } = this.#context.toolState(editing);
		this.#drawing = on && drawing;
		this.#pointer.enabled = on && !drawing;
		this.#view.canvas.style.cursor = this.#drawing ? "crosshair" : "";
		if (!on || !grown) {
			this.#handles.set(undefined);
			return;
		}
		const { byAddress } = branchesOf(grown);
		const branch = chosen && byAddress.get(chosen.address);
		const hovered = marked === undefined || marked === chosen?.address ? undefined : byAddress.get(marked);
		const shown: PlantHandles = {
			handles: branch && !drawing && canShape(specimen, branch.address) ? this.#handlesOf(branch) : [],
			lines: [branch, hovered].flatMap((each) => (each ? [each.line] : [])),
		};
		this.#handles.set(shown, true);
	}

	/** Stops listening. */
	dispose(): void {
		const { canvas } = this.#view;
		canvas.removeEventListener("pointerdown", this.#beginStroke, { capture: true });
		canvas.removeEventListener("pointermove", this.#extendStroke);
		canvas.removeEventListener("pointerup", this.#endStroke);
		canvas.removeEventListener("lostpointercapture", this.#endStroke);
		window.removeEventListener("keydown", this.#keyDown);
		canvas.style.cursor = "";
		this.#view.orbiting = true;
		this.#pointer.dispose();
		this.#handles.dispose();
	}

	/** Highlights a branch, or none. */
	#mark(marked: string | undefined): void {
		const state = this.#context.toolState(editing);
		if (state.marked !== marked) this.#context.setToolState(editing, { ...state, marked });
	}

	/** Returns the place on a branch at a point of the canvas, in CSS pixels. */
	#branchAt(x: number, y: number): BranchPlace | undefined {
		const { grown } = this.#context.state;
		if (!grown) return undefined;
		const ray = this.#view.rayThrough(x, y);
		return placeUnderRay(grown, ray, angleBetween(ray.direction, this.#view.rayThrough(x + REACH, y).direction));
	}

	/** Returns the handles that bend a branch: at its tip and in its middle. */
	#handlesOf(branch: Branch): PlantHandle[] {
		const { line, address } = branch;
		const { edits } = this.#context.state.specimen;
		const length = lengthOf(line);
		const bendTo = (at: number, to: EditPoint) =>
			changeOf(
				withEdit(edits, { shoot: address, kind: "curve", points: bent(line, at, to, BENT_POINTS).map(editPoint) }),
			);
		return [TIP, MIDDLE].map((at) => {
			const place = pointAt(line, at);
			return {
				id: at === TIP ? "tip" : "middle",
				label: text(at === TIP ? "branch_tip" : "branch_middle"),
				value: `x ${place[0].toFixed(2)}, y ${place[1].toFixed(2)}, z ${place[2].toFixed(2)} m`,
				...(at === TIP ? { kind: "chosen" as const } : {}),
				at: place,
				along: WAYS,
				pull: (to) => bendTo(at, to),
				nudge: (right, up, large) => {
					const step = (large ? LARGE_STEP : STEP) * length;
					const [sideways] = this.#facing();
					return bendTo(at, [
						place[0] + step * right * sideways[0],
						place[1] + step * up,
						place[2] + step * right * sideways[2],
					]);
				},
			};
		});
	}

	/** Returns the directions to the right and up in the picture, in the plant's metres. */
	#facing(): [right: HandleVector, up: HandleVector] {
		const { width, height } = this.#view.canvas.getBoundingClientRect();
		const [x, y, z] = this.#view.rayThrough(width / 2, height / 2).direction;
		const level = Math.hypot(x, z) || 1;
		const right: HandleVector = [-z / level, 0, x / level];
		return [right, [right[1] * z - right[2] * y, right[2] * x - right[0] * z, right[0] * y - right[1] * x]];
	}

	/** Returns the point under the pointer in the plane through a branch's base that faces the camera. */
	#pointUnder({ clientX, clientY }: PointerEvent, base: EditPoint): EditPoint | undefined {
		const { left, top } = this.#view.canvas.getBoundingClientRect();
		const found = placeUnder(base, this.#facing(), this.#view.rayThrough(clientX - left, clientY - top));
		return found && [found[0], Math.max(0, found[1]), found[2]];
	}

	/** Begins a stroke at the chosen branch's base; the view does not turn meanwhile. */
	readonly #beginStroke = (event: PointerEvent): void => {
		const branch = chosenBranch(this.#context);
		if (!this.#drawing || event.button !== 0 || this.#stroke || !branch) return;
		this.#stroke = [branch.line[0]];
		this.#last = { x: event.clientX, y: event.clientY };
		this.#view.orbiting = false;
		this.#view.canvas.setPointerCapture(event.pointerId);
	};

	/** Extends the stroke, which is shown as a line. */
	readonly #extendStroke = (event: PointerEvent): void => {
		const { clientX: x, clientY: y } = event;
		if (!this.#stroke || Math.hypot(x - this.#last.x, y - this.#last.y) < FINE) return;
		const at = this.#pointUnder(event, this.#stroke[0]);
		if (!at) return;
		this.#last = { x, y };
		this.#stroke.push(at);
		this.#handles.set({ handles: [], lines: [this.#stroke] }, true);
	};

	/** Ends a stroke: the branch follows it, as one undo step. A stroke without length changes nothing. */
	readonly #endStroke = (): void => {
		const stroke = this.#stroke;
		if (!stroke) return;
		this.#stroke = undefined;
		this.#view.orbiting = true;
		const { chosen } = this.#context.toolState(editing);
		this.#context.setToolState(editing, { ...this.#context.toolState(editing), drawing: false });
		if (!chosen || stroke.length < 3) return;
		const points = evenPoints(stroke, DRAWN_POINTS).map(editPoint);
		const { edits } = this.#context.state.specimen;
		this.#context.set(changeOf(withEdit(edits, { shoot: chosen.address, kind: "curve", points })));
	};

	/** Escape ends drawing, then the choice, then the tool; not in fields and dialogs. */
	readonly #keyDown = (event: KeyboardEvent): void => {
		const state = this.#context.toolState(editing);
		if (event.key !== "Escape" || event.defaultPrevented || !state.on || document.querySelector("dialog[open]")) return;
		if ((event.target as Partial<Element> | null)?.closest?.("input, select, textarea, [contenteditable]")) return;
		event.preventDefault();
		if (state.drawing) this.#context.setToolState(editing, { ...state, drawing: false });
		else if (state.chosen) choose(this.#context, undefined);
		else leave(this.#context);
	};
}

/** Returns the tangent of the angle between two directions. */
function angleBetween(a: HandleVector, b: HandleVector): number {
	const cosine = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (Math.hypot(...a) * Math.hypot(...b));
	return Math.tan(Math.acos(Math.min(1, Math.max(-1, cosine))));
}
