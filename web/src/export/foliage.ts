/** Leaves and cane in a GLB: one node for each, so that a leaf can be taken off or turned by itself. */
import type { Foliage, FoliagePart, Grown } from "../models/bunch/grown";
import type { GltfDocument } from "./gltf_document";
import { CANE, leafMaterial, type Material, PETIOLE } from "./materials";
import { cut, meanOf } from "./meshes";
import { foliageNames } from "./names";

/** What each kind of part is made of. */
export function foliageMaterials(grown: Grown): Record<FoliagePart["kind"], Material> {
	// Leaves turn as berries dry.
	return { cane: CANE, leaf: leafMaterial(meanOf(grown, "shrivel")), petiole: PETIOLE };
}

/** Appends a node for each part that has triangles; returns their indices. */
export function addFoliage(document: GltfDocument, grown: Grown, foliage: Foliage): number[] {
	const values = foliageMaterials(grown);
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
