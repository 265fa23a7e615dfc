/** What members look like, from near and from far. */
import type { Material } from "../plant/material";
import { everyPart, type Part } from "../plant/part";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { Member, MemberMesh } from "./member";
import type { Model } from "./model";

/** Triangles of the levels of what makes none itself, from near to far. */
const TRIANGLES = [3000, 600];

/** Materials that are alike, as one object each. Pictures are left out: their mean is the colour. */
export class Looks {
	readonly #known = new Map<string, Material>();

	of({ textures: _, flesh: __, ...material }: Material): Material {
		const key = JSON.stringify(material);
		const known = this.#known.get(key) ?? material;
		this.#known.set(key, known);
		return known;
	}
}

/** The levels of a plant and how far it reaches; no levels where it was grown without meshes. */
export async function levelsOf(
	model: Model,
	plant: Plant,
	specimen: Specimen,
	meshes: boolean,
	looks: Looks,
): Promise<Pick<Member, "levels" | "extent">> {
	if (!meshes) return { levels: [], extent: extentOf([plant.segments.ends]) };
	const own = model.levels?.(plant, specimen);
	const parts = own ?? (await lighter(model.parts(plant, specimen)));
	const levels = parts.map((level) => [...meshesOf(level, looks)]);
	return { levels, extent: extentOf(levels[0].map(({ mesh }) => mesh.positions)) };
}

/** What makes no levels is merged and made light, as files are. */
async function lighter(parts: Iterable<Part>): Promise<Part[][]> {
	const { lightParts } = await import("../export/light");
	let from = [...parts];
	const levels: Part[][] = [];
	for (const triangles of TRIANGLES) {
		from = await lightParts(from, { triangles, pixels: 1 });
		levels.push(from);
	}
	return levels;
}

function* meshesOf(parts: Iterable<Part>, looks: Looks): Generator<MemberMesh> {
	for (const { shape } of everyPart(parts)) {
		if (!shape || shape.mesh.indices.length === 0) continue;
		const { positions, normals, colours, sky, indices } = shape.mesh;
		const mesh = {
			positions,
			normals,
			uvs: new Float32Array(0),
			indices,
			...(colours ? { colours } : {}),
			...(sky ? { sky } : {}),
		};
		yield { mesh, material: looks.of(shape.material) };
	}
}

function extentOf(points: readonly Float32Array[]): Member["extent"] {
	let [low, high, square] = [0, 0, 0];
	for (const each of points) {
		for (let i = 0; i < each.length; i += 3) {
			low = Math.min(low, each[i + 1]);
			high = Math.max(high, each[i + 1]);
			square = Math.max(square, each[i] ** 2 + each[i + 2] ** 2);
		}
	}
	return { low, high, out: Math.sqrt(square) };
}
