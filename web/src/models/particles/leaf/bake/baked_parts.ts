/** A leaf as a light mesh, what is fine of it in textures: for games and distant views. */
import type { Part } from "../../../../plant/part";
import { partsOf } from "../../../../plant/parts_of";
import type { Mesh } from "../../../../plant/plant";
import type { Leaf } from "../grown";
import { bladeMaterial, fleshOf, petioleMaterial } from "../parts/materials";
import type { LeafSpecimen } from "../specimen";
import { lightMesh } from "./light_mesh";
import { facePictures, type Side } from "./pictures";
import { veinRaster } from "./vein_raster";

export interface BakeOptions {
	/** Pixels to a side of each texture. */
	pixels?: number;
	/** Cells to a side of the blade's square, each with a vertex at most. */
	cells?: number;
}

/** @throws Error with a message for people where the leaf has no blade */
export function* bakedParts(leaf: Leaf, specimen: LeafSpecimen, options: BakeOptions = {}): Generator<Part> {
	const { pixels = 1024, cells = 24 } = options;
	const { look, parameters } = specimen;
	const upper = leaf.meshes.find(({ name }) => name === "upper");
	if (!upper) throw new Error("This growth has no blade to export: grow it with meshes.");
	const light = lightMesh(upper, leaf.faces.upper.edge, cells);
	const raster = veinRaster(leaf, parameters.length, pixels);
	for (const side of ["upper", "lower"] as const) {
		const title = `Blade, ${side} face`;
		const material = {
			...bladeMaterial(look, title, look[side === "upper" ? "green" : "under"] as string),
			...fleshOf(look, parameters.thickness / 1000),
			textures: facePictures(leaf, specimen, raster, side),
		};
		yield { name: title, shape: { mesh: seen(light, side), material } };
	}
	const stalk = leaf.meshes.filter(({ name }) => name === "petiole").map(({ sky: _, ...mesh }) => mesh);
	yield* partsOf({ meshes: stalk, organs: { ...leaf.organs, count: 0 } }, { stem: petioleMaterial(look) });
}

/** One side of a sheet, with texture coordinates as bake/pictures.ts has them. */
function seen({ positions, normals, uvs, indices }: Mesh, side: Side): Mesh {
	const isUpper = side === "upper";
	return {
		positions,
		normals: isUpper ? normals : normals.map((value) => -value),
		uvs: uvs.map((value, at) => (at % 2 === 0 && isUpper ? value : 1 - value)),
		indices: isUpper ? indices : indices.map((_, at) => indices[at % 3 === 0 ? at : at % 3 === 1 ? at + 1 : at - 1]),
	};
}
