/** Trees and roots: trails, and for each vertex of their tubes the segment that the vertex surrounds. */
import type { Answer } from "../../../core/core";
import type { Wooden } from "../../../plant/wood/wooden";
import { readTrailPlant, type TrailPlant } from "../trails";

export type WoodenPlant = TrailPlant & Wooden;

/** Reads a tree or a root; the segments of the vertices are absent where the plant was grown without meshes. */
export function readWoodenPlant(answer: Answer): WoodenPlant {
	const { columns } = answer;
	const name = "mesh.stems.segment";
	return { ...readTrailPlant(answer), ...(columns.has(name) ? { vertexSegments: columns.uint32(name) } : {}) };
}
