/**
 * The finest veins, which no mesh can hold, as a texture over the chart: white where veins are, grey between. It dims what
 * vertices' colours say between veins, and is the height of the relief.
 */
import { CanvasTexture, LinearMipmapLinearFilter } from "three";
import type { Leaf } from "../grown";
import { bundled } from "../outline/bundles";
import { chartSquare } from "../parts/vein_map";

/** Pixels to a side. */
const SIDE = 1024;
const CLASSES = 10;
/** What is left of light between veins: linear, as the texture is read. */
const BETWEEN = 0.76;
/** The least width of a line, pixels: what is finer is paler in its place. */
const FINEST = 1.3;

/** Where there is no canvas to draw on, undefined. */
export function veinTexture(
	{ chart, margin, segments: { radii } }: Leaf,
	millimetres: number,
): CanvasTexture | undefined {
	const canvas = document.createElement("canvas");
	canvas.width = SIDE;
	canvas.height = SIDE;
	const pen = canvas.getContext("2d");
	if (!pen) return undefined;
	const { left, bottom, size } = chartSquare(margin);
	const grey = Math.round(255 * BETWEEN);
	pen.fillStyle = `rgb(${grey} ${grey} ${grey})`;
	pen.fillRect(0, 0, SIDE, SIDE);
	pen.strokeStyle = "#fff";
	pen.lineCap = "round";
	const widths = Float32Array.from({ length: chart.length / 4 }, (_, i) => radii[2 * i] + radii[2 * i + 1]);
	const scale = SIDE / size;
	for (const members of bundled(widths, CLASSES)) {
		pen.beginPath();
		let total = 0;
		for (const index of members) {
			const [x1, y1, x2, y2] = chart.subarray(4 * index, 4 * index + 4);
			pen.moveTo((x1 - left) * scale, SIDE - (y1 - bottom) * scale);
			pen.lineTo((x2 - left) * scale, SIDE - (y2 - bottom) * scale);
			total += widths[index];
		}
		const width = ((total / members.length) * 1000 * scale) / millimetres;
		pen.lineWidth = Math.max(FINEST, width);
		pen.globalAlpha = Math.sqrt(Math.min(1, width / FINEST));
		pen.stroke();
	}
	const texture = new CanvasTexture(canvas);
	texture.minFilter = LinearMipmapLinearFilter;
	texture.anisotropy = 4;
	return texture;
}
