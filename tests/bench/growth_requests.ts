/** What the bench asks of growth grammars. A module of its own, for what it fetches has to be there once it has been read. */
import { writeContainer } from "../../web/src/core/container";
import { model } from "../../web/src/models/growth/index";
import { encodeGrowth } from "../../web/src/models/growth/request";
import { fromPreset } from "../../web/src/specimen/from_preset";

const plain = fromPreset(model, "table-1-sigma1");
await model.prepare(plain);

/** A tree of σ1 in leaf with all levels of it, and no other mesh. */
export function levelsOf(seed: number, steps: number): Uint8Array {
	return writeContainer(blocksOf(seed, steps, 4));
}

/** One of the same branches that bears `leaves` counted leaves, of three each, on every youngest internode, as trees of the presets do. */
export function leafyOf(seed: number, steps: number, leaves: number, levelCount: number): Uint8Array {
	const blocks = blocksOf(seed, steps, levelCount);
	const rules = `tree -> DivFunc("sigma1"){branches}\nk >= 0 -> nlf = 0, foliage(${leaves})\n`;
	return writeContainer(blocks.map((block) => (block.name === "rules" ? { ...block, data: rules } : block)));
}

function blocksOf(seed: number, steps: number, levelCount: number) {
	const specimen = { ...plain, seed, parameters: { ...plain.parameters, steps } };
	return encodeGrowth(specimen, { levels: true, levelCount, meshes: false, measures: false });
}
