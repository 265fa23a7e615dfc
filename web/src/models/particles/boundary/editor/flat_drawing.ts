/** SVG drawings under the grips of flat views: from metres to CSS pixels. */
import { svg, type TemplateResult } from "lit";
import type { Point } from "../../../../ui/handles/point";
import { drawScaleBar } from "../../../../ui/handles/scale_bar";
import { type BoundaryFrame, scaleBar, toScreen } from "./frame";

/** Closed polygons, in shares of a box. */
export type Loops = readonly (readonly Point[])[];

/** The part of a specimen that all flat views draw, metres. */
export interface FlatScene {
	/** x coordinates of the boundaries' axes. */
	readonly axes: readonly number[];
	/** The closed outline of one boundary, in shares of its box, as the view projects it. */
	readonly loops: Loops;
	/** Corners of the box obstacles: six numbers each. */
	readonly walls: readonly (readonly number[])[];
	/** Bounding boxes of the ellipsoids, as in `walls`. */
	readonly rounds: readonly (readonly number[])[];
	/** x, y, z of each target. */
	readonly targets: readonly (readonly number[])[];
}

/** Margin for branches and grips beyond the drawing, as a share of its size. */
export const ROOM = 0.06;

/**
 * Returns the SVG path data of loops.
 * @param place maps shares of the box to metres
 */
export function loopPath(frame: BoundaryFrame, loops: Loops, place: (share: Point) => Point): string {
	const pairs = (loop: readonly Point[]) =>
		loop.map((share) => {
			const { x, y } = toScreen(frame, place(share));
			return `${x.toFixed(1)} ${y.toFixed(1)}`;
		});
	return loops.map((loop) => `M${pairs(loop).join("L")}Z`).join("");
}

/** Draws a box obstacle between its lower left and its upper right corner, metres. */
export function rectangle(frame: BoundaryFrame, low: Point, high: Point): TemplateResult {
	const [from, to] = [toScreen(frame, { x: low.x, y: high.y }), toScreen(frame, { x: high.x, y: low.y })];
	return svg`<rect class="obstacle" x=${from.x} y=${from.y} width=${to.x - from.x} height=${to.y - from.y}></rect>`;
}

/** Draws an ellipsoid between two corners of its bounding box, metres. */
export function oval(frame: BoundaryFrame, low: Point, high: Point): TemplateResult {
	const [from, to] = [toScreen(frame, { x: low.x, y: high.y }), toScreen(frame, { x: high.x, y: low.y })];
	const [rx, ry] = [(to.x - from.x) / 2, (to.y - from.y) / 2];
	return svg`<ellipse class="obstacle" cx=${from.x + rx} cy=${from.y + ry} rx=${rx} ry=${ry}></ellipse>`;
}

/** Draws a scale bar at the lower left. */
export function scale(frame: BoundaryFrame): TemplateResult {
	const { length, label } = scaleBar(frame);
	return drawScaleBar(length * frame.scale, label, `translate(8 ${frame.height - 6})`);
}
