// Made from wasm-core/grammars/stand by wasm-core/tools/generate.mjs; edit the texts, not this.
import type { Preset, PresetKind } from "../../specimen/presets";

/** A preset, and the name of the text that it grows from. */
export type TextPreset = Preset & { readonly text: string };

// biome-ignore format: a line each
export const PRESET_KINDS: readonly PresetKind[] = [
	{"key":"ecosystems","title":"Ecosystems"},
];

// biome-ignore format: a line each
export const PRESETS: readonly TextPreset[] = [
	{"name":"ecosystem-500","kind":"ecosystems","title":"An ecosystem of 500","since":2,"about":"Five hundred trees, none like another; each knows what light and room its neighbours leave it. Kim, Kim and Cho 2013, Table 2.","parameters":{"many":500},"look":{},"text":"ecosystem"},
	{"name":"ecosystem-1000","kind":"ecosystems","title":"An ecosystem of 1,000","since":2,"about":"A thousand trees, none like another. Kim, Kim and Cho 2013, Table 2.","parameters":{"many":1000},"look":{},"text":"ecosystem"},
	{"name":"ecosystem-1500","kind":"ecosystems","title":"An ecosystem of 1,500","since":2,"about":"Fifteen hundred trees, none like another. Kim, Kim and Cho 2013, Table 2.","parameters":{"many":1500},"look":{},"text":"ecosystem"},
	{"name":"ecosystem-2000","kind":"ecosystems","title":"An ecosystem of 2,000","since":2,"about":"Two thousand trees, none like another, as many as in the paper's largest. Kim, Kim and Cho 2013, Table 2.","parameters":{"many":2000},"look":{},"text":"ecosystem"},
];
