// Made from wasm-core/grammars/flower by wasm-core/tools/generate.mjs; edit the texts, not this.
import type { Preset, PresetKind } from "../../specimen/presets";

/** A preset, and the name of the text that it grows from. */
export type TextPreset = Preset & { readonly text: string };

// biome-ignore format: a line each
export const PRESET_KINDS: readonly PresetKind[] = [
	{"key":"species","title":"Flowers"},
	{"key":"designed","title":"Designed by choices"},
	{"key":"figures","title":"Figures of the thesis"},
];

// biome-ignore format: a line each
export const PRESETS: readonly TextPreset[] = [
	{"name":"bluebell","kind":"species","title":"Bluebell","since":2,"about":"A one-sided raceme of nodding bells, each of six tepals that roll back. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"bluebell"},
	{"name":"daisy","kind":"species","title":"Daisy","since":2,"about":"A head of white rays round a dome of yellow florets in spirals by the golden angle. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"daisy"},
	{"name":"poppy","kind":"species","title":"Poppy","since":2,"about":"Four crumpled petals in two whorls, many dark stamens, and a capsule under its lid of stigmas. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"poppy"},
	{"name":"sunflower","kind":"species","title":"Sunflower","since":2,"about":"Florets in spirals by the golden angle, as faces of a prism of 21 sides give it; rays and bracts round them. Petrenko 2014, whose grammar is not printed; the text is ours.","figure":"39","parameters":{},"look":{},"text":"sunflower"},
	{"name":"tulip","kind":"species","title":"Tulip","since":2,"about":"Two whorls of three tepals, two of three stamens, three carpels grown together; two leaves. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"tulip"},
	{"name":"water-lily","kind":"species","title":"Water lily","since":2,"about":"Petals in spirals that pass into stamens, over a leaf that floats. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"water-lily"},
	{"name":"designed-buttercup","kind":"designed","title":"Buttercup by choices","since":2,"about":"Five sepals, five obovate petals, many stamens, and carpels each for itself. own text, assembled; the method is Petrenko 2014, section 3.3.","parameters":{},"look":{},"text":"designed-buttercup"},
	{"name":"designed-lily","kind":"designed","title":"Lily by choices","since":2,"about":"Two whorls of lanceolate petals that roll back, long filaments with dorsifixed anthers, one long style. own text, assembled; the method is Petrenko 2014, section 3.3.","parameters":{},"look":{},"text":"designed-lily"},
	{"name":"designed-tulip","kind":"designed","title":"Tulip by choices","since":2,"about":"The thesis's example, described organ by organ: an erect round stem, apical leaves, no sepals, six rounded petals, six basifixed stamens, a syncarpous pistil. own text, assembled; the method is Petrenko 2014, section 3.3.","parameters":{},"look":{},"text":"designed-tulip"},
	{"name":"designed-violet","kind":"designed","title":"Violet by choices","since":2,"about":"An irregular flower: its lower lip is larger than its upper petals; leaves at the foot, heart-shaped. own text, assembled; the method is Petrenko 2014, section 3.3.","parameters":{},"look":{},"text":"designed-violet"},
	{"name":"figure-16","kind":"figures","title":"Figure 16","since":2,"about":"A grammar in a grammar: sepals, petals, stamens and a carpel are modules of a flower of eighteen sides. Petrenko 2014, in full; its four modules are only named there and are ours.","figure":"16","parameters":{},"look":{},"text":"figure-16"},
	{"name":"petal","kind":"figures","title":"Petal","since":2,"about":"One petal of three layers, whose lobes grow from a vein and are glued. Petrenko 2014 and section 2.2.3; the grammar is ours.","figure":"21","parameters":{},"look":{},"text":"petal"},
	{"name":"table-3","kind":"figures","title":"Table 3","since":2,"about":"The thesis's example of a grammar: a stem, a receptacle and four petals, each a module. Petrenko 2014, Table 3, in full; the module PTULIP is only named there and is ours.","parameters":{},"look":{},"text":"table-3"},
];
