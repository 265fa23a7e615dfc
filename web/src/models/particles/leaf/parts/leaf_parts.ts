/** A leaf in parts: the two faces of its blade in colours of their own, its petiole, and particles on their way. */
import { linear, smoothstep } from "../../../../plant/colour";
import type { Part } from "../../../../plant/part";
import { partsOf } from "../../../../plant/parts_of";
import type { PlantMesh } from "../../../../plant/plant";
import type { BladeFace, Leaf } from "../grown";
import type { LeafSpecimen } from "../specimen";
import { bladeColours } from "./blade_colour";
import { bladeMaterial, particleMaterial, petioleMaterial } from "./materials";
import { awayAt, type VeinMap, veinMap } from "./vein_map";

/** The faces of the blade, by the names of their meshes: as people call them, and the look's colour. */
export const FACES: Readonly<Record<string, { title: string; colour: string }>> = {
	upper: { title: "Blade, upper face", colour: "green" },
	lower: { title: "Blade, lower face", colour: "under" },
};

export interface LeafPartsOptions {
	/** Whether colours of vertices show the veins; the default is yes. */
	veins?: boolean;
}

/** @throws Error with a message for people where the leaf was asked for without meshes */
export function* leafParts(
	leaf: Leaf,
	{ look }: Pick<LeafSpecimen, "look">,
	{ veins = true }: LeafPartsOptions = {},
): Generator<Part> {
	const { meshes, organs, faces } = leaf;
	if (meshes.length === 0 && leaf.segments.count > 0 && leaf.notes.length === 0) {
		throw new Error("This growth has no meshes to export: grow it with meshes.");
	}
	const map = veinMap(leaf);
	for (const mesh of meshes) {
		const face = FACES[mesh.name];
		if (!face) continue;
		const hex = look[face.colour] as string;
		const colours = bladeColours(
			mesh,
			veins ? plainly(mesh, faces[mesh.name], map) : veinless(faces[mesh.name]),
			map,
			look,
			hex,
		);
		const material = bladeMaterial(look, face.title, hex);
		yield { name: face.title, shape: { mesh: { ...mesh, colours }, material, variant: mesh.name } };
	}
	// Organs know meshes by their place among all.
	const others = meshes.map((mesh) => (mesh.name in FACES ? { ...mesh, indices: new Uint32Array(0) } : mesh));
	yield* partsOf(
		{ meshes: others, organs },
		{ stem: petioleMaterial(look), skin: particleMaterial(linear(look.vein_colour as string)) },
	);
}

/** Of finer veins a mesh has no more than dots: they are left out. */
function plainly({ uvs }: PlantMesh, { vein, edge }: BladeFace, map: VeinMap): BladeFace {
	const shown = vein.map((share, at) => share * (1 - smoothstep(0.12, 0.3, awayAt(map, uvs[2 * at], uvs[2 * at + 1]))));
	return { vein: shown, edge };
}

function veinless({ vein, edge }: BladeFace): BladeFace {
	return { vein: new Float32Array(vein.length), edge };
}
