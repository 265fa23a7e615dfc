/**
 * Draws the silhouette on a canvas below the view's own lines. A bunch of 500 is 500 outlines in each of two views,
 * redrawn at every step of a drag: as DOM elements they would cost several times as much as growing them.
 */
import type { View } from "./handles";
import { type BerryOutline, type DrawnBunch, type Stroke, silhouette } from "./silhouette";
import type { ViewFrame } from "./view_frame";

/** Inputs of a drawing; equal inputs need no redrawing. */
export interface SilhouetteScene {
	bunch: DrawnBunch | undefined;
	view: View;
	/** Millimetres per unit of the paper. */
	unit: number;
	frame: ViewFrame;
	/** Screen pixels per CSS pixel. */
	ratio: number;
	/** Any CSS colour. */
	ink: string;
}

/** Returns whether both give the same drawing. */
export function sameScene(one: SilhouetteScene, other: SilhouetteScene): boolean {
	const others = inputsOf(other);
	return inputsOf(one).every((ingredient, index) => ingredient === others[index]);
}

/** Returns everything that a drawing depends on, as values to compare. */
function inputsOf({ frame, ...scene }: SilhouetteScene): unknown[] {
	const { left, top, width, height, scale } = frame;
	return [scene.bunch, scene.view, scene.unit, scene.ratio, scene.ink, left, top, width, height, scale];
}

/** Widths of lines, in CSS pixels. */
const STEM = 1;
const BERRY = 0.8;

/** Methods of a canvas's context that are used. */
export type Pen = Pick<
	CanvasRenderingContext2D,
	| "setTransform"
	| "beginPath"
	| "moveTo"
	| "lineTo"
	| "ellipse"
	| "stroke"
	| "fill"
	| "lineWidth"
	| "lineCap"
	| "strokeStyle"
	| "globalCompositeOperation"
>;

/** Drawing on a view's canvas. */
export class SilhouetteDrawing {
	#lastScene?: SilhouetteScene;
	#lastCanvas?: HTMLCanvasElement;

	/** Draws in the canvas's own colour and at the screen's density, if any input has changed. */
	show(canvas: HTMLCanvasElement, content: Omit<SilhouetteScene, "ratio" | "ink">): void {
		const scene = { ...content, ratio: devicePixelRatio, ink: getComputedStyle(canvas).color };
		if (canvas === this.#lastCanvas && this.#lastScene && sameScene(this.#lastScene, scene)) return;
		this.#lastScene = scene;
		this.#lastCanvas = canvas;
		const { frame, ratio, bunch } = scene;
		// Setting a canvas's size clears it.
		canvas.width = Math.round(frame.width * frame.scale * ratio);
		canvas.height = Math.round(frame.height * frame.scale * ratio);
		const pen = canvas.getContext("2d");
		if (pen && bunch) inkSilhouette(pen, { ...scene, bunch });
	}
}

/**
 * Draws stems and berries.
 * @param unit the specimen's parameter `unit`, which sets the size of a pixel of the profile
 * @param ratio device pixels per CSS pixel
 * @param ink any CSS colour
 */
export function inkSilhouette(
	pen: Pen,
	{ bunch, view, unit, frame, ratio, ink }: SilhouetteScene & { bunch: DrawnBunch },
) {
	const { berries, stems } = silhouette(bunch, view, unit);
	const zoom = frame.scale * ratio;
	pen.setTransform(zoom, 0, 0, zoom, -frame.left * zoom, -frame.top * zoom);
	pen.strokeStyle = ink;
	pen.lineCap = "round";
	pen.lineWidth = STEM / frame.scale;
	inkStems(pen, stems);
	pen.lineWidth = BERRY / frame.scale;
	for (const berry of berries) inkBerry(pen, berry);
}

/** Draws the stems as lines. */
function inkStems(pen: Pen, stems: readonly Stroke[]): void {
	pen.beginPath();
	for (const [x1, y1, x2, y2] of stems) {
		pen.moveTo(x1, y1);
		pen.lineTo(x2, y2);
	}
	pen.stroke();
}

/** Draws a berry and erases the lines behind it, so that the page shows through. */
function inkBerry(pen: Pen, { x, y, rx, ry, turn }: BerryOutline): void {
	pen.beginPath();
	pen.ellipse(x, y, rx, ry, turn, 0, 2 * Math.PI);
	pen.globalCompositeOperation = "destination-out";
	pen.fill();
	pen.globalCompositeOperation = "source-over";
	pen.stroke();
}
