// Made from wasm-core/grammars/flower by wasm-core/tools/generate.mjs; edit the texts, not this.
import type { Preset, PresetKind } from "../../specimen/presets";

/** A preset, and the name of the text that it grows from. */
export type TextPreset = Preset & { readonly text: string };

// biome-ignore format: a line each
export const PRESET_KINDS: readonly PresetKind[] = [
	{"key":"species","title":"Flowers"},
	{"key":"inflorescences","title":"Inflorescences"},
	{"key":"meadows","title":"Meadows"},
	{"key":"designed","title":"Designed by choices"},
	{"key":"figures","title":"Figures of the thesis"},
];

// biome-ignore format: a line each
export const PRESETS: readonly TextPreset[] = [
	{"name":"bluebell","kind":"species","title":"Bluebell","since":2,"about":"A one-sided raceme that nods; bells of six tepals that roll back, open below and in bud above; narrow leaves. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"bluebell"},
	{"name":"buttercup","kind":"species","title":"Buttercup","since":2,"about":"Five petals that shine, five sepals, many stamens round a head of carpels; three flowers of a cyme over leaves of five lobes. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"buttercup"},
	{"name":"crocus","kind":"species","title":"Crocus","since":2,"about":"Six tepals on a long tube, three stamens, a style of three frilled branches; leaves with a white rib. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"crocus"},
	{"name":"daisy","kind":"species","title":"Daisy","since":2,"about":"A head of white rays round a dome of yellow florets in spirals by the golden angle, over a rosette of spoon-shaped leaves. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"daisy"},
	{"name":"dandelion-clock","kind":"species","title":"Dandelion clock","since":2,"about":"What becomes of the dandelion: a ball of achenes, each on its beak with a parachute of hairs; age opens it. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"dandelion-clock"},
	{"name":"dandelion","kind":"species","title":"Dandelion","since":2,"about":"A head of ligules in spirals by the golden angle on a hollow stalk; the outer bracts turn back; toothed leaves in a rosette. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"dandelion"},
	{"name":"globeflower","kind":"species","title":"Globeflower","since":2,"about":"Ten sepals, yellow as petals, close to a globe round nectaries and stamens; leaves of five lobes. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"globeflower"},
	{"name":"lily","kind":"species","title":"Lily","since":2,"about":"A few white trumpets, six tepals each, with golden anthers hung by their backs; narrow leaves all up the stem. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"lily"},
	{"name":"pansy","kind":"species","title":"Wild pansy","since":2,"about":"One plane of symmetry: two upper petals, two at the sides and a lower one with a spur, each of its own shape and colour; K5 C5 A5 G(3). own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"pansy"},
	{"name":"poppy","kind":"species","title":"Poppy","since":2,"about":"Four crumpled petals in two whorls, many dark stamens, and a capsule under its lid of stigmas; the bud hangs in two hairy sepals, which fall. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"poppy"},
	{"name":"rose","kind":"species","title":"Rose","since":2,"about":"A double rose: petals in a spiral by the golden angle, rolled within and turned back without; sepals, prickles and leaves of five leaflets. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"rose"},
	{"name":"sunflower","kind":"species","title":"Sunflower","since":2,"about":"Florets in spirals by the golden angle, as faces of a prism of 13 sides give it; rays and bracts round them. Petrenko 2014, whose grammar is not printed; the text is ours.","figure":"39","parameters":{},"look":{},"text":"sunflower"},
	{"name":"tulip","kind":"species","title":"Tulip","since":2,"about":"Two whorls of three tepals, two of three stamens, three carpels grown together; two leaves. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"tulip"},
	{"name":"water-lily","kind":"species","title":"Water lily","since":2,"about":"Petals in a spiral by the golden angle that pass into stamens, over a leaf that floats. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"water-lily"},
	{"name":"capitulum","kind":"inflorescences","title":"Capitulum","since":2,"about":"Many florets on one receptacle, as if they were a flower: cornflower, trumpets round its violet middle, bracts like tiles below. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"capitulum"},
	{"name":"cyme","kind":"inflorescences","title":"Cyme","since":2,"about":"Each axis ends in a flower and two branches do the same below it: red campion, a module that calls itself. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"cyme"},
	{"name":"double-umbel","kind":"inflorescences","title":"Double umbel","since":2,"about":"An umbel of umbels: wild carrot, with the dark floret in the midst of its lace. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"double-umbel"},
	{"name":"panicle","kind":"inflorescences","title":"Panicle","since":2,"about":"A raceme of racemes, shorter towards the tip: lilac, florets of four lobes, in bud above. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"panicle"},
	{"name":"raceme","kind":"inflorescences","title":"Raceme","since":2,"about":"Flowers on stalks along an axis, the lowest first: lily of the valley, its bells hollow as a prism that grows backwards makes them. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"raceme"},
	{"name":"spike","kind":"inflorescences","title":"Spike","since":2,"about":"Flowers without stalks along an axis, the lowest first: gladiolus, all to one side, in bud above. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"spike"},
	{"name":"umbel","kind":"inflorescences","title":"Umbel","since":2,"about":"Flowers on stalks from one point: an ornamental onion, a ball of stars. own text; the method is Petrenko 2014, section 2.2.3.","parameters":{},"look":{},"text":"umbel"},
	{"name":"grass","kind":"meadows","title":"Grass","since":2,"about":"A tuft of thirteen blades that bow outwards: what stands between the flowers of a bed.","parameters":{},"look":{},"text":"grass"},
	{"name":"meadow","kind":"meadows","title":"Meadow","since":2,"about":"A ground of volumes, grown and glued like a petal, on whose tops seeds are sown by luck: each is a module of its own, grass or one of five flowers, in drifts of their kind. Petrenko 2014, whose grammar is not printed; the text is ours.","figure":"24","parameters":{},"look":{},"text":"meadow"},
	{"name":"designed-buttercup","kind":"designed","title":"Buttercup by choices","since":2,"about":"Five sepals, five obovate petals, many stamens, and carpels each for itself. own text, assembled; the method is Petrenko 2014, section 3.3.","parameters":{},"look":{},"text":"designed-buttercup"},
	{"name":"designed-lily","kind":"designed","title":"Lily by choices","since":2,"about":"Two whorls of lanceolate petals that roll back, long filaments with dorsifixed anthers, one long style. own text, assembled; the method is Petrenko 2014, section 3.3.","parameters":{},"look":{},"text":"designed-lily"},
	{"name":"designed-tulip","kind":"designed","title":"Tulip by choices","since":2,"about":"The thesis's example, described organ by organ: an erect round stem, apical leaves, no sepals, six rounded petals, six basifixed stamens, a syncarpous pistil. own text, assembled; the method is Petrenko 2014, section 3.3.","parameters":{},"look":{},"text":"designed-tulip"},
	{"name":"designed-violet","kind":"designed","title":"Violet by choices","since":2,"about":"An irregular flower: its lower lip is larger than its upper petals; leaves at the foot, heart-shaped. own text, assembled; the method is Petrenko 2014, section 3.3.","parameters":{},"look":{},"text":"designed-violet"},
	{"name":"figure-16","kind":"figures","title":"Figure 16","since":2,"about":"A grammar in a grammar: sepals, petals, stamens and a carpel are modules of a flower of eighteen sides. Petrenko 2014, in full; its four modules are only named there and are ours.","figure":"16","parameters":{},"look":{},"text":"figure-16"},
	{"name":"petal","kind":"figures","title":"Petal","since":2,"about":"One petal of three layers, whose lobes grow from a vein and are glued. Petrenko 2014 and section 2.2.3; the grammar is ours.","figure":"21","parameters":{},"look":{},"text":"petal"},
	{"name":"table-3","kind":"figures","title":"Table 3","since":2,"about":"The thesis's example of a grammar: a stem, a receptacle and four petals, each a module. Petrenko 2014, Table 3, in full; the module PTULIP is only named there and is ours.","parameters":{},"look":{},"text":"table-3"},
];
