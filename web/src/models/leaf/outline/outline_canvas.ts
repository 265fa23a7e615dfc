/** Draws the flat leaf on a canvas under the handles: the margin, and the veins of the last growth in their widths. */
import { bundled } from "./bundles";
import { inView, type OutlineFrame, STUB } from "./outline_frame";
import type { Place } from "./points";

/** Veins in the flat chart. */
export interface FlatVeins {
	/** 4 × count: start x y, end x y, in leaf lengths. */
	ends: Float32Array;
	/** count: widths, in leaf lengths. */
	widths: Float32Array;
	/** 2 × count: the margin with its teeth, in leaf lengths; empty where unknown. */
	margin: Float32Array;
}

export interface OutlineScene {
	curve: readonly Place[];
	veins: FlatVeins | undefined;
	frame: OutlineFrame;
	/** Device pixels per CSS pixel. */
	ratio: number;
	/** Any CSS colour. */
	ink: string;
}

/** The part of a canvas context that this module uses. */
export type LeafPen = Pick<
	CanvasRenderingContext2D,
	| "setTransform"
	| "beginPath"
	| "moveTo"
	| "lineTo"
	| "closePath"
	| "stroke"
	| "fill"
	| "lineWidth"
	| "lineCap"
	| "lineJoin"
	| "strokeStyle"
	| "fillStyle"
	| "globalAlpha"
>;

/** Width of lines and least width of a vein, CSS pixels. */
const LINE = 1.1;
const FINEST = 0.5;
/** Number of groups of veins that are drawn with one width each. */
const BUNDLES = 8;
/** Opacities of the blade, of the grown margin and of veins. */
const BLADE_OPACITY = 0.07;
const MARGIN_OPACITY = 0.45;
const VEIN_OPACITY = 0.7;

/** Draws the scene on a canvas at the element's size. */
export function showOutline(canvas: HTMLCanvasElement, scene: Omit<OutlineScene, "ratio" | "ink">): void {
	const { width, height } = scene.frame;
	const ratio = devicePixelRatio;
	// Setting the size also clears the canvas.
	canvas.width = Math.round(width * ratio);
	canvas.height = Math.round(height * ratio);
	const pen = canvas.getContext("2d");
	if (pen) inkOutline(pen, { ...scene, ratio, ink: getComputedStyle(canvas).color });
}

/** Draws the blade, its veins, its outline and the beginning of the petiole. */
export function inkOutline(pen: LeafPen, { curve, veins, frame, ratio, ink }: OutlineScene): void {
	pen.setTransform(ratio, 0, 0, ratio, 0, 0);
	pen.strokeStyle = ink;
	pen.fillStyle = ink;
	pen.lineCap = "round";
	pen.lineJoin = "round";
	tracePolygon(pen, frame, curve);
	pen.globalAlpha = BLADE_OPACITY;
	pen.fill();
	if (veins) inkVeins(pen, veins, frame);
	pen.globalAlpha = 1;
	pen.lineWidth = LINE;
	tracePolygon(pen, frame, curve);
	pen.stroke();
	pen.beginPath();
	const [from, to] = [inView(frame, { x: 0, y: 0 }), inView(frame, { x: 0, y: -STUB })];
	pen.moveTo(from.x, from.y);
	pen.lineTo(to.x, to.y);
	pen.stroke();
}

/** Starts a closed path along the points of a line, which are in leaf lengths. */
function tracePolygon(pen: LeafPen, frame: OutlineFrame, curve: readonly Place[]): void {
	pen.beginPath();
	curve.forEach((place, index) => {
		const { x, y } = inView(frame, place);
		if (index === 0) pen.moveTo(x, y);
		else pen.lineTo(x, y);
	});
	pen.closePath();
}

/** Draws the grown margin and the veins: a stroke for each bundle of veins of about the same width. */
function inkVeins(pen: LeafPen, { ends, widths, margin }: FlatVeins, frame: OutlineFrame): void {
	if (margin.length > 0) {
		const places = Array.from({ length: margin.length / 2 }, (_, i) => ({ x: margin[2 * i], y: margin[2 * i + 1] }));
		tracePolygon(pen, frame, places);
		pen.globalAlpha = MARGIN_OPACITY;
		pen.lineWidth = 0.8;
		pen.stroke();
	}
	for (const members of bundled(widths, BUNDLES)) {
		pen.beginPath();
		let total = 0;
		for (const index of members) {
			const from = inView(frame, { x: ends[4 * index], y: ends[4 * index + 1] });
			const to = inView(frame, { x: ends[4 * index + 2], y: ends[4 * index + 3] });
			pen.moveTo(from.x, from.y);
			pen.lineTo(to.x, to.y);
			total += widths[index];
		}
		const width = (total / members.length) * frame.scale;
		pen.lineWidth = Math.max(FINEST, width);
		// Veins thinner than the least width are drawn paler.
		pen.globalAlpha = VEIN_OPACITY * Math.sqrt(Math.min(1, width / FINEST));
		pen.stroke();
	}
}
