/** `<panicle-boundary>`: outer and inner boundary from in front, with their grips, over the branches that grew in them. */
import { svg, type TemplateResult } from "lit";
import { drawScaleBar } from "../../../../controls/handles/scale_bar";
import type { TrailPlant } from "../../trails";
import type { Knot } from "../bounded";
import { BranchDrawing } from "./branches";
import { type Extent, type Frame, frameAbout, scaleBar, toScreen } from "./frame";
import { GripView } from "./grip_view";
import type { Box } from "./lay";

/** What is drawn of a specimen's boundary. */
export interface BoundaryScene {
	readonly box: Box;
	readonly axes: readonly number[];
	/** Shares of the box, from below. */
	readonly outline: readonly Knot[];
	/** Of the inner boundary, over the outer. */
	readonly inner: number;
	/** The height about which that is smaller. */
	readonly bareAbout: number;
	/** Numbers, six a wall. */
	readonly walls: readonly (readonly number[])[];
	/** Places on the ground, or wherever they were put. */
	readonly targets: readonly number[];
}

/** Room that branches and grips take beyond what is drawn, as a share. */
const ROOM = 0.06;

export class BoundaryView extends GripView {
	static override properties = { ...GripView.properties, scene: { attribute: false }, grown: { attribute: false } };
	declare scene: BoundaryScene | undefined;
	declare grown: TrailPlant | undefined;

	protected readonly heading = "Boundary, from in front";
	protected readonly help =
		"Drag, or use the arrow keys; Shift moves ten times as far. Enter says where it stands. Insert adds a point after this one, Delete takes it out. Escape calls off a drag.";
	readonly #branches = new BranchDrawing();

	protected fit(): Frame {
		return frameAbout(extentOf(this.scene), this.size.width, this.size.height);
	}

	protected drawing(frame: Frame): TemplateResult {
		const { scene } = this;
		if (!scene) return svg``;
		const { box, axes, outline, inner, bareAbout, walls, targets } = scene;
		const ground = toScreen(frame, { x: 0, y: 0 }).y;
		return svg`${axes.map(
			(axis) => svg`
				<path class="outer" d=${path(frame, outline, box, axis, 1, 0)}></path>
				${inner > 0 ? svg`<path class="inner" d=${path(frame, outline, box, axis, inner, bareAbout)}></path>` : ""}
				${axisLine(frame, box, axis)}`,
		)}
			${walls.map(([ax, ay, , bx, by]) => rectangle(frame, ax, ay, bx, by))}
			<line class="ground" x1="0" y1=${ground} x2=${frame.width} y2=${ground}></line>
			${pointsOf(targets).map((target) => dot(frame, target))}
			${scale(frame)}`;
	}

	protected override ink(canvas: HTMLCanvasElement): void {
		this.#branches.show(canvas, this.grown, this.frame);
	}
}

function extentOf(scene: BoundaryScene | undefined): Extent {
	if (!scene) return { halfWidth: 1, low: 0, high: 1 };
	const { box, axes, outline, walls } = scene;
	const reach = box.halfWidth * Math.max(1, ...outline.map(([radius]) => radius));
	const sides = [
		Math.max(...axes.map(Math.abs)) + reach,
		...walls.flatMap(([ax, , , bx]) => [Math.abs(ax), Math.abs(bx)]),
	];
	const [low, high] = [Math.min(0, box.low), Math.max(0, box.high, ...walls.map(([, , , , by]) => by))];
	const room = ROOM * (high - low);
	return { halfWidth: (1 + ROOM) * Math.max(...sides), low: low - room, high: high + room };
}

/** Both halves as the data of a closed path, `size` as large about a height of the axis. */
function path(
	frame: Frame,
	outline: readonly Knot[],
	{ halfWidth, low, high }: Box,
	axis: number,
	size: number,
	about: number,
): string {
	const place = ([radius, height]: Knot, side: 1 | -1) => {
		const y = about + size * (low + height * (high - low) - about);
		const at = toScreen(frame, { x: axis + side * size * radius * halfWidth, y });
		return `${at.x.toFixed(1)} ${at.y.toFixed(1)}`;
	};
	const right = outline.map((knot) => place(knot, 1));
	const left = outline.map((knot) => place(knot, -1)).reverse();
	return `M${[...right, ...left].join("L")}Z`;
}

function axisLine(frame: Frame, { low, high }: Box, axis: number): TemplateResult {
	const [from, to] = [Math.min(0, low), Math.max(0, high)].map((y) => toScreen(frame, { x: axis, y }));
	return svg`<line class="axis" x1=${from.x} y1=${from.y} x2=${to.x} y2=${to.y}></line>`;
}

function rectangle(frame: Frame, ax: number, ay: number, bx: number, by: number): TemplateResult {
	const [from, to] = [toScreen(frame, { x: ax, y: by }), toScreen(frame, { x: bx, y: ay })];
	return svg`<rect class="obstacle" x=${from.x} y=${from.y} width=${to.x - from.x} height=${to.y - from.y}></rect>`;
}

function pointsOf(places: readonly number[]): { x: number; y: number }[] {
	return Array.from({ length: places.length / 3 }, (_, i) => ({ x: places[3 * i], y: places[3 * i + 1] }));
}

function dot(frame: Frame, target: { x: number; y: number }): TemplateResult {
	const { x, y } = toScreen(frame, target);
	return svg`<circle class="target" cx=${x} cy=${y} r="2.5"></circle>`;
}

function scale(frame: Frame): TemplateResult {
	const { length, label } = scaleBar(frame);
	return drawScaleBar(length * frame.scale, label, `translate(8 ${frame.height - 6})`);
}

customElements.define("panicle-boundary", BoundaryView);
