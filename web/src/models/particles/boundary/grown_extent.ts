/** Extent of the fully grown plant, for framing. */
import type { Table } from "../../../specimen/table";
import type { BoundedSpecimen } from "./bounded";
import type { BoundaryLayout } from "./editor/boundary_layout";
import { shellsOf } from "./editor/shell";

/**
 * Returns points of the fully grown boundary, metres, for plants whose boundary grows with age: the view frames these
 * points, so that a young plant appears small. Empty for other plants.
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
