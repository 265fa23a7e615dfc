/**
 * What a light leaf's faces are laid with: colour, normals, thickness. Each picture shows its face as one sees it, tip up, the
 * first row at the top: so u runs right and v down, and green of a normal is up, as glTF has it.
 */
import { encoded } from "../../../../plant/colour";
import type { Picture, Textures } from "../../../../plant/material";
import type { Leaf } from "../grown";
import { bladeColours } from "../parts/blade_colour";
import { veinMap } from "../parts/vein_map";
import type { LeafSpecimen } from "../specimen";
import type { VeinRaster } from "./vein_raster";

export type Side = "upper" | "lower";
/** Veins stand out below, and are grooves of this share of that above. */
const GROOVE = -0.5;

export function facePictures(leaf: Leaf, specimen: LeafSpecimen, raster: VeinRaster, face: Side): Required<Textures> {
	const { relief, thickness } = specimen.parameters;
	const rise = relief * (face === "upper" ? GROOVE : 1);
	const thickest = raster.height.reduce((most, height) => Math.max(most, height), 0) * relief + thickness;
	return {
		colour: coloured(leaf, specimen, raster, face),
		normal: drawn(raster, face, (pixels, to, _, column, row) => {
			const slope = slopeAt(raster, column, row);
			const [nx, ny] = [-rise * slope[0] * (face === "upper" ? 1 : -1), -rise * slope[1]];
			const length = Math.hypot(nx, ny, 1);
			pixels.set(
				[nx, ny, 1].map((value) => Math.round(127.5 + (127.5 * value) / length)),
				to,
			);
		}),
		thickness: drawn(raster, face, (pixels, to, at) => {
			const share = (thickness + relief * raster.height[at]) / thickest;
			pixels.fill(Math.round(255 * share), to, to + 3);
		}),
	};
}

function coloured(leaf: Leaf, { look, parameters }: LeafSpecimen, raster: VeinRaster, face: Side): Picture {
	const { side, cell, cover, edge } = raster;
	const positions = new Float32Array(3 * side * side);
	const uvs = new Float32Array(2 * side * side);
	for (let at = 0; at < side * side; at++) {
		const [u, v] = [((at % side) + 0.5) / side, (Math.floor(at / side) + 0.5) / side];
		positions.set([(u * side * cell) / 1000, (v * side * cell) / 1000, parameters.length], 3 * at);
		uvs.set([u, v], 2 * at);
	}
	const hex = look[face === "upper" ? "green" : "under"] as string;
	const colours = bladeColours({ positions, uvs }, { vein: cover, edge }, veinMap(leaf), look, hex);
	return drawn(raster, face, (pixels, to, at) => {
		const [red, green, blue] = colours.subarray(3 * at, 3 * at + 3);
		pixels.set(
			encoded([red, green, blue]).map((value) => Math.round(255 * Math.min(1, value))),
			to,
		);
	});
}

/** A picture of a face, cell by cell: `to` in its pixels, `at` in the raster. */
function drawn(
	{ side }: VeinRaster,
	face: Side,
	draw: (pixels: Uint8Array, to: number, at: number, column: number, row: number) => void,
): Picture {
	const pixels = new Uint8Array(3 * side * side);
	for (let y = 0; y < side; y++) {
		for (let x = 0; x < side; x++) {
			const column = face === "upper" ? x : side - 1 - x;
			const row = side - 1 - y;
			draw(pixels, 3 * (y * side + x), row * side + column, column, row);
		}
	}
	return { width: side, height: side, pixels };
}

/** How steeply veins rise there, to the right and upwards. */
function slopeAt({ side, cell, height }: VeinRaster, column: number, row: number): [number, number] {
	const at = (x: number, y: number) =>
		height[Math.min(side - 1, Math.max(0, y)) * side + Math.min(side - 1, Math.max(0, x))];
	return [
		(at(column + 1, row) - at(column - 1, row)) / (2 * cell),
		(at(column, row + 1) - at(column, row - 1)) / (2 * cell),
	];
}
