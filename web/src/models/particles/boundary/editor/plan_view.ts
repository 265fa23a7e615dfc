/**
 * `<panicle-plan>`: boundary, obstacles and targets from above, over the plant's branches; the front is at the bottom.
 */

import { svg, type TemplateResult } from "lit";
import type { Point } from "../../../../ui/handles/point";
import { text } from "../../messages.generated";
import { AboveView } from "./above_view";
import { type FlatScene, loopPath, oval, ROOM, rectangle, scale } from "./flat_drawing";
import { type BoundaryFrame, frameAbout, toScreen } from "./frame";

/** The drawing of a specimen from above: loops in shares of the half width and the half depth, y to the back. */
export interface PlanScene extends FlatScene {
	readonly halfWidth: number;
	readonly halfDepth: number;
}

export class PlanView extends AboveView {
	static override properties = { ...AboveView.properties, scene: { attribute: false } };
	declare scene: PlanScene | undefined;

	protected readonly heading = text("plan_view");
	protected readonly help = text("plan_help");

	/** Returns the frame that shows all of the scene. */
	protected fit(): BoundaryFrame {
		const { halfWidth, deep } = reachOf(this.scene);
		return frameAbout({ halfWidth, low: -deep, high: deep }, this.size.width, this.size.height);
	}

	/** Draws the boundary at each axis, obstacles and a scale. */
	protected drawing(frame: BoundaryFrame): TemplateResult {
		const { scene } = this;
		if (!scene) return svg``;
		const { halfWidth, halfDepth, axes, loops, walls, rounds } = scene;
		const about = (axis: number) => (share: Point) => ({ x: axis + halfWidth * share.x, y: halfDepth * share.y });
		const edge = toScreen(frame, { x: 0, y: 0 });
		return svg`${axes.map((axis) => svg`<path class="outer" d=${loopPath(frame, loops, about(axis))}></path>`)}
			<line class="axis" x1="0" y1=${edge.y} x2=${frame.width} y2=${edge.y}></line>
			${walls.map(([ax, , az, bx, , bz]) => rectangle(frame, { x: ax, y: -bz }, { x: bx, y: -az }))}
			${rounds.map(([ax, , az, bx, , bz]) => oval(frame, { x: ax, y: -bz }, { x: bx, y: -az }))}
			<text x=${frame.width - 6} y=${frame.height - 8} text-anchor="end">${text("front")}</text>
			${scale(frame)}`;
	}

	/** Returns the frame of the branches: the view's own, because its unit is the metre. */
	protected ground(): BoundaryFrame {
		return this.frame;
	}
}

/** Returns the range that the view must show to both sides of the middle, in metres, with some room. */
function reachOf(scene: PlanScene | undefined): { halfWidth: number; deep: number } {
	if (!scene) return { halfWidth: 1, deep: 1 };
	const { halfWidth, halfDepth, axes, loops, walls, rounds, targets } = scene;
	const share = (of: (point: Point) => number) => Math.max(1, ...loops.flat().map((point) => Math.abs(of(point))));
	const xs = [...[...walls, ...rounds].flatMap(([ax, , , bx]) => [ax, bx]), ...targets.map(([x]) => x)];
	const zs = [...[...walls, ...rounds].flatMap(([, , az, , , bz]) => [az, bz]), ...targets.map(([, , z]) => z)];
	const across = Math.max(Math.max(...axes.map(Math.abs)) + halfWidth * share(({ x }) => x), ...xs.map(Math.abs));
	const deep = Math.max(halfDepth * share(({ y }) => y), ...zs.map(Math.abs));
	return { halfWidth: (1 + ROOM) * across, deep: (1 + ROOM) * deep };
}

customElements.define("panicle-plan", PlanView);
