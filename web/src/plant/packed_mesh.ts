/** Meshes in a third of the memory: for thousands of plants at once. */
import type { PartMesh } from "./part";

/** Whole numbers up to this represent −1 … 1, colours 0 … 1. */
export const PLACE_STEPS = 32_767;
const NORMAL_STEPS = 127;
export const COLOUR_STEPS = 65_535;

/** Triangles with normalised integers, as graphics cards accept them. */
export interface PackedMesh {
	/** Metres per 1 in positions; the same in all levels of a plant. */
	readonly unit: number;
	/** 3 × vertices. */
	readonly positions: Int16Array<ArrayBuffer>;
	/** 3 × vertices. */
	readonly normals: Int8Array<ArrayBuffer>;
	/** The share of the sky that each vertex sees: 255 all. */
	readonly sky: Uint8Array<ArrayBuffer>;
	/** 3 × vertices, linear light. */
	readonly colours?: Uint16Array<ArrayBuffer>;
	/** 3 × triangles. */
	readonly indices: Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;
}

/** Returns the largest coordinate of meshes along the axes, metres; above 0 even without meshes. */
export function reachOf(meshes: Iterable<Pick<PartMesh, "positions">>): number {
	let reach = 1e-6;
	for (const { positions } of meshes) for (const value of positions) reach = Math.max(reach, Math.abs(value));
	return reach;
}

/**
 * Packs a mesh: positions to a 32,767th of `unit`, normals to half a degree, without texture coordinates.
 * @param unit at least the mesh's largest coordinate
 */
export function packed({ positions, normals, colours, sky, indices }: PartMesh, unit: number): PackedMesh {
	const vertices = positions.length / 3;
	const steps = <T extends Int16Array | Int8Array | Uint16Array>(into: T, values: Float32Array, by: number): T => {
		for (let i = 0; i < values.length; i++) into[i] = Math.round(by * values[i]);
		return into;
	};
	return {
		unit,
		positions: steps(new Int16Array(3 * vertices), positions, PLACE_STEPS / unit),
		normals: steps(new Int8Array(3 * vertices), normals, NORMAL_STEPS),
		sky: sky ? Uint8Array.from(sky) : new Uint8Array(vertices).fill(255),
		...(colours ? { colours: steps(new Uint16Array(3 * vertices), colours, COLOUR_STEPS) } : {}),
		indices: vertices > COLOUR_STEPS ? Uint32Array.from(indices) : Uint16Array.from(indices),
	};
}

/** Unpacks a mesh. */
export function unpacked({ unit, positions, normals, colours, sky, indices }: PackedMesh): PartMesh {
	const lengths = new Float32Array(normals.length);
	for (let i = 0; i < normals.length; i += 3) {
		const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
		for (let k = 0; k < 3; k++) lengths[i + k] = normals[i + k] / length;
	}
	return {
		positions: Float32Array.from(positions, (value) => (value * unit) / PLACE_STEPS),
		normals: lengths,
		uvs: new Float32Array(0),
		indices: Uint32Array.from(indices),
		sky,
		...(colours ? { colours: Float32Array.from(colours, (value) => value / COLOUR_STEPS) } : {}),
	};
}
