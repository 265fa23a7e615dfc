/** A closed mesh as the boundary of a plant. */

import type { ClosedMesh } from "../../../specimen/closed_mesh";
import { withParameters } from "../../../specimen/edit";
import type { ModelSchema } from "../../../specimen/model_schema";
import type { Table } from "../../../specimen/table";
import type { BoundedSpecimen } from "./bounded";

/** Returns the parameters of a boundary that is a mesh, `tall` metres high, with the mesh's proportions. */
export function meshParameters(table: Table, { points }: ClosedMesh, tall: number): Record<string, number> {
	const shape = table.entry("shape");
	const span = (axis: number) => {
		const along = points.filter((_, i) => i % 3 === axis);
		return (
			along.reduce((most, value) => Math.max(most, value), 0) -
			along.reduce((least, value) => Math.min(least, value), 0)
		);
	};
	return {
		shape: shape?.kind === "choice" ? shape.options.indexOf("mesh") : 0,
		width: tall * span(0),
		depth: tall * span(2),
	};
}

/**
 * Returns a specimen whose boundary is the mesh of a file, as high as the boundary was.
 * @param height the key of the parameter for the boundary's height
 * @throws MeshFileError with a message for users
 */
export async function boundedBy<S extends BoundedSpecimen>(
	schema: ModelSchema<S>,
	specimen: S,
	file: File,
	height: string,
): Promise<S> {
	const { readMeshFile } = await import("../../../import/mesh_file/read");
	const volume = await readMeshFile(file);
	const parameters = meshParameters(schema.table, volume, specimen.parameters[height]);
	return { ...withParameters(schema, specimen, parameters), volume };
}
