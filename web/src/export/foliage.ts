/** Leaves and cane in a GLB: one node for each, so that a leaf can be taken off or turned by itself. */
import type { Foliage } from "../core/grown";
import type { Specimen } from "../specimen/specimen";
import type { GltfDocument } from "./gltf_document";
import { CANE, leafMaterial, type Material, stemMaterial } from "./materials";
import { cut } from "./meshes";
import { foliageNames } from "./names";

/** What each kind of part is made of. */
export function foliageMaterials({ look, parameters }: Specimen): Record<Foliage["parts"][number]["kind"], Material> {
	return { cane: CANE, leaf: leafMaterial(parameters.age), petiole: { ...stemMaterial(look), name: "Petiole" } };
}

/** Appends a node for each part that has triangles; returns their indices. */
export function addFoliage(document: GltfDocument, foliage: Foliage, specimen: Specimen): number[] {
	const values = foliageMaterials(specimen);
	const materials = new Map<string, number>();
	const names = foliageNames(foliage.parts);
	return foliage.parts.flatMap((part, index) => {
		if (part.indexCount === 0) return [];
		const material = materials.get(part.kind) ?? document.material(values[part.kind]);
		materials.set(part.kind, material);
		const name = names[index];
		return document.node({ name, ...document.mesh(name, cut(foliage, part), material) });
	});
}
