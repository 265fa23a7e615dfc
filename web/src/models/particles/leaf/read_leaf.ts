import type { Answer } from "../../../core/core";
import { readTrailPlant } from "../trails";
import type { Leaf } from "./grown";

const NONE = new Float32Array(0);

/** Columns of an answer → leaf (wasm-core/src/models/particles/leaf/model.hpp). */
export function readLeaf(answer: Answer): Leaf {
	const { columns } = answer;
	const floats = (name: string) => (columns.has(name) ? columns.floats(name) : NONE);
	return {
		...readTrailPlant(answer),
		chart: columns.floats("segments.chart"),
		margin: columns.floats("margin"),
		veined: floats("mesh.blade.vein"),
		away: floats("mesh.blade.away"),
	};
}
