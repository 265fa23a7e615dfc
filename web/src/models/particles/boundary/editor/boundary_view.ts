/** `<panicle-boundary>`: the outer and the inner boundary from the front, with grips, over the plant's branches. */
import { svg, type TemplateResult } from "lit";
import type { Point } from "../../../../ui/handles/point";
import type { TrailPlant } from "../../trails";
import type { Box } from "./boundary_layout";
import { BranchDrawing } from "./branches";
import { type FlatScene, loopPath, oval, ROOM, rectangle, scale } from "./flat_drawing";
import { type BoundaryExtent, type BoundaryFrame, frameAbout, toScreen } from "./frame";
import { GripView } from "./grip_view";

/** The drawing of a boundary: loops in shares of the box, x in −1 … 1, y in 0 … 1 from below. */
export interface BoundaryScene extends FlatScene {
	readonly box: Box;
	/** Size of the inner boundary relative to the outer one. */
	readonly inner: number;
	/** Loops of the inner boundary, in the coordinates of `loops`, where its shape differs. */
	readonly innerLoops?: readonly (readonly Point[])[];
	/** The fixed height of the inner boundary's scaling, metres. */
	readonly bareAbout: number;
}

export class BoundaryView extends GripView {
	static override properties = { ...GripView.properties, scene: { attribute: false }, grown: { attribute: false } };
	declare scene: BoundaryScene | undefined;
	declare grown: TrailPlant | undefined;

	protected readonly heading = "Boundary, from in front";
	protected readonly help =
		"Drag, or use the arrow keys; Shift moves ten times as far. Enter says where it stands. Escape calls off a drag.";
	readonly #branches = new BranchDrawing();

	protected fit(): BoundaryFrame {
		return frameAbout(extentOf(this.scene), this.size.width, this.size.height);
	}

	protected drawing(frame: BoundaryFrame): TemplateResult {
		const { scene } = this;
		if (!scene) return svg``;
		const { box, axes, loops, inner, innerLoops = loops, bareAbout, walls, rounds } = scene;
		const ground = toScreen(frame, { x: 0, y: 0 }).y;
		return svg`${axes.map(
			(axis) => svg`
				<path class="outer" d=${loopPath(frame, loops, placedIn(box, axis, 1, 0))}></path>
				${inner > 0 ? svg`<path class="inner" d=${loopPath(frame, innerLoops, placedIn(box, axis, inner, bareAbout))}></path>` : ""}
				${axisLine(frame, box, axis)}`,
		)}
			${walls.map(([ax, ay, , bx, by]) => rectangle(frame, { x: ax, y: ay }, { x: bx, y: by }))}
			${rounds.map(([ax, ay, , bx, by]) => oval(frame, { x: ax, y: ay }, { x: bx, y: by }))}
			<line class="ground" x1="0" y1=${ground} x2=${frame.width} y2=${ground}></line>
			${scale(frame)}`;
	}

	protected override ink(canvas: HTMLCanvasElement): void {
		this.#branches.show(canvas, this.grown, this.frame);
	}
}

function extentOf(scene: BoundaryScene | undefined): BoundaryExtent {
	if (!scene) return { halfWidth: 1, low: 0, high: 1 };
	const { box, axes, loops, walls, rounds, targets } = scene;
	const reach = box.halfWidth * Math.max(1, ...loops.flat().map(({ x }) => Math.abs(x)));
	const xs = [...[...walls, ...rounds].flatMap(([ax, , , bx]) => [ax, bx]), ...targets.map(([x]) => x)];
	const ys = [
		box.low,
		box.high,
		...[...walls, ...rounds].flatMap(([, ay, , , by]) => [ay, by]),
		...targets.map(([, y]) => y),
	];
	const sides = [Math.max(...axes.map(Math.abs)) + reach, ...xs.map(Math.abs)];
	const [low, high] = [Math.min(0, ...ys), Math.max(0, ...ys)];
	const room = ROOM * (high - low);
	return { halfWidth: (1 + ROOM) * Math.max(...sides), low: low - room, high: high + room };
}

/** Maps shares of the box to metres: about an axis, scaled by `size` about a height. */
function placedIn({ halfWidth, low, high }: Box, axis: number, size: number, about: number): (share: Point) => Point {
	return ({ x, y }) => ({ x: axis + size * x * halfWidth, y: about + size * (low + y * (high - low) - about) });
}

function axisLine(frame: BoundaryFrame, { low, high }: Box, axis: number): TemplateResult {
	const [from, to] = [Math.min(0, low), Math.max(0, high)].map((y) => toScreen(frame, { x: axis, y }));
	return svg`<line class="axis" x1=${from.x} y1=${from.y} x2=${to.x} y2=${to.y}></line>`;
}

customElements.define("panicle-boundary", BoundaryView);
