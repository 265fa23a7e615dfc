// Made from wasm-core/grammars/growth by wasm-core/tools/generate.mjs; edit the texts, not this.
import type { Preset, PresetKind } from "../../specimen/presets";

/** A preset, and the name of the text that it grows from. */
export type TextPreset = Preset & { readonly text: string };

// biome-ignore format: a line each
export const PRESET_KINDS: readonly PresetKind[] = [
	{"key":"figures","title":"Figures of the paper"},
	{"key":"table","title":"Table 1"},
];

// biome-ignore format: a line each
export const PRESETS: readonly TextPreset[] = [
	{"name":"figure-10","kind":"figures","title":"A pattern in place of powers","since":2,"about":"The growth volume of the older rule, with branches by a divisor function and a factor of 3 in its argument. Kim, Kim and Cho 2013 and section 3.3; which functions its pictures are of is lost in print.","figure":"10","parameters":{},"look":{},"text":"figure-10"},
	{"name":"figure-4","kind":"figures","title":"Growth volumes","since":2,"about":"Three growth volumes of one footprint, each with numbers of its own. Kim, Kim and Cho 2013 and section 3.3; the numbers are ours.","figure":"4","parameters":{},"look":{},"text":"figure-4"},
	{"name":"figure-5","kind":"figures","title":"Step by step","since":2,"about":"A tree of σ1 that grows by steps; leaves that are about to fall are marked. Kim, Kim and Cho 2013 and section 3.3; what the image of its rules showed is lost, and the numbers are ours.","figure":"5","parameters":{},"look":{},"text":"figure-5"},
	{"name":"figure-6","kind":"figures","title":"Child trunks","since":2,"about":"Where the divisor function of the trunk is 0, as sums of even divisors are at every odd step, a child trunk may come. Kim, Kim and Cho 2013 and section 3.4; sizes are ours.","figure":"6","parameters":{},"look":{},"text":"figure-6"},
	{"name":"figure-7","kind":"figures","title":"Branches with a will of their own","since":2,"about":"A branch whose divisor function is negative is less drawn by gravity and grows twice as long. Kim, Kim and Cho 2013 and section 3.4; sizes are ours.","figure":"7","parameters":{},"look":{},"text":"figure-7"},
	{"name":"figure-8","kind":"figures","title":"Trees by chance","since":2,"about":"Every seed draws other growth volumes: one to three, of other sizes. Kim, Kim and Cho 2013.","figure":"8","parameters":{},"look":{},"text":"figure-8"},
	{"name":"figure-9","kind":"figures","title":"A tree of an ecosystem","since":2,"about":"Growth volume and divisor function by chance, and a factor that says how many branches there are. Kim, Kim and Cho 2013; its rules are lost in print, and the shares are ours.","figure":"9","parameters":{},"look":{},"text":"figure-9"},
	{"name":"table-1-hat","kind":"table","title":"Table 1, σ̂","since":2,"about":"Branches by the sum of divisors in which even ones count negative. Kim, Kim and Cho 2013, Table 1, row 4; which function it is print has lost, and this is our reading; the lines on buds and leaves are ours.","parameters":{},"look":{},"text":"table-1-hat"},
	{"name":"table-1-older","kind":"table","title":"Table 1, the older rule","since":2,"about":"Each branch makes two to four of its own in the step after it came: powers in place of divisors. Kim, Kim and Cho 2013, Table 1, last column; that three or four are rare is ours, and makes its number.","parameters":{},"look":{},"text":"table-1-older"},
	{"name":"table-1-power","kind":"table","title":"Table 1, σ* with B(2, 1)","since":2,"about":"Twice as many branches, by a factor in the argument. Kim, Kim and Cho 2013, Table 1, row 5; which function it is print has lost, and this is our reading; the lines on buds and leaves are ours.","parameters":{},"look":{},"text":"table-1-power"},
	{"name":"table-1-sigma1-mod2","kind":"table","title":"Table 1, σ1,1(k; 2)","since":2,"about":"Branches by the sum of the odd divisors alone. Kim, Kim and Cho 2013, Table 1, row 2; the lines on buds and leaves are ours.","parameters":{},"look":{},"text":"table-1-sigma1-mod2"},
	{"name":"table-1-sigma1","kind":"table","title":"Table 1, σ1","since":2,"about":"Branches by the sum of all divisors. Kim, Kim and Cho 2013, Table 1, row 1; the lines on buds and leaves are ours.","parameters":{},"look":{},"text":"table-1-sigma1"},
	{"name":"table-1-star","kind":"table","title":"Table 1, σ*","since":2,"about":"Branches by the sum of the divisors whose quotients are odd. Kim, Kim and Cho 2013, Table 1, row 3; which function it is print has lost, and this is our reading; the lines on buds and leaves are ours.","parameters":{},"look":{},"text":"table-1-star"},
];
