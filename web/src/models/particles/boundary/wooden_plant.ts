/** Trees and roots: trails, and of each vertex of their tubes the segment that it goes around. */
import type { Answer } from "../../../core/core";
import { readTrailPlant, type TrailPlant } from "../trails";

export interface WoodenPlant extends TrailPlant {
	/** By vertex of the mesh `stems`; absent without meshes. */
	bearing?: Uint32Array;
}

export function readWoodenPlant(answer: Answer): WoodenPlant {
	const { columns } = answer;
	const name = "mesh.stems.segment";
	return { ...readTrailPlant(answer), ...(columns.has(name) ? { bearing: columns.words(name) } : {}) };
}
