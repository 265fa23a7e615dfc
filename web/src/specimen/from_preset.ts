import type { LookKey, NumberKey } from "../models/bunch/parameters.generated";
import { DEFAULT_PRESET, presetNamed } from "../models/bunch/presets/index";
import { type Look, SPECIMEN_VERSION, type Specimen } from "./specimen";
import { CORE_ENTRIES, ENTRIES, isLook } from "./table";

/** The seed of a link that names none. */
export const DEFAULT_SEED = 1;

/**
 * A fresh, complete specimen: the table's defaults with what the preset changes. An unknown name gives the default preset.
 * @param version of the link that names the preset: what is younger than the link has the value it means there
 */
export function specimenFromPreset(name: string = DEFAULT_PRESET, version: number = SPECIMEN_VERSION): Specimen {
	const preset = presetNamed(name) ?? presetNamed(DEFAULT_PRESET);
	const parameters: Partial<Record<NumberKey, number>> = {};
	const look: Partial<Record<LookKey, number | string>> = {};
	for (const entry of ENTRIES) {
		if (isLook(entry.key)) look[entry.key] = preset?.look[entry.key] ?? entry.default;
		else parameters[entry.key] = preset?.parameters[entry.key] ?? (entry.default as number);
	}
	for (const { key, since, before } of CORE_ENTRIES) {
		if (since > version && before !== undefined) parameters[key] = before;
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
