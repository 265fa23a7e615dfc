// Made from wasm-core/grammars/stand by wasm-core/tools/generate.mjs; edit the texts, not this.

/** The texts of presets by their names: loaded when the first is grown. */
export const TEXTS: Readonly<Record<string, string>> = {
	ecosystem: `/* Ecosystem of 2,000 trees
   source: Kim, Kim and Cho 2013, Table 2
*/
ground 150 x 150, relief 6

plants 2000, blue
growth/figure-9, share 6, crown 3.4 x 8, scale 0.6 to 1.1
growth/table-1-sigma1, share 2, crown 3.6 x 9, scale 0.5 to 1: steps 5 to 6
growth/table-1-star, share 1, crown 3.6 x 9, scale 0.5 to 1: steps 5 to 7
growth/table-1-hat, share 1, crown 3.6 x 9, scale 0.6 to 1.1: steps 5 to 7
`,
};
