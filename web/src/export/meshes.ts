import type { BerrySurfaces, Grown, Mesh, StemMesh, StemPart, Trait } from "../models/bunch/grown";
import { traitOf } from "./traits";

/** What the stems and berries are drawn with: one berry for all (paper), or each its own surface (natural). */
export interface Meshes {
	stem: StemMesh;
	/** Absent as the other one where there are no berries. */
	berry?: Mesh;
	surfaces?: BerrySurfaces;
}

/** The meshes of a growth, or an error that says how to get them. */
export function requireMeshes({ stem, berry, surfaces, berries }: Grown): Meshes {
	if (!stem || (berries.count > 0 && !berry && !surfaces)) {
		throw new Error("This growth has no meshes to export: grow it with meshes.");
	}
	return berries.count > 0 ? { stem, berry, surfaces } : { stem };
}

/** One part of a mesh as a mesh of its own, indices counted from its first vertex. */
export function cut(mesh: Mesh, part: Omit<StemPart, "axis">): Mesh {
	const { firstVertex, vertexCount, firstIndex, indexCount } = part;
	const lastVertex = firstVertex + vertexCount;
	return {
		positions: mesh.positions.subarray(3 * firstVertex, 3 * lastVertex),
		normals: mesh.normals.subarray(3 * firstVertex, 3 * lastVertex),
		uvs: mesh.uvs.subarray(2 * firstVertex, 2 * lastVertex),
		indices: mesh.indices.subarray(firstIndex, firstIndex + indexCount).map((index) => index - firstVertex),
	};
}

/** The mean of a trait over all berries, `without` where there are none. */
export function meanOf({ berries }: Grown, trait: Trait, without = 0): number {
	let sum = 0;
	for (let i = 0; i < berries.count; i++) sum += traitOf(berries, i, trait);
	return berries.count > 0 ? sum / berries.count : without;
}
