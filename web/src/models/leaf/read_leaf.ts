import type { Answer } from "../../core/core";
import { readTrailPlant } from "../particles/trails";
import type { Leaf } from "./grown";

/**
 * Reads a leaf from the columns of a response (wasm-core/src/models/leaf/model.cpp); `mesh.NAME.edge` marks the blade's
 * faces.
 */
export function readLeaf(answer: Answer): Leaf {
	const { columns } = answer;
	const plant = readTrailPlant(answer);
	const faces = plant.meshes.filter(({ name }) => columns.has(`mesh.${name}.edge`));
	const [left, bottom, size] = columns.floats("chart");
	return {
		...plant,
		chart: columns.floats("segments.chart"),
		margin: columns.floats("margin"),
		square: { left, bottom, size },
		faces: Object.fromEntries(faces.map(({ name }) => [name, { edge: columns.floats(`mesh.${name}.edge`) }])),
	};
}
