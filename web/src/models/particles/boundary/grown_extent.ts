/** Room for the grown plant, whatever its age. */
import type { Table } from "../../../specimen/table";
import type { BoundedSpecimen } from "./bounded";
import type { BoundaryLayout } from "./editor/boundary_layout";
import { shellsOf } from "./editor/shell";

/**
 * Where a boundary grows with its age: points of the grown one, metres, for the view to hold, so that a young plant is seen to
 * be small. Else none.
 */
export function grownExtent<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	table: Table,
	specimen: S,
): Float32Array {
	if (table.option(specimen, "life") !== "grow") return new Float32Array(0);
	return Float32Array.from([
		...shellsOf(layout, specimen).flatMap(({ points }) => points),
		...layout.targets(specimen),
	]);
}
