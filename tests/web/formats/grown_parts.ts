/** Plants of presets as parts, grown by the core as it is built. */
import { aboutPlant } from "../../../web/src/formats/about_plant";
import { modelNamed } from "../../../web/src/models/index";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { restore } from "../../../web/src/specimen/restore";
import { freshCore } from "../core/wasm";

/**
 * @param source of a model and its preset: `bunch/merlot`
 * @param changed parameters that are another's than the preset's
 */
export async function grownParts(source: string, changed: Record<string, number> = {}) {
	const [name, preset] = source.split("/");
	const model = await modelNamed(name);
	const { specimen } = restore(model, changed, fromPreset(model, preset));
	await model.prepare?.(specimen);
	const core = await freshCore(model.wasm);
	const grown = model.read(core.grow(model.encode(specimen)), specimen);
	return {
		model,
		specimen,
		core,
		parts: () => model.parts(grown, specimen),
		about: await aboutPlant(model, grown, specimen),
	};
}
