/** What flat views draw under their grips: in CSS pixels, of places in metres. */
import { svg, type TemplateResult } from "lit";
import type { Point } from "../../../../ui/handles/point";
import { drawScaleBar } from "../../../../ui/handles/scale_bar";
import { type Frame, scaleBar, toScreen } from "./frame";

/** Closed lines, in shares of a box. */
export type Loops = readonly (readonly Point[])[];

/** What every flat view draws of a specimen, in metres. */
export interface FlatScene {
	/** Where along x boundaries stand. */
	readonly axes: readonly number[];
	/** One boundary's outline, closed: in shares of its box, as the view has it. */
	readonly loops: Loops;
	/** Numbers, six a wall. */
	readonly walls: readonly (readonly number[])[];
	/** As walls, the boxes that they fill. */
	readonly rounds: readonly (readonly number[])[];
	/** x, y, z of each. */
	readonly targets: readonly (readonly number[])[];
}

/** Room that branches and grips take beyond what is drawn, as a share. */
export const ROOM = 0.06;

/** The data of a path; `place` takes shares of the box to metres. */
export function loopPath(frame: Frame, loops: Loops, place: (share: Point) => Point): string {
	const pairs = (loop: readonly Point[]) =>
		loop.map((share) => {
			const { x, y } = toScreen(frame, place(share));
			return `${x.toFixed(1)} ${y.toFixed(1)}`;
		});
	return loops.map((loop) => `M${pairs(loop).join("L")}Z`).join("");
}

/** An obstacle between two corners, the lower left one first. */
export function rectangle(frame: Frame, low: Point, high: Point): TemplateResult {
	const [from, to] = [toScreen(frame, { x: low.x, y: high.y }), toScreen(frame, { x: high.x, y: low.y })];
	return svg`<rect class="obstacle" x=${from.x} y=${from.y} width=${to.x - from.x} height=${to.y - from.y}></rect>`;
}

/** Another crown between two corners of its box. */
export function oval(frame: Frame, low: Point, high: Point): TemplateResult {
	const [from, to] = [toScreen(frame, { x: low.x, y: high.y }), toScreen(frame, { x: high.x, y: low.y })];
	const [rx, ry] = [(to.x - from.x) / 2, (to.y - from.y) / 2];
	return svg`<ellipse class="obstacle" cx=${from.x + rx} cy=${from.y + ry} rx=${rx} ry=${ry}></ellipse>`;
}

/** A scale bar at the lower left. */
export function scale(frame: Frame): TemplateResult {
	const { length, label } = scaleBar(frame);
	return drawScaleBar(length * frame.scale, label, `translate(8 ${frame.height - 6})`);
}
