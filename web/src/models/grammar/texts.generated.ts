// Made from wasm-core/grammars/grammar by wasm-core/tools/generate.mjs; edit the texts, not this.

/** The texts of presets by their names: loaded when the first is grown. */
export const TEXTS: Readonly<Record<string, string>> = {
	bush: `/* Bush
   kind: trees
   about: A tree whose side branches leave one another by the golden angle.
   source: own text
*/

#define angle 42      /* 10 … 80: between a branch and its bearer, degrees */
#define shrink 0.86   /* 0.6 … 0.95: an internode over the one before */
#define side 0.72     /* 0.4 … 0.9: a branch over its bearer */
#define golden 137.5  /* 90 … 180: between a branch and the next, degrees */

derivation length: 11
axiom: A(20)

A(l) : l>2.4 --> F(l) [ &(angle+ran(8)) B(l*side) ] /(golden) A(l*shrink)
B(l) : l>2.4 --> F(l) [ &(angle) B(l*side*side) ] /(golden) B(l*shrink)
`,
};
