/** A leaf as a simplified mesh with its detail baked into textures: for games and distant views. */

import type { Part } from "../../../plant/part";
import { partsOf } from "../../../plant/parts_of";
import type { Mesh } from "../../../plant/plant";
import type { Leaf } from "../grown";
import { text } from "../messages.generated";
import { asSeen } from "../parts/as_seen";
import { FacePictures } from "../parts/face_pictures";
import { bladeMaterial, FACES, fleshOf, petioleMaterial, type Side } from "../parts/materials";
import type { LeafSpecimen } from "../specimen";
import { lightMesh } from "./light_mesh";

export interface BakeOptions {
	/** Width and height of each texture, pixels. */
	pixels?: number;
	/** Cells along a side of the blade's square; each cell has at most one vertex. */
	cells?: number;
}

/**
 * Yields the two faces of the blade, with their detail in textures, and the petiole.
 * @throws Error with a message for users where the leaf has no blade
 */
export function* bakedParts(leaf: Leaf, specimen: LeafSpecimen, options: BakeOptions = {}): Generator<Part> {
	const { pixels = 1024, cells = 24 } = options;
	const { look, parameters } = specimen;
	const upper = leaf.meshes.find(({ name }) => name === "upper");
	if (!upper) throw new Error(text("no_blade"));
	const light = lightMesh(upper, leaf.faces.upper.edge, cells);
	const pictures = new FacePictures(leaf, parameters.length, pixels);
	const thickest = pictures.thickest(parameters) / 1000;
	for (const side of ["upper", "lower"] as const) {
		const { picture, mean } = pictures.colour(specimen, side);
		const material = {
			...bladeMaterial(look, side),
			...fleshOf(look, thickest, parameters.thickness / 1000),
			colour: mean,
			textures: {
				colour: picture,
				normal: pictures.normal(parameters, side),
				thickness: pictures.thickness(parameters, side),
			},
		};
		yield { name: FACES[side], shape: { mesh: sideMesh(light, side), material } };
	}
	const stalk = leaf.meshes.filter(({ name }) => name === "petiole").map(({ sky: _, ...mesh }) => mesh);
	yield* partsOf({ meshes: stalk, organs: { ...leaf.organs, count: 0 } }, { stem: petioleMaterial(look) });
}

/**
 * Returns the mesh of one side of the blade, seen from that side: the lower one has inverted normals and the other
 * order of corners in each triangle.
 */
function sideMesh({ positions, normals, uvs, indices }: Mesh, side: Side): Mesh {
	const isUpper = side === "upper";
	return {
		positions,
		normals: isUpper ? normals : normals.map((value) => -value),
		uvs: asSeen(uvs, side),
		indices: isUpper ? indices : indices.map((_, at) => indices[at % 3 === 0 ? at : at % 3 === 1 ? at + 1 : at - 1]),
	};
}
