/** The parts of a leaf: the two textured faces of its blade, its petiole, and moving particles. */

import type { Part } from "../../../plant/part";
import { partsOf } from "../../../plant/parts_of";
import type { Leaf } from "../grown";
import { text } from "../messages.generated";
import type { LeafSpecimen } from "../specimen";
import { asSeen } from "./as_seen";
import { FacePictures, type FaceTextures, PREVIEW_SIDE, SIDE } from "./face_pictures";
import { bladeMaterial, FACES, particleMaterial, petioleMaterial, type Side } from "./materials";

/** Textures by leaf, so that a change of colours reuses the veins. */
const picturesOf = new WeakMap<Leaf, FacePictures>();

/**
 * Yields the parts.
 * @param faces textures of the blade's faces; where absent, they are computed at once, which takes 0.1 s
 * @throws Error with a message for users where the leaf was grown without meshes
 */
export function* leafParts(
	leaf: Leaf,
	specimen: Pick<LeafSpecimen, "look" | "parameters" | "seed">,
	faces: (side: Side) => FaceTextures = (side) => faceTextures(leaf, specimen, side),
): Generator<Part> {
	const { meshes, organs } = leaf;
	const { look } = specimen;
	if (meshes.length === 0 && leaf.segments.count > 0 && leaf.notes.length === 0) {
		throw new Error(text("no_meshes"));
	}
	for (const side of ["upper", "lower"] as const) {
		const mesh = meshes.find(({ name }) => name === side);
		if (!mesh) continue;
		const { mean, ...textures } = faces(side);
		const material = { ...bladeMaterial(look, side), colour: mean, textures };
		yield { name: FACES[side], shape: { mesh: { ...mesh, name: FACES[side], uvs: asSeen(mesh.uvs, side) }, material } };
	}
	// Organs refer to meshes by their indices.
	const others = meshes.map((mesh) => (mesh.name in FACES ? { ...mesh, indices: new Uint32Array(0) } : mesh));
	yield* partsOf({ meshes: others, organs }, { stem: petioleMaterial(look), skin: particleMaterial(look) });
}

/** Computes the textures of a face, with fewer pixels in previews. */
function faceTextures(
	leaf: Leaf,
	specimen: Pick<LeafSpecimen, "look" | "parameters" | "seed">,
	side: Side,
): FaceTextures {
	// Previews have no visibility of the sky.
	const pixels = leaf.meshes.some(({ sky }) => sky) ? SIDE : PREVIEW_SIDE;
	const pictures = picturesOf.get(leaf) ?? new FacePictures(leaf, specimen.parameters.length, pixels);
	picturesOf.set(leaf, pictures);
	return pictures.face(specimen, side);
}
