/** Veins finer than any mesh holds, as a texture over the chart: how much of each place is vein, white all, black none. */
import { CanvasTexture, LinearMipmapLinearFilter } from "three";
import type { Leaf } from "../grown";
import { bundled } from "../outline/bundles";
import { chartSquare } from "../parts/vein_map";

/** Pixels to a side. */
const SIDE = 1024;
const CLASSES = 10;
/** The least width of a line, pixels: what is finer is paler in its place. */
const FINEST = 1.3;

/** Undefined where there is no canvas to draw on. */
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
	pen.fillStyle = "#000";
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
		pen.globalAlpha = Math.min(1, width / FINEST) ** 0.8;
		pen.stroke();
	}
	const texture = new CanvasTexture(canvas);
	texture.minFilter = LinearMipmapLinearFilter;
	texture.anisotropy = 4;
	return texture;
}
