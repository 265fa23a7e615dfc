// Made from wasm-core/grammars/grammar by wasm-core/tools/generate.mjs; edit the texts, not this.

/** The texts of presets by their names: loaded when the first is grown. */
export const TEXTS: Readonly<Record<string, string>> = {
	bush: `/* Bush
   kind: trees
   about: A monopodial tree whose side branches leave by the golden angle.
   source: own text
   set: unit=200
*/

#define angle 42     /* 10 … 80: between a branch and its bearer */
#define shrink 0.86  /* 0.6 … 0.95: of an internode over the one before */
#define side 0.72    /* 0.4 … 0.9: of a branch over its bearer */
#define golden 137.5

derivation length: 11
axiom: A(1)
A(l) : l>0.12 --> F(l) [ &(angle+ran(8)) B(l*side) ] /(golden) A(l*shrink)
B(l) : l>0.12 --> F(l) [ &(angle) B(l*side*side) ] /(golden) B(l*shrink)
`,
};
