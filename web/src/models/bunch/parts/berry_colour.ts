/**
 * The colours of natural berries, vertex by vertex: what the view shows of their skins, so that any viewer does. What is
 * finer than vertices (fine noise, lenticels) is taken at its mean.
 */
import { clamp, mix, smoothstep } from "../../../plant/colour";
import { noise } from "../../../plant/noise";
import type { BerrySurfaces, Grown } from "../grown";
import { halvesOf, traitOf } from "../traits";
import { type BerryTint, tintOf } from "./berry_tint";
import type { Skin } from "./skin";
import { COARSE, HALO, LEAST_LIGHT, MOTTLE, RIND, SCAR, SEAT, TURNING, WAX } from "./skin_rules";

/** The mean of the fine noise. */
const FINE = 0.5;
/** The scar's edge, as v: as soft as the pattern's rings lie apart there. */
const SCAR_EDGE = 0.02;

/** How much of each vertex of the pattern is marked, by v. */
interface Marks {
	scar: Float32Array;
	halo: Float32Array;
	seat: Float32Array;
}

/** How much of the scar there is at `v`: 0 skin … 1 scar. */
export function scarShare(v: number, scar: number): number {
	return smoothstep(scar - SCAR_EDGE, scar, v);
}

/** 3 × vertices × berries, linear light, 0 … 1, in the order of `surfaces`. */
export function berryColours(grown: Grown, surfaces: BerrySurfaces, skin: Skin): Float32Array {
	const colours = new Float32Array(surfaces.positions.length);
	const marks = marksOf(surfaces, skin.fruit.scar);
	for (let i = 0; i < grown.berries.count; i++) paint(colours, grown, i, surfaces, skin, marks);
	return colours;
}

function marksOf({ uvs }: BerrySurfaces, from: number): Marks {
	const along = Float32Array.from({ length: uvs.length / 2 }, (_, vertex) => uvs[2 * vertex + 1]);
	const scar = along.map((v) => scarShare(v, from));
	return {
		scar,
		halo: along.map((v, i) => HALO.share * smoothstep(from - HALO.width, from - HALO.end, v) * (1 - scar[i])),
		seat: along.map((v) => SEAT.share * (1 - smoothstep(SEAT.from, SEAT.to, v))),
	};
}

/** Writes the colours of berry `index`. */
function paint(
	colours: Float32Array,
	grown: Grown,
	index: number,
	{ positions, normals, pressed }: BerrySurfaces,
	skin: Skin,
	{ scar, halo, seat }: Marks,
): void {
	const { berries } = grown;
	const tint = tintOf(grown, index, skin);
	const { unripe, ripe } = pigments(tint);
	const turned = traitOf(berries, index, "turned");
	const shrivel = traitOf(berries, index, "shrivel");
	const { grooves, depth, rind } = skin.fruit;
	const blotched = mix(1, RIND.least + RIND.span * FINE, rind);
	const within = ballOf(grown, index);
	for (let vertex = 0; vertex < scar.length; vertex++) {
		const at = 3 * (index * scar.length + vertex);
		const { x, y, z, along } = within(positions, at);
		const coarse = noiseAt(x, y, z, tint.phase);
		const share = turnedAt(turned, along, coarse, skin.uneven);
		const mottle = mottleAt(coarse, skin.uneven);
		const high = smoothstep(depth[0], depth[1], Math.sqrt(x * x + y * y + z * z));
		const bloom = skin.bloom * tint.bloom * (1 - scar[vertex]);
		const waxed = waxAt(bloom, coarse, normals[at + 1], pressed[at / 3] / 255, shrivel);
		for (let k = 0; k < 3; k++) {
			let colour = mottle * Math.exp(mix(unripe[k], ripe[k], share)) * mix(grooves[k], 1, high) * blotched;
			colour = mix(colour, HALO.skin * colour + HALO.light, halo[vertex]);
			colour = mix(colour, SEAT.skin * colour + SEAT.colour[k], seat[vertex]);
			colour = mix(colour, SCAR.colour[k] + SCAR.skin * colour, SCAR.share * scar[vertex]);
			colours[at + k] = clamp(mix(colour, skin.wax[k], waxed));
		}
	}
}

/** A berry's colours as depths of pigment. */
function pigments({ unripe, ripe }: BerryTint) {
	const depth = (value: number) => Math.log(value + LEAST_LIGHT);
	return { unripe: unripe.map(depth), ripe: ripe.map(depth) };
}

/** Takes places into the space where the berry is the unit ball; `along` its axis, −1 at the seat … 1 at the tip. */
function ballOf({ berries }: Grown, index: number) {
	const [cx, cy, cz] = berries.spheres.subarray(4 * index, 4 * index + 3);
	const [dx, dy, dz] = berries.directions.subarray(3 * index, 3 * index + 3);
	const [width, length] = halvesOf(berries, index);
	const found = { x: 0, y: 0, z: 0, along: 0 };
	return (positions: Float32Array, at: number) => {
		const [x, y, z] = [positions[at] - cx, positions[at + 1] - cy, positions[at + 2] - cz];
		const shift = (x * dx + y * dy + z * dz) * (width / length - 1);
		found.x = (x + dx * shift) / width;
		found.y = (y + dy * shift) / width;
		found.z = (z + dz * shift) / width;
		found.along = found.x * dx + found.y * dy + found.z * dz;
		return found;
	};
}

function noiseAt(x: number, y: number, z: number, phase: number): number {
	const shift = phase * COARSE.phase;
	return noise(x * COARSE.cells + shift, y * COARSE.cells + shift, z * COARSE.cells + shift);
}

/** How far the skin has turned at a place `along` the axis. */
function turnedAt(turned: number, along: number, coarse: number, uneven: number): number {
	const width = TURNING.width + TURNING.uneven * uneven;
	const late = clamp(0.5 - TURNING.along * along + TURNING.coarse * uneven * (coarse - 0.5));
	return smoothstep(0, 1, (turned * (1 + width) - late) / width);
}

function mottleAt(coarse: number, uneven: number): number {
	return MOTTLE.least + MOTTLE.span * mix(0.5, coarse, MOTTLE.share + MOTTLE.uneven * uneven);
}

/** The share of the skin that wax hides, seen face on. */
function waxAt(bloom: number, coarse: number, up: number, pressed: number, shrivel: number): number {
	const [firm, gone] = WAX.pressed;
	const left =
		(1 - smoothstep(firm, gone, pressed)) * smoothstep(WAX.brushed[0], WAX.brushed[1], coarse + WAX.fine * FINE);
	const patches = smoothstep(WAX.patches[0], WAX.patches[1], WAX.coarseShare * coarse + WAX.fineShare * FINE);
	const depth = WAX.depth * bloom * mix(WAX.rubbed, 1, left) * mix(WAX.bare, 1, patches) * (WAX.side + WAX.up * up);
	return (1 - Math.exp(-depth / (WAX.grazing + 1))) * (1 - WAX.dry * shrivel);
}
