import type { ModelSchema } from "./model_schema";
import { SPECIMEN_VERSION, type Specimen } from "./specimen";

/** The seed of a link without one. */
export const DEFAULT_SEED = 1;

/**
 * Returns a fresh, complete specimen: the table's defaults with the preset's changes. An unknown name, or none, gives
 * the model's standard preset.
 * @param version of the link that names the preset: parameters younger than the link get the value for such links
 */
export function fromPreset<S extends Specimen>(
	{ name: model, table, presets, details }: ModelSchema<S>,
	name: string = presets.standard,
	version: number = SPECIMEN_VERSION,
): S {
	const preset = presets.named(name) ?? presets.named(presets.standard);
	const parameters: Specimen["parameters"] = {};
	const look: Specimen["look"] = {};
	for (const entry of table.entries) {
		if (entry.look) look[entry.key] = preset?.look[entry.key] ?? entry.default;
		else parameters[entry.key] = preset?.parameters[entry.key] ?? (entry.default as number);
	}
	for (const { key, since, before } of table.core) {
		if (since > version && before !== undefined) parameters[key] = before;
	}
	const common: Specimen = {
		v: SPECIMEN_VERSION,
		model,
		preset: preset?.name ?? presets.standard,
		seed: DEFAULT_SEED,
		parameters,
		look,
	};
	const own = details.map((detail) => detail.fresh?.() ?? {});
	return Object.assign(common, ...own, structuredClone(preset?.details ?? {})) as S;
}
