import type { Grown, Mesh, StemMesh } from "../core/grown";

/** The meshes of a growth, or an error that says how to get them. */
export function requireMeshes({ stem, berry }: Grown): { stem: StemMesh; berry: Mesh } {
	if (!stem || !berry) throw new Error("This growth has no meshes to export: grow it with meshes.");
	return { stem, berry };
}
