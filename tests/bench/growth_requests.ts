/**
 * Requests of the benchmark for growth grammars. A separate module, because its fetches must finish when it has
 * loaded.
 */
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

/**
 * A tree with the same branches and with `leaves` counted leaves, in threes, on every youngest internode, as trees of
 * the presets have.
 */
export function leafyOf(seed: number, steps: number, leaves: number, levelCount: number): Uint8Array {
	const blocks = blocksOf(seed, steps, levelCount);
	const rules = `tree -> DivFunc("sigma1"){branches}\nk >= 0 -> nlf = 0, foliage(${leaves})\n`;
	return writeContainer(blocks.map((block) => (block.name === "rules" ? { ...block, data: rules } : block)));
}

function blocksOf(seed: number, steps: number, levelCount: number) {
	const specimen = { ...plain, seed, parameters: { ...plain.parameters, steps } };
	return encodeGrowth(specimen, { levels: true, levelCount, meshes: false, measures: false });
}
