// Made from wasm-core/grammars/grammar by wasm-core/tools/generate.mjs; edit the texts, not this.
import type { Preset, PresetKind } from "../../specimen/presets";

/** A preset, and the name of the text that it grows from. */
export type TextPreset = Preset & { readonly text: string };

// biome-ignore format: a line each
export const PRESET_KINDS: readonly PresetKind[] = [
	{"key":"trees","title":"Trees"},
];

// biome-ignore format: a line each
export const PRESETS: readonly TextPreset[] = [
	{"name":"bush","kind":"trees","title":"Bush","since":2,"about":"A monopodial tree whose side branches leave by the golden angle.","parameters":{"unit":200},"look":{},"text":"bush"},
];
