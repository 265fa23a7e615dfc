import type { LookKey, NumberKey } from "./parameters.generated";
import { DEFAULT_PRESET, presetNamed } from "./presets/index";
import { type Look, SPECIMEN_VERSION, type Specimen } from "./specimen";
import { ENTRIES, isLook } from "./table";

/** The seed of a link that names none. */
export const DEFAULT_SEED = 1;

/** A fresh, complete specimen: the table's defaults with what the preset changes. An unknown name gives the default preset. */
export function specimenFromPreset(name: string = DEFAULT_PRESET): Specimen {
	const preset = presetNamed(name) ?? presetNamed(DEFAULT_PRESET);
	const parameters: Partial<Record<NumberKey, number>> = {};
	const look: Partial<Record<LookKey, number | string>> = {};
	for (const entry of ENTRIES) {
		if (isLook(entry.key)) look[entry.key] = preset?.look[entry.key] ?? entry.default;
		else parameters[entry.key] = preset?.parameters[entry.key] ?? (entry.default as number);
	}
	return {
		v: SPECIMEN_VERSION,
		model: "bunch",
		preset: preset?.name ?? DEFAULT_PRESET,
		seed: DEFAULT_SEED,
		parameters: parameters as Record<NumberKey, number>,
		look: look as Look,
		thinned: [],
	};
}
