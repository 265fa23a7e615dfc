/** `<panicle-boundary>`: the outer and the inner boundary from the front, with grips, over the plant's branches. */

import { svg, type TemplateResult } from "lit";
import type { Point } from "../../../../ui/handles/point";
import { text } from "../../messages.generated";
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

	protected readonly heading = text("boundary_view");
	protected readonly help = text("handle_help");
	readonly #branches = new BranchDrawing();

	/** Returns the frame that shows all of the scene. */
	protected fit(): BoundaryFrame {
		return frameAbout(extentOf(this.scene), this.size.width, this.size.height);
	}

	/** Draws both boundaries at each axis, obstacles, the ground and a scale. */
	protected drawing(frame: BoundaryFrame): TemplateResult {
		const { scene } = this;
		if (!scene) return svg``;
		const { box, axes, loops, inner, innerLoops = loops, bareAbout, walls, rounds } = scene;
		const ground = toScreen(frame, { x: 0, y: 0 }).y;
		return svg`${axes.map(
			(axis) => svg`
				<path class="outer" d=${loopPath(frame, loops, toMetresIn(box, axis, 1, 0))}></path>
				${inner > 0 ? svg`<path class="inner" d=${loopPath(frame, innerLoops, toMetresIn(box, axis, inner, bareAbout))}></path>` : ""}
				${axisLine(frame, box, axis)}`,
		)}
			${walls.map(([ax, ay, , bx, by]) => rectangle(frame, { x: ax, y: ay }, { x: bx, y: by }))}
			${rounds.map(([ax, ay, , bx, by]) => oval(frame, { x: ax, y: ay }, { x: bx, y: by }))}
			<line class="ground" x1="0" y1=${ground} x2=${frame.width} y2=${ground}></line>
			${scale(frame)}`;
	}

	/** Draws the plant's branches behind the grips. */
	protected override ink(canvas: HTMLCanvasElement): void {
		this.#branches.show(canvas, this.grown, this.frame);
	}
}

/** Returns the range that the view must show, in metres, with some room around boundary, obstacles and targets. */
function extentOf(scene: BoundaryScene | undefined): BoundaryExtent {
	if (!scene) return { halfWidth: 1, low: 0, high: 1 };
	const { box, axes, loops, walls, rounds, targets } = scene;
	const outlineHalfWidth = box.halfWidth * Math.max(1, ...loops.flat().map(({ x }) => Math.abs(x)));
	const xs = [...[...walls, ...rounds].flatMap(([ax, , , bx]) => [ax, bx]), ...targets.map(([x]) => x)];
	const ys = [
		box.low,
		box.high,
		...[...walls, ...rounds].flatMap(([, ay, , , by]) => [ay, by]),
		...targets.map(([, y]) => y),
	];
	const sides = [Math.max(...axes.map(Math.abs)) + outlineHalfWidth, ...xs.map(Math.abs)];
	const [low, high] = [Math.min(0, ...ys), Math.max(0, ...ys)];
	const margin = ROOM * (high - low);
	return { halfWidth: (1 + ROOM) * Math.max(...sides), low: low - margin, high: high + margin };
}

/** Returns a function that maps shares of the box to metres: about an axis, scaled by `size` about a height. */
function toMetresIn(
	{ halfWidth, low, high }: Box,
	axis: number,
	size: number,
	fixedHeight: number,
): (share: Point) => Point {
	return ({ x, y }) => ({
		x: axis + size * x * halfWidth,
		y: fixedHeight + size * (low + y * (high - low) - fixedHeight),
	});
}

/** Draws the axis of a boundary, from the ground to its ends. */
function axisLine(frame: BoundaryFrame, { low, high }: Box, axis: number): TemplateResult {
	const [from, to] = [Math.min(0, low), Math.max(0, high)].map((y) => toScreen(frame, { x: axis, y }));
	return svg`<line class="axis" x1=${from.x} y1=${from.y} x2=${to.x} y2=${to.y}></line>`;
}

customElements.define("panicle-boundary", BoundaryView);
