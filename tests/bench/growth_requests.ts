/** What the bench asks of growth grammars. A module of its own, for what it fetches has to be there once it has been read. */
import { writeContainer } from "../../web/src/core/container";
import { model } from "../../web/src/models/growth/index";
import { encodeGrowth } from "../../web/src/models/growth/request";
import { fromPreset } from "../../web/src/specimen/from_preset";

const plain = fromPreset(model, "table-1-sigma1");
await model.prepare(plain);

/** A tree of σ1 in leaf with so many of its levels, and no other mesh; `leaf_many`: leaves for each that is counted. */
export function levelsOf(
	seed: number,
	steps: number,
	levelCount = 4,
	leaf_many = plain.parameters.leaf_many,
): Uint8Array {
	const specimen = { ...plain, seed, parameters: { ...plain.parameters, steps, leaf_many } };
	return writeContainer(encodeGrowth(specimen, { levels: true, levelCount, meshes: false, measures: false }));
}
