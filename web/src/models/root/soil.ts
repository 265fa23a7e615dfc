/**
 * The soil around a root as a pit: only its far wall is drawn, so that the root is visible from every side. It is not
 * part of the plant and of no file.
 */
import type { Colour } from "../../plant/colour";
import { clamp, linear, mixed, smoothstep } from "../../plant/colour";
import { noise } from "../../plant/noise";
import type { PartMesh } from "../../plant/part";

/** Bounds of the pit's contents, metres; the ground is at height 0. */
export interface PitBounds {
	low: readonly [x: number, y: number, z: number];
	high: readonly [x: number, y: number, z: number];
}

const AROUND = 160;
const DOWN = 64;
const FLOOR = 12;
/** Margin around the roots, as a share of their extent. */
const ROOM = 0.1;
/** Exponent of the superellipse: 2 is an ellipse, larger values approach a box with round corners. */
const SQUARENESS = 3.2;
/** Thickness of the dark topsoil, metres. */
const HUMUS = 0.28;

/** Builds a pit: the wall ring by ring, then the floor. */
export function buildPit({ low, high }: PitBounds, soil: string): PartMesh {
	const middle = [(low[0] + high[0]) / 2, (low[2] + high[2]) / 2];
	const reach = [0, 2].map((k) => Math.max((high[k] - low[k]) / 2, 0.05) * (1 + ROOM));
	const depth = Math.max(-low[1], 0.05) * (1 + ROOM / 2);
	const rings = DOWN + 1 + FLOOR;
	const positions = new Float32Array(3 * rings * AROUND);
	const normals = new Float32Array(3 * rings * AROUND);
	const colours = new Float32Array(3 * rings * AROUND);
	// Crumbs per metre: about nine along the longest extent, so that a pit of any size looks alike.
	const grain = 9 / Math.max(reach[0], reach[1], depth);
	const tones = tonesOf(soil);
	for (let k = 0; k < AROUND; k++) {
		const [x, z] = outlinePoint((2 * Math.PI * k) / AROUND, reach);
		const normal = inwardNormal(x, z, reach);
		const waver = waverAt(x, z, grain);
		// Each sector of the floor has one colour from the wall to the centre, where the triangles meet.
		const floor = soilColour(tones, [x, -depth, z], 0.6, waverAt(x, z, 0.6));
		for (let ring = 0; ring < rings; ring++) {
			const at = 3 * (ring * AROUND + k);
			// Rings up to DOWN go down the wall; the others run inwards on the floor.
			const inward = Math.max(0, ring - DOWN) / FLOOR;
			const y = -depth * Math.min(1, ring / DOWN);
			const bump = inward > 0 ? 0 : 0.02 * (noise(grain * x, grain * y, grain * z) - 0.5);
			const out = (1 - inward) * (1 + bump);
			positions.set([middle[0] + out * x, y, middle[1] + out * z], at);
			normals.set(inward > 0 ? UP : normal, at);
			colours.set(inward > 0 ? floor : soilColour(tones, [x, y, z], grain, waver), at);
		}
	}
	return { positions, normals, colours, uvs: new Float32Array(2 * rings * AROUND), indices: ringTriangles(rings) };
}

const UP = [0, 1, 0] as const;

/** Returns a point of the pit's outline, a superellipse with half axes rx and rz, metres. */
function outlinePoint(angle: number, [rx, rz]: readonly number[]): [x: number, z: number] {
	const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
	const out = (Math.abs(cosine) ** SQUARENESS + Math.abs(sine) ** SQUARENESS) ** (-1 / SQUARENESS);
	return [out * cosine * rx, out * sine * rz];
}

/** Returns the unit normal into the pit at a point of its outline: the negative gradient of the superellipse. */
function inwardNormal(x: number, z: number, [rx, rz]: readonly number[]): [number, number, number] {
	const slope = (value: number, r: number) => (Math.sign(value) * Math.abs(value / r) ** (SQUARENESS - 1)) / r;
	const [nx, nz] = [slope(x, rx), slope(z, rz)];
	const size = Math.hypot(nx, nz);
	return [-nx / size, 0, -nz / size];
}

/** Returns whether a pit for some bounds is large enough for others. */
export function pitHolds(bounds: PitBounds, { low, high }: PitBounds): boolean {
	return [0, 1, 2].every((k) => {
		const size = bounds.high[k] - bounds.low[k];
		// Slightly less than the margin.
		const slack = 0.45 * ROOM * size;
		return low[k] >= bounds.low[k] - slack && high[k] <= bounds.high[k] + slack;
	});
}

/**
 * Returns the triangles between successive rings of AROUND vertices. They face inwards: seen from outside the near wall
 * is invisible.
 */
function ringTriangles(rings: number): Uint32Array {
	const indices: number[] = [];
	for (let ring = 0; ring + 1 < rings; ring++) {
		for (let k = 0; k < AROUND; k++) {
			const [a, b] = [ring * AROUND + k, ring * AROUND + ((k + 1) % AROUND)];
			indices.push(a, a + AROUND, b, b, a + AROUND, b + AROUND);
		}
	}
	return Uint32Array.from(indices);
}

/** Colours of the humus and of the soil below. */
interface Tones {
	readonly dark: Colour;
	readonly pale: Colour;
}

/** Returns the colours of the soil's layers from its own colour. */
function tonesOf(soil: string): Tones {
	const base = linear(soil);
	return { dark: mixed(base, [0.008, 0.006, 0.004], 0.72), pale: mixed(base, [0.02, 0.014, 0.009], 0.25) };
}

/**
 * Returns the variation of the humus's depth at a position, metres.
 * @param grain crumbs per metre: the frequency of the noise
 */
function waverAt(x: number, z: number, grain: number): number {
	return HUMUS * (noise(0.3 * grain * x + 7, 0, 0.3 * grain * z) - 0.5);
}

/**
 * Returns the colour of the soil at a position (metres; the ground is at height 0): dark humus on top, paler below,
 * with a wavy transition, and with lighter and darker crumbs.
 * @param grain crumbs per metre: the frequency of the coarser noise
 * @param waver variation of the humus's depth at the position, metres (`waverAt`)
 */
function soilColour({ dark, pale }: Tones, [x, y, z]: readonly number[], grain: number, waver: number): Colour {
	const below = smoothstep(0.4 * HUMUS, 1.7 * HUMUS, -y + waver);
	const [red, green, blue] = mixed(dark, pale, below);
	const crumbs =
		0.5 * noise(grain * x, grain * y, grain * z) + 0.5 * noise(2.7 * grain * x, 2.7 * grain * y, 2.7 * grain * z);
	const shade = 0.7 + 0.6 * clamp(crumbs);
	return [red * shade, green * shade, blue * shade];
}
