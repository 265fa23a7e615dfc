import { numbersIn, type Preset, type PresetKind } from "../../../specimen/presets";
import type { NumberKey } from "../parameters.generated";
import { ROOT_TABLE } from "../table";
import carrot from "./carrot.json";
import fibrous from "./fibrous.json";
import heart from "./heart.json";
import tap from "./tap.json";

export const PRESET_KINDS = [{ key: "root", title: "Roots", family: "roots" }] as const satisfies readonly PresetKind[];

/** As the file holds it: choices by name. */
interface PresetFile extends Omit<Preset, "kind" | "parameters"> {
	parameters: Readonly<Partial<Record<NumberKey, number | string>>>;
}

export const PRESETS: readonly Preset[] = ofKind("root", [tap, fibrous, heart, carrot]);

/** Returns the presets of a kind from their files, with choices as numbers. */
function ofKind(kind: (typeof PRESET_KINDS)[number]["key"], files: readonly PresetFile[]): Preset[] {
	return files.map((file) => ({ ...file, kind, parameters: numbersIn(ROOT_TABLE, file.parameters) }));
}

/** The preset a link without `preset` means. */
export const DEFAULT_PRESET = "tap";
