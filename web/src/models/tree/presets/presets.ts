import { numbersIn, type Preset, type PresetKind } from "../../../specimen/presets";
import type { NumberKey } from "../parameters.generated";
import { TREE_TABLE } from "../table";
import birch from "./birch.json";
import bonsai from "./bonsai.json";
import box from "./box.json";
import cypress from "./cypress.json";
import hedge from "./hedge.json";
import oak from "./oak.json";
import printed from "./printed.json";
import sphere from "./sphere.json";
import twin from "./twin.json";

export const PRESET_KINDS = [
	{ key: "tree", title: "Trees", family: "trees" },
	{ key: "shaped", title: "Clipped shapes", family: "topiary" },
	{ key: "boundary", title: "Boundaries of the paper", family: "trees", fromPaper: true },
] as const satisfies readonly PresetKind[];

/** As the file holds it: choices by name. */
interface PresetFile extends Omit<Preset, "kind" | "parameters"> {
	parameters: Readonly<Partial<Record<NumberKey, number | string>>>;
}

/** The boundaries are those of the paper's section 4.1 and 4.2. */
export const PRESETS: readonly Preset[] = [
	...ofKind("tree", [oak, birch, cypress, twin]),
	...ofKind("shaped", [bonsai, hedge]),
	...ofKind("boundary", [sphere, box, printed]),
];

/** Returns the presets of a kind from their files, with choices as numbers. */
function ofKind(kind: (typeof PRESET_KINDS)[number]["key"], files: readonly PresetFile[]): Preset[] {
	return files.map((file) => ({ ...file, kind, parameters: numbersIn(TREE_TABLE, file.parameters) }));
}

/** The preset a link without `preset` means. */
export const DEFAULT_PRESET = "oak";
