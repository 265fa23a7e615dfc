/** What the bench asks of growth grammars. A module of its own, for what it fetches has to be there once it has been read. */
import { writeContainer } from "../../web/src/core/container";
import { model } from "../../web/src/models/growth/index";
import { encodeGrowth } from "../../web/src/models/growth/request";
import { fromPreset } from "../../web/src/specimen/from_preset";

const plain = fromPreset(model, "table-1-sigma1");
await model.prepare(plain);

/** All levels of a tree of σ1 in leaf, and nothing else. */
export function levelsOf(seed: number, steps: number): Uint8Array {
	const specimen = { ...plain, seed, parameters: { ...plain.parameters, steps } };
	return writeContainer(encodeGrowth(specimen, { levels: true, meshes: false, measures: false }));
}
