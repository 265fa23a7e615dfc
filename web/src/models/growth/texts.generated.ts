// Made from wasm-core/grammars/growth by wasm-core/tools/generate.mjs; edit the texts, not this.

/** The texts of presets by their names: loaded when the first is grown. */
export const TEXTS: Readonly<Record<string, string>> = {
	"figure-10": `/* A pattern in place of powers
   about: The growth volume of the older rule, with branches by a divisor function and a factor of 3 in its argument.
   source: Kim, Kim and Cho 2013, figure 10 and section 3.3; which functions its pictures are of is lost in print
*/
gs = 8

footprint -> GrowVol(1, 1, 8, 9, 8, 0)
tree -> DivFunc("sigma1"){branches}, DivFunc("exp", 3, 1){branch}
`,
	"figure-4": `/* Growth volumes
   about: Three growth volumes of one footprint, each with numbers of its own.
   source: Kim, Kim and Cho 2013, figure 4 and section 3.3; the numbers are ours
*/
gs = 7

/* GrowVol(cnt, id, wb, h, wt, grad): how many, the first one’s number, width at the base, height and width at the top
   in metres, and how far it leans in degrees. */
footprint -> GrowVol(1, 1, 8, 10, 5, 0)
             GrowVol(1, 2, 6, 6, 6, 10)
             GrowVol(1, 3, 4, 4, 1, 20)
tree -> DivFunc("sigma1"){branches}
`,
	"figure-5": `/* Step by step
   about: A tree of σ1 that grows by steps; leaves that are about to fall are marked.
   source: Kim, Kim and Cho 2013, figure 5 and section 3.3; what the image of its rules showed is lost, and the numbers are ours
*/
gs = 8

footprint -> GrowVol(1, 1, 8, 10, 5, 0)
tree -> DivFunc("sigma1"){branches} DivFunc("sigma1"){leaves}

/* The trunk is the branch whose age k is N − 1. What the text decides here is a calibration by Table 1. */
k == N - 1 -> ndv = D(B * k), nbr = abs(ndv)
k < N - 1 -> ndv = D(k) - D(k - 1), nbr = ndv
bud(k - 1) : k < N - 1 -> branch : 0.9

k == N - 1 -> nlf = E(L)
k < N - 1 -> nlf = E(L * (N - k)) - E(L * (N - k - 1))
nlf > 0 -> leaf(nlf)
nlf < 0 -> fallingLeaf(-nlf)

phototropism = 0.1
GrowVol.h < 5 -> gravitropism = 0.2
`,
	"figure-6": `/* Child trunks
   about: Where the divisor function of the trunk is 0, as sums of even divisors are at every odd step, a child trunk may come.
   source: Kim, Kim and Cho 2013, figure 6 and section 3.4; sizes are ours
*/
gs = 9

footprint -> GrowVol(1, 1, 10, 10, 6, 0)
/* The same for leaves would give none: a new branch has those of 1, which no even number divides. */
tree -> DivFunc("sigma1b", 0, 2){branches} DivFunc("sigma1"){leaves}

ndv == 0 -> childTrunk : 0.1
`,
	"figure-7": `/* Branches with a will of their own
   about: A branch whose divisor function is negative is less drawn by gravity and grows twice as long.
   source: Kim, Kim and Cho 2013, figure 7 and section 3.4; sizes are ours
*/
gs = 9

footprint -> GrowVol(1, 1, 8, 10, 5, 0)
tree -> DivFunc("hat", 1){branches}

gravitropism = 0.2
ndv < 0 -> gravitropism = gravitropism - 0.2, length = length * 2
`,
	"figure-8": `/* Trees by chance
   about: Every seed draws other growth volumes: one to three, of other sizes.
   source: Kim, Kim and Cho 2013, figure 8
*/
gs.rand(7, 8)

/* Each number is the most: cnt from 1 to 3, wb, h and wt from 1 to 10, 8 and 12 metres, grad from 0 to 60°. */
footprint -> GrowVol(cnt.rand(3), size.rand(10, 8, 12, 60°))
tree -> DivFunc("sigma1"){branches} : 0.25
tree -> DivFunc("sigma1b", 1, 2){branches} : 0.25
tree -> DivFunc("star1"){branches} : 0.25
tree -> DivFunc("hat1"){branches} : 0.25

GrowVol.h < 5 -> gravitropism = 0.2
`,
	"figure-9": `/* A tree of an ecosystem
   about: Growth volume and divisor function by chance, and a factor that says how many branches there are.
   source: Kim, Kim and Cho 2013, figure 9; its rules are lost in print, and the shares are ours
*/
gs.rand(5, 7)

footprint -> GrowVol(cnt.rand(2), wb.rand(4, 10), h.rand(5, 12), wt.rand(2, 8), grad.rand(15))
tree -> DivFunc("sigma1"){branches} : 1
tree -> DivFunc("sigma1b", 1, 2){branches} : 1
tree -> DivFunc("star1"){branches} : 1
tree -> DivFunc("hat1"){branches} : 1
tree -> DivFunc("exp", 2, RND(0, 1)){branch}

GrowVol.h < 5 -> gravitropism = 0.2
ndv == 0 -> childTrunk : 0.1
ndv < 0 -> gravitropism = gravitropism - 0.2, length = length * 2
`,
	"table-1-hat": `/* Table 1, σ̂
   about: Branches by the sum of divisors in which even ones count negative.
   source: Kim, Kim and Cho 2013, Table 1, row 4; which function it is print has lost, and this is our reading; the lines on buds and leaves are ours
*/
gs = 8

footprint -> GrowVol(1, 1, 8, 10, 5, 0)
tree -> DivFunc("hat", 1){branches}

/* The trunk is the branch whose age k is N − 1. What the text decides here is a calibration by Table 1. */
k == N - 1 -> ndv = D(B * k), nbr = abs(ndv)
k < N - 1 -> ndv = D(k) - D(k - 1), nbr = ndv
bud(k - 1) : k < N - 1 -> branch : 0.9

k == N - 1 -> nlf = E(L)
k < N - 1 -> nlf = E(L * (N - k)) - E(L * (N - k - 1))
nlf > 0 -> leaf(nlf)
nlf < 0 -> fallingLeaf(-nlf)
`,
	"table-1-older": `/* Table 1, the older rule
   about: Each branch makes two to four of its own in the step after it came: powers in place of divisors.
   source: Kim, Kim and Cho 2013, Table 1, last column; that three or four are rare is ours, and makes its number
*/
gs = 8

footprint -> GrowVol(1, 1, 8, 10, 5, 0)

k == 1 -> nbr = 2
k == 1 -> nbr = RND(3, 4) : 0.055
bud(4) -> branch
k == 1 -> leaf(1)
`,
	"table-1-power": `/* Table 1, σ* with B(2, 1)
   about: Twice as many branches, by a factor in the argument.
   source: Kim, Kim and Cho 2013, Table 1, row 5; which function it is print has lost, and this is our reading; the lines on buds and leaves are ours
*/
gs = 8

footprint -> GrowVol(1, 1, 8, 10, 5, 0)
tree -> DivFunc("star", 1){branches} DivFunc("exp", 2, 1){branch}

/* The trunk is the branch whose age k is N − 1. What the text decides here is a calibration by Table 1. */
k == N - 1 -> ndv = D(B * k), nbr = abs(ndv)
k < N - 1 -> ndv = D(k) - D(k - 1), nbr = ndv
bud(k - 1) : k < N - 1 -> branch : 0.9

k == N - 1 -> nlf = E(L)
k < N - 1 -> nlf = E(L * (N - k)) - E(L * (N - k - 1))
nlf > 0 -> leaf(nlf)
nlf < 0 -> fallingLeaf(-nlf)
`,
	"table-1-sigma1-mod2": `/* Table 1, σ1,1(k; 2)
   about: Branches by the sum of the odd divisors alone.
   source: Kim, Kim and Cho 2013, Table 1, row 2; the lines on buds and leaves are ours
*/
gs = 8

footprint -> GrowVol(1, 1, 8, 10, 5, 0)
tree -> DivFunc("sigma1b", 1, 2){branches}

/* The trunk is the branch whose age k is N − 1. What the text decides here is a calibration by Table 1. */
k == N - 1 -> ndv = D(B * k), nbr = abs(ndv)
k < N - 1 -> ndv = D(k) - D(k - 1), nbr = ndv
bud(k - 1) : k < N - 1 -> branch : 0.9

k == N - 1 -> nlf = E(L)
k < N - 1 -> nlf = E(L * (N - k)) - E(L * (N - k - 1))
nlf > 0 -> leaf(nlf)
nlf < 0 -> fallingLeaf(-nlf)
`,
	"table-1-sigma1": `/* Table 1, σ1
   about: Branches by the sum of all divisors.
   source: Kim, Kim and Cho 2013, Table 1, row 1; the lines on buds and leaves are ours
*/
gs = 8

footprint -> GrowVol(1, 1, 8, 10, 5, 0)
tree -> DivFunc("sigma", 1){branches}

/* The trunk is the branch whose age k is N − 1. What the text decides here is a calibration by Table 1. */
k == N - 1 -> ndv = D(B * k), nbr = abs(ndv)
k < N - 1 -> ndv = D(k) - D(k - 1), nbr = ndv
bud(k - 1) : k < N - 1 -> branch : 0.9

k == N - 1 -> nlf = E(L)
k < N - 1 -> nlf = E(L * (N - k)) - E(L * (N - k - 1))
nlf > 0 -> leaf(nlf)
nlf < 0 -> fallingLeaf(-nlf)
`,
	"table-1-star": `/* Table 1, σ*
   about: Branches by the sum of the divisors whose quotients are odd.
   source: Kim, Kim and Cho 2013, Table 1, row 3; which function it is print has lost, and this is our reading; the lines on buds and leaves are ours
*/
gs = 8

footprint -> GrowVol(1, 1, 8, 10, 5, 0)
tree -> DivFunc("star", 1){branches}

/* The trunk is the branch whose age k is N − 1. What the text decides here is a calibration by Table 1. */
k == N - 1 -> ndv = D(B * k), nbr = abs(ndv)
k < N - 1 -> ndv = D(k) - D(k - 1), nbr = ndv
bud(k - 1) : k < N - 1 -> branch : 0.9

k == N - 1 -> nlf = E(L)
k < N - 1 -> nlf = E(L * (N - k)) - E(L * (N - k - 1))
nlf > 0 -> leaf(nlf)
nlf < 0 -> fallingLeaf(-nlf)
`,
};
