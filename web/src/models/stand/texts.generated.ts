// Made from wasm-core/grammars/stand by wasm-core/tools/generate.mjs; edit the texts, not this.

/** The texts of presets by their names: loaded when the first is grown. */
export const TEXTS: Readonly<Record<string, string>> = {
	"ecosystem-1000": `/* An ecosystem of 1,000
   about: A thousand trees, none like another.
   source: Kim, Kim and Cho 2013, Table 2; its mix and its spacing are ours
*/
ground 127 x 127, relief 5, hills 70

plants 1000, blue
growth/figure-9, share 5, crown 5 x 9, scale 0.6 to 1.1: leaf_size 42 to 56, leaf_many 3
growth/table-1-sigma1, share 2, crown 6 x 10, scale 0.5 to 0.9: steps 5 to 7, leaf_size 42 to 56, leaf_many 3
growth/table-1-star, share 1, crown 6 x 10, scale 0.5 to 0.9: steps 5 to 7, leaf_size 42 to 56, leaf_many 3
growth/table-1-hat, share 1, crown 6 x 10, scale 0.6 to 1: steps 6 to 7, season 0.4 to 0.55, leaf_size 42 to 56, leaf_many 3
`,
	"ecosystem-1500": `/* An ecosystem of 1,500
   about: Fifteen hundred trees, none like another.
   source: Kim, Kim and Cho 2013, Table 2; its mix and its spacing are ours
*/
ground 156 x 156, relief 7, hills 70

plants 1500, blue
growth/figure-9, share 5, crown 5 x 9, scale 0.6 to 1.1: leaf_size 42 to 56, leaf_many 3
growth/table-1-sigma1, share 2, crown 6 x 10, scale 0.5 to 0.9: steps 5 to 7, leaf_size 42 to 56, leaf_many 3
growth/table-1-star, share 1, crown 6 x 10, scale 0.5 to 0.9: steps 5 to 7, leaf_size 42 to 56, leaf_many 3
growth/table-1-hat, share 1, crown 6 x 10, scale 0.6 to 1: steps 6 to 7, season 0.4 to 0.55, leaf_size 42 to 56, leaf_many 3
`,
	"ecosystem-2000": `/* An ecosystem of 2,000
   about: Two thousand trees, none like another: as many as in the paper's largest.
   source: Kim, Kim and Cho 2013, Table 2; its mix and its spacing are ours
*/
ground 180 x 180, relief 8, hills 70

plants 2000, blue
growth/figure-9, share 5, crown 5 x 9, scale 0.6 to 1.1: leaf_size 42 to 56, leaf_many 3
growth/table-1-sigma1, share 2, crown 6 x 10, scale 0.5 to 0.9: steps 5 to 7, leaf_size 42 to 56, leaf_many 3
growth/table-1-star, share 1, crown 6 x 10, scale 0.5 to 0.9: steps 5 to 7, leaf_size 42 to 56, leaf_many 3
growth/table-1-hat, share 1, crown 6 x 10, scale 0.6 to 1: steps 6 to 7, season 0.4 to 0.55, leaf_size 42 to 56, leaf_many 3
`,
	"ecosystem-500": `/* An ecosystem of 500
   about: Five hundred trees, none like another; each knows what light and room its neighbours leave it.
   source: Kim, Kim and Cho 2013, Table 2; its mix and its spacing are ours
*/
ground 90 x 90, relief 4, hills 70

plants 500, blue
growth/figure-9, share 5, crown 5 x 9, scale 0.6 to 1.1: leaf_size 42 to 56, leaf_many 3
growth/table-1-sigma1, share 2, crown 6 x 10, scale 0.5 to 0.9: steps 5 to 7, leaf_size 42 to 56, leaf_many 3
growth/table-1-star, share 1, crown 6 x 10, scale 0.5 to 0.9: steps 5 to 7, leaf_size 42 to 56, leaf_many 3
growth/table-1-hat, share 1, crown 6 x 10, scale 0.6 to 1: steps 6 to 7, season 0.4 to 0.55, leaf_size 42 to 56, leaf_many 3
`,
	flowerbed: `/* A flowerbed in June
   about: Lilies and poppies behind, globeflowers and buttercups, pansies and daisies in front, each of its own age, grass between.
   source: own text
*/
ground 2.2 x 1.3, relief 0.05, hills 0.9

plants 44, stratified, depth 0 to 0.4
flower/lily, share 2, crown 0.24 x 0.7, scale 0.6 to 0.76: age 0.3 to 1.3, flowers 2
flower/poppy, share 3, crown 0.2 x 0.55, scale 0.85 to 1.1: age 0.1 to 1.6
flower/umbel, share 1, crown 0.12 x 0.6, scale 0.8 to 1: age 0.5 to 1.2, flowers 70

plants 106, stratified, depth 0.25 to 0.74
flower/globeflower, share 3, crown 0.2 x 0.42, scale 0.85 to 1.1: age 0.3 to 1.5
flower/buttercup, share 2, crown 0.24 x 0.35, scale 0.8 to 1.1: age 0.4 to 1.3
flower/poppy, share 2, crown 0.2 x 0.5, scale 0.7 to 0.95: age 0 to 1.7, length 180 to 320
flower/cyme, share 1, crown 0.2 x 0.4, scale 0.7 to 0.95: age 0.5 to 1.4

plants 150, stratified, depth 0.62 to 1
flower/pansy, share 3, crown 0.16 x 0.2, scale 0.9 to 1.3: age 0.4 to 1.4
flower/daisy, share 1, crown 0.12 x 0.14, scale 1 to 1.5: age 0.2 to 1.5, leaves 7, rays 40, discs 84
flower/daisy, share 1, crown 0.12 x 0.14, scale 1 to 1.5: age 0.2 to 1.5, leaves 8, rays 48, discs 96

plants 420, stratified
flower/grass, crown 0.1 x 0.12, scale 0.6 to 1.3, seeds 60: age 0.8 to 1.4
`,
	"forest-edge": `/* The edge of a forest
   about: Tall trees at the back, smaller ones before them, hazel at the seam: three strips of one ground.
   source: own text
*/
ground 90 x 70, relief 4, hills 60

plants 60, blue 5, depth 0 to 0.6
growth/oak, share 2, crown 14 x 16, scale 0.8 to 1.15
growth/beech, share 3, crown 12 x 18, scale 0.8 to 1.1
growth/spruce, share 2, crown 7 x 24, scale 0.6 to 0.9
growth/pine, share 1, crown 8 x 20, scale 0.7 to 0.9

plants 30, blue 4, depth 0.5 to 0.8
growth/birch, share 3, crown 7 x 17, scale 0.5 to 0.85
growth/maple, share 1, crown 10 x 14, scale 0.4 to 0.6

plants 50, blue 2, depth 0.66 to 0.92
growth/hazel, crown 4 x 4.5, scale 0.5 to 1, seeds 16
`,
	lilacs: `/* A bed of lilacs
   about: Panicles and umbels that L-systems grew, close together: stands are of any model.
   source: own text
*/
ground 0.9 x 0.7, relief 0.03

plants 220, blue 0.03
grammar/lilac, share 6, crown 0.06 x 0.1, scale 0.8 to 1.5, seeds 6
grammar/panicle, share 3, crown 0.04 x 0.06, scale 1 to 1.8, seeds 6
grammar/umbel, share 1, crown 0.07 x 0.12, scale 0.7 to 1.1, seeds 4
`,
	orchard: `/* An orchard in flower
   about: Apple and cherry trees in rows, in spring; each in its own day.
   source: own text
*/
ground 60 x 44, relief 2, hills 60

plants, rows 8 x 7, towards 15, jitter 0.3
growth/apple, share 3, crown 6.4 x 6, scale 0.7 to 1: season 0.2 to 0.26
growth/cherry, share 1, crown 6 x 7, scale 0.6 to 0.9: season 0.2 to 0.26
`,
	"spring-border": `/* A border in spring
   about: Tulips in drifts over crocuses and bluebells, from bud to bloom, at the edge of a lawn.
   source: own text
*/
ground 2.6 x 1.4, relief 0.04, hills 1.2

plants 90, stratified, depth 0.1 to 0.56
flower/tulip, share 5, crown 0.18 x 0.42, scale 0.9 to 1.1: age 0.35 to 1.25
flower/bluebell, share 2, crown 0.2 x 0.34, scale 0.85 to 1.1: age 0.6 to 1.3, bells 9

plants 70, stratified, depth 0 to 0.3
flower/bluebell, share 2, crown 0.2 x 0.36, scale 1 to 1.25: age 0.5 to 1.3, bells 8
flower/bluebell, share 1, crown 0.2 x 0.36, scale 1 to 1.25: age 0.5 to 1.3, bells 10
flower/tulip, share 1, crown 0.18 x 0.45, scale 1 to 1.2: age 0.2 to 1, length 330 to 420

plants 110, stratified, depth 0.5 to 0.8
flower/crocus, share 2, crown 0.1 x 0.14, scale 1 to 1.3: age 0.3 to 1.3, leaves 4
flower/crocus, share 2, crown 0.1 x 0.14, scale 1 to 1.3: age 0.3 to 1.3, leaves 5
flower/pansy, share 1, crown 0.14 x 0.16, scale 0.8 to 1: age 0.5 to 1.2

plants 30, stratified, depth 0.74 to 1
flower/daisy, share 3, crown 0.1 x 0.1, scale 0.8 to 1.1: age 0.3 to 1.4, leaves 7, rays 42, discs 90
flower/crocus, share 1, crown 0.1 x 0.12, scale 0.8 to 1: age 0.3 to 1.2, leaves 4

plants 260, stratified, depth 0 to 0.78
flower/grass, crown 0.1 x 0.1, scale 0.5 to 1, seeds 40: age 0.8 to 1.2

plants 900, stratified, depth 0.72 to 1
flower/grass, crown 0.07 x 0.05, scale 0.3 to 0.55, seeds 30: age 0.9 to 1.2
`,
	vineyard: `/* A vineyard
   about: Rows of vines on a trellis: each has its arm along the lowest wire, shoots between pairs of wires, and bunches at the shoots' nodes.
   source: own text
*/
ground 32 x 18, relief 0.3, hills 40

plants, rows 2.2 x 1.2, towards 0
trellis 2, posts 4.8, wire 0.9, pair 1.2, pair 1.5, pair 1.85
growth/grapevine, crown 1.2 x 2, seeds 12
bunch/pinot-noir, each 9 to 14, at bunch, scale 0.85 to 1.1, seeds 5
`,
};
