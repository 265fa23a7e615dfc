// Made from wasm-core/grammars/stand by wasm-core/tools/generate.mjs; edit the texts, not this.
import type { Preset, PresetKind } from "../../specimen/presets";

/** A preset, and the name of the text that it grows from. */
export type TextPreset = Preset & { readonly text: string };

// biome-ignore format: a line each
export const PRESET_KINDS: readonly PresetKind[] = [
	{"key":"ecosystems","title":"Ecosystems"},
	{"key":"planted","title":"Planted"},
	{"key":"gardens","title":"Gardens"},
];

// biome-ignore format: a line each
export const PRESETS: readonly TextPreset[] = [
	{"name":"ecosystem-1000","kind":"ecosystems","title":"An ecosystem of 1,000","since":2,"about":"A thousand trees, none like another. Kim, Kim and Cho 2013, Table 2; its mix and its spacing are ours.","parameters":{},"look":{},"text":"ecosystem-1000"},
	{"name":"ecosystem-1500","kind":"ecosystems","title":"An ecosystem of 1,500","since":2,"about":"Fifteen hundred trees, none like another. Kim, Kim and Cho 2013, Table 2; its mix and its spacing are ours.","parameters":{},"look":{},"text":"ecosystem-1500"},
	{"name":"ecosystem-2000","kind":"ecosystems","title":"An ecosystem of 2,000","since":2,"about":"Two thousand trees, none like another: as many as in the paper's largest. Kim, Kim and Cho 2013, Table 2; its mix and its spacing are ours.","parameters":{},"look":{},"text":"ecosystem-2000"},
	{"name":"ecosystem-500","kind":"ecosystems","title":"An ecosystem of 500","since":2,"about":"Five hundred trees, none like another; each knows what light and room its neighbours leave it. Kim, Kim and Cho 2013, Table 2; its mix and its spacing are ours.","parameters":{},"look":{},"text":"ecosystem-500"},
	{"name":"forest-edge","kind":"ecosystems","title":"The edge of a forest","since":2,"about":"Tall trees at the back, smaller ones before them, hazel at the seam: three strips of one ground.","parameters":{},"look":{},"text":"forest-edge"},
	{"name":"orchard","kind":"planted","title":"An orchard in flower","since":2,"about":"Apple and cherry trees in rows, in spring; each in its own day.","parameters":{},"look":{},"text":"orchard"},
	{"name":"vineyard","kind":"planted","title":"A vineyard","since":2,"about":"Rows of vines on a trellis: each has its arm along the lowest wire, shoots between pairs of wires, and bunches at the shoots' nodes.","parameters":{},"look":{},"text":"vineyard"},
	{"name":"flowerbed","kind":"gardens","title":"A flowerbed in June","since":2,"about":"Lilies and poppies behind, globeflowers and buttercups, pansies and daisies in front, each of its own age, grass between.","parameters":{},"look":{"soil":"6b5843"},"text":"flowerbed"},
	{"name":"lilacs","kind":"gardens","title":"A bed of lilacs","since":2,"about":"Panicles and umbels that L-systems grew, close together: stands are of any model.","parameters":{},"look":{"soil":"6b5843"},"text":"lilacs"},
	{"name":"spring-border","kind":"gardens","title":"A border in spring","since":2,"about":"Tulips in drifts over crocuses and bluebells, from bud to bloom, at the edge of a lawn.","parameters":{},"look":{"soil":"675a3f"},"text":"spring-border"},
];
