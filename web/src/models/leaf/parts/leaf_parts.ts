/** A leaf in parts: the two faces of its blade with pictures laid on, its petiole, and particles on their way. */
import type { Part } from "../../../plant/part";
import { partsOf } from "../../../plant/parts_of";
import type { Leaf } from "../grown";
import type { LeafSpecimen } from "../specimen";
import { asSeen } from "./as_seen";
import { FacePictures, type FaceTextures, PREVIEW_SIDE, SIDE } from "./face_pictures";
import { bladeMaterial, FACES, particleMaterial, petioleMaterial, type Side } from "./materials";

/** Pictures by the leaf that they show, so that other colours find its veins drawn. */
const drawn = new WeakMap<Leaf, FacePictures>();

/**
 * @param faces what the blade's faces are laid with; where absent, they are painted here and now, which takes a tenth of a second
 * @throws Error with a message for people where the leaf was asked for without meshes
 */
export function* leafParts(
	leaf: Leaf,
	specimen: Pick<LeafSpecimen, "look" | "parameters" | "seed">,
	faces: (side: Side) => FaceTextures = (side) => painted(leaf, specimen, side),
): Generator<Part> {
	const { meshes, organs } = leaf;
	const { look } = specimen;
	if (meshes.length === 0 && leaf.segments.count > 0 && leaf.notes.length === 0) {
		throw new Error("This growth has no meshes to export: grow it with meshes.");
	}
	for (const side of ["upper", "lower"] as const) {
		const mesh = meshes.find(({ name }) => name === side);
		if (!mesh) continue;
		const { mean, ...textures } = faces(side);
		const material = { ...bladeMaterial(look, side), colour: mean, textures };
		yield { name: FACES[side], shape: { mesh: { ...mesh, name: FACES[side], uvs: asSeen(mesh.uvs, side) }, material } };
	}
	// Organs know meshes by their place among all.
	const others = meshes.map((mesh) => (mesh.name in FACES ? { ...mesh, indices: new Uint32Array(0) } : mesh));
	yield* partsOf({ meshes: others, organs }, { stem: petioleMaterial(look), skin: particleMaterial(look) });
}

function painted(leaf: Leaf, specimen: Pick<LeafSpecimen, "look" | "parameters" | "seed">, side: Side): FaceTextures {
	// What grows in passing does not ask what sky there is.
	const pixels = leaf.meshes.some(({ sky }) => sky) ? SIDE : PREVIEW_SIDE;
	const pictures = drawn.get(leaf) ?? new FacePictures(leaf, specimen.parameters.length, pixels);
	drawn.set(leaf, pictures);
	return pictures.face(specimen, side);
}
