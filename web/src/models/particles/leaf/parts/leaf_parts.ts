/** A leaf in parts: the two faces of its blade with pictures laid on, its petiole, and particles on their way. */
import { linear } from "../../../../plant/colour";
import type { Part } from "../../../../plant/part";
import { partsOf } from "../../../../plant/parts_of";
import type { Leaf } from "../grown";
import type { LeafSpecimen } from "../specimen";
import { asSeen } from "./as_seen";
import { FacePictures } from "./face_pictures";
import { bladeMaterial, FACES, particleMaterial, petioleMaterial } from "./materials";

/** Pixels to a side of the pictures, of what stays and of what is on its way. */
const [SIDE, PASSING_SIDE] = [1024, 256];

/** Pictures by the leaf that they show, so that other colours find its veins drawn. */
const drawn = new WeakMap<Leaf, FacePictures>();

/** @throws Error with a message for people where the leaf was asked for without meshes */
export function* leafParts(leaf: Leaf, specimen: Pick<LeafSpecimen, "look" | "parameters" | "seed">): Generator<Part> {
	const { meshes, organs } = leaf;
	const { look, parameters } = specimen;
	if (meshes.length === 0 && leaf.segments.count > 0 && leaf.notes.length === 0) {
		throw new Error("This growth has no meshes to export: grow it with meshes.");
	}
	// What grows in passing does not ask what sky there is.
	const side = meshes.some(({ sky }) => sky) ? SIDE : PASSING_SIDE;
	const pictures = drawn.get(leaf) ?? new FacePictures(leaf, parameters.length, side);
	drawn.set(leaf, pictures);
	for (const face of ["upper", "lower"] as const) {
		const mesh = meshes.find(({ name }) => name === face);
		if (!mesh) continue;
		const { picture, mean } = pictures.colour(specimen, face);
		const textures = { colour: picture, normal: pictures.normal(parameters, face) };
		const material = { ...bladeMaterial(look, face), colour: mean, textures };
		yield { name: FACES[face], shape: { mesh: { ...mesh, name: FACES[face], uvs: asSeen(mesh.uvs, face) }, material } };
	}
	// Organs know meshes by their place among all.
	const others = meshes.map((mesh) => (mesh.name in FACES ? { ...mesh, indices: new Uint32Array(0) } : mesh));
	yield* partsOf(
		{ meshes: others, organs },
		{ stem: petioleMaterial(look), skin: particleMaterial(linear(look.vein_colour as string)) },
	);
}
