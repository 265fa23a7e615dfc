/** Meshes and materials of members at several levels of detail. */

import type { Member, MemberMesh } from "../models/member";
import type { Model } from "../models/model";
import type { Material } from "../plant/material";
import { PLACE_STEPS, packed, reachOf } from "../plant/packed_mesh";
import { everyPart, type Part, type Shape } from "../plant/part";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";

/** Triangles of the levels, from near to far, for models without levels of their own. */
const TRIANGLES = [3000, 600];

/** Materials, one object per look. Pictures are dropped: their mean is the colour. */
export class SharedMaterials {
	readonly #known = new Map<string, Material>();

	/** Returns the shared object of a material's look. */
	of({ textures: _, flesh: __, ...material }: Material): Material {
		const key = JSON.stringify(material);
		const known = this.#known.get(key) ?? material;
		this.#known.set(key, known);
		return known;
	}
}

/** Returns the levels and extent of a plant; no levels where it was grown without meshes. */
export async function levelsOf(
	model: Model,
	plant: Plant,
	specimen: Specimen,
	meshes: boolean,
	looks: SharedMaterials,
): Promise<Pick<Member, "levels" | "extent">> {
	if (!meshes) return { levels: [], extent: extentOf(plant.segments.ends, 1) };
	const own = model.levels?.(plant, specimen);
	const parts = own ?? (await lighter(model.parts(plant, specimen)));
	const shapes = parts.map(shapesOf);
	const unit = reachOf(shapes.flat().map(({ mesh }) => mesh));
	const levels = shapes.map((level) =>
		level.map(({ mesh, material }): MemberMesh => ({ mesh: packed(mesh, unit), material: looks.of(material) })),
	);
	// Meshes without triangles have no extent.
	const extents = (levels[0] ?? []).map(({ mesh }) => extentOf(mesh.positions, mesh.unit / PLACE_STEPS));
	const whole = { low: 0, high: 0, out: 0 };
	for (const { low, high, out } of extents) {
		whole.low = Math.min(whole.low, low);
		whole.high = Math.max(whole.high, high);
		whole.out = Math.max(whole.out, out);
	}
	return { levels, extent: whole };
}

/** Merges and simplifies the parts of models without levels, as files do. */
async function lighter(parts: Iterable<Part>): Promise<Part[][]> {
	const { lightParts } = await import("../formats/light");
	let from = [...parts];
	const levels: Part[][] = [];
	for (const triangles of TRIANGLES) {
		from = await lightParts(from, { triangles, pixels: 1 });
		levels.push(from);
	}
	return levels;
}

/** Returns the shapes of all parts with triangles. */
function shapesOf(parts: Iterable<Part>): Shape[] {
	return [...everyPart(parts)].flatMap(({ shape }) => (shape && shape.mesh.indices.length > 0 ? [shape] : []));
}

/**
 * Returns how far points extend: least and greatest height, and greatest distance from the upright axis, metres.
 * @param points x y z each
 * @param unit metres per unit of `points`
 */
function extentOf(points: Float32Array | Int16Array, unit: number): Member["extent"] {
	let [low, high, square] = [0, 0, 0];
	for (let i = 0; i < points.length; i += 3) {
		low = Math.min(low, points[i + 1]);
		high = Math.max(high, points[i + 1]);
		square = Math.max(square, points[i] ** 2 + points[i + 2] ** 2);
	}
	return { low: unit * low, high: unit * high, out: unit * Math.sqrt(square) };
}
