// Made from wasm-core/grammars/growth by wasm-core/tools/generate.mjs; edit the texts, not this.

/** The texts of presets by their names: loaded when the first is grown. */
export const TEXTS: Readonly<Record<string, string>> = {
	apple: `/* Apple tree
   about: Malus domestica in flower: low and round, its branches wide and crooked. 5.2 m high, 6.4 m wide.
   source: flowers 3–4 cm and leaves 5–12 cm by the common floras; that it is wider than high is the habit of old orchards
*/
gs = 9

footprint -> GrowVol(1, 1, 3, 6, 2, 0, wm(6.4))
tree -> DivFunc("sigma1"){branches}

phototropism = 0.02
k >= 1 -> foliage(6)
`,
	beech: `/* Beech
   about: Fagus sylvatica in the open: smooth and grey, a great dome almost to the ground, sprays of leaves that lie level. 20 m high, 18 m wide.
   source: Plantsnap, Fagus sylvatica (15–24 m and massive where it stands alone, leaves 5–10 cm by 3–7 cm)
*/
gs = 10

footprint -> GrowVol(1, 1, 12, 20, 3, 0, wm(16.5))
tree -> DivFunc("sigma1"){branches}

phototropism = 0.07
k >= 1 -> foliage(4, 3)
`,
	birch: `/* Birch
   about: Betula pendula: a slender white trunk to the tip, thin rising branches, twigs that hang. 17 m high, 8 m wide.
   source: BBC Gardening, Betula pendula (15 m high, 7.5–9 m wide); Plantwerkz, Silver birch (15–25 m, leaves 3–7 cm, triangular)
*/
gs = 10

footprint -> GrowVol(1, 1, 3.4, 17, 1, 0, wm(4.6))
tree -> DivFunc("sigma1"){branches}

phototropism = 0.12
k >= 1 -> foliage(5, 3)
`,
	cherry: `/* Cherry
   about: Prunus avium in flower, before its leaves: tiers of rising branches on a straight, banded trunk. 14 m high, 8 m wide.
   source: Woodgrow, Wild cherry (more than 12 m, 8 m wide, flowers 2.5 cm); Højgaard Planteskole, Prunus avium (leaves 5–11 cm)
*/
gs = 10

footprint -> GrowVol(1, 1, 6, 14, 1, 0, wm(8))
tree -> DivFunc("sigma1"){branches}

phototropism = 0.16
k >= 1 -> foliage(6)
`,
	cypress: `/* Italian cypress
   about: Cupressus sempervirens, the narrow form of gardens and graveyards: a dark column, pointed, to the ground. 15 m high, 2 m wide.
   source: dimensions.com, Italian cypress (12–21 m by 1.5–3 m)
*/
gs = 11

footprint -> GrowVol(1, 1, 1.2, 15, 0.1, 0, wm(1.7))
tree -> DivFunc("star1"){branches}

phototropism = 0.6
k >= 1 -> foliage(4, 3)
`,
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
	grapevine: `/* Grapevine
   about: Vitis vinifera trained to a single cordon: a trunk, an arm along the wire 0.9 m up, canes that stand up from it between two wires, and places for bunches.
   source: winescience.org, Cordon (one arm along a wire, new shoots from spurs on it each year); sizes are those of usual vineyards
*/
gs = 7

footprint -> GrowVol(1, 1, 2.4, 2, 2.4, 0, towards(0))

phototropism = 0.5
k == N - 1 && gs > 1 && gs < 7 -> nbr = 3  /* spurs on the arm, a cane from each; its end is its neighbour's room */
k < N - 1 -> nbr = 0, foliage(5, 8)
`,
	hazel: `/* Hazel
   about: Corylus avellana: a shrub of many stems from one foot. 4.5 m high and wide.
   source: Kwantlen Polytechnic University, Plant database (3–5 m by 4–5 m, leaves 5–12 cm)
*/
gs = 7

footprint -> GrowVol(1, 1, 1, 4.5, 1.5, 4, wm(2), towards(20))
             GrowVol(1, 2, 1, 4, 1.5, 20, wm(2), towards(80), at(0.15, 0.15))
             GrowVol(1, 3, 1, 4.2, 1.5, 24, wm(2), towards(150), at(-0.2, 0.1))
             GrowVol(1, 4, 1, 3.8, 1.5, 22, wm(2), towards(220), at(-0.15, -0.15))
             GrowVol(1, 5, 1, 4, 1.5, 26, wm(2), towards(290), at(0.1, -0.2))
             GrowVol(1, 6, 1, 3.6, 1.5, 28, wm(2), towards(350), at(0.2, 0))
tree -> DivFunc("sigma1"){branches}

phototropism = 0.12
k >= 1 -> foliage(5)
`,
	lime: `/* Lime
   about: Tilia cordata: a tall, even dome; lower limbs arch down and turn up again at their ends. 20 m high, 12 m wide.
   source: Heritage Fruit Trees, Tilia cordata (18–24 m); Moss Vale Park, Tilia cordata (a third to half as wide as high, leaves 3–8 cm)
*/
gs = 10

footprint -> GrowVol(1, 1, 9, 20, 1, 0, wm(11))
tree -> DivFunc("sigma1"){branches}

k >= 1 -> foliage(5, 3)
`,
	maple: `/* Maple
   about: Acer platanoides: a round, dense head on a straight trunk. 15 m high, 12 m wide.
   source: University of Delaware Botanic Gardens, Acer platanoides (12–15 m, dense and round); Alāves muiža, Norway maple (leaves 7–14 cm)
*/
gs = 10

footprint -> GrowVol(1, 1, 6, 15, 1, 0, wm(11.5))
tree -> DivFunc("sigma1"){branches}

phototropism = 0.06
k >= 1 -> foliage(5, 2)
`,
	oak: `/* Oak
   about: Quercus robur in the open, broader than high: a short trunk and few heavy limbs, crooked and far out. 16 m high, 20 m wide.
   source: van den Berk Nurseries, Quercus robur (crown broad and round, leaves 5–14 cm); countrysideinfo.co.uk (a spreading dome up to 20 m high where it stands alone)
*/
gs = 10

footprint -> GrowVol(1, 1, 12, 16, 6, 0, wm(20))
tree -> DivFunc("sigma1"){branches}

phototropism = 0.09
k >= 1 -> foliage(5, 3)
`,
	olive: `/* Olive
   about: Olea europaea, old: a short, thick, twisted trunk and a loose grey-green head. 5.4 m high, 6.5 m wide.
   source: woodlands.co.uk, The olive tree (short and squat, leaves 4–10 cm by 1–3 cm, trunk gnarled with age)
*/
gs = 9

footprint -> GrowVol(1, 1, 3, 6, 3, 0, wm(6))
tree -> DivFunc("sigma1"){branches}

phototropism = 0.06
k >= 1 -> foliage(8, 2)
`,
	pine: `/* Scots pine
   about: Pinus sylvestris, old: a long bare trunk, orange above, and a crown of separate clouds. 20 m high, 10 m wide.
   source: Sheffield’s Seed Company, Pinus sylvestris (25 m, needles 2.5–5 cm, bark grey-brown below and orange above, crown round or flat on a long bare trunk)
*/
gs = 9

footprint -> GrowVol(1, 1, 1, 20, 5, 0, wm(10))
tree -> DivFunc("star1"){branches}

phototropism = 0.1
k >= 1 -> foliage(7)
`,
	poplar: `/* Lombardy poplar
   about: Populus nigra ‘Italica’: a spire; every branch goes up beside the trunk. 22 m high, 4 m wide.
   source: Kwantlen Polytechnic University, Plant database (15–22 m by 3–4 m, leaves less than 10 cm)
*/
gs = 11

footprint -> GrowVol(1, 1, 2, 22, 0.4, 0, wm(3.6))
tree -> DivFunc("star1"){branches}

phototropism = 0.6
k >= 1 -> foliage(5, 3)
`,
	spruce: `/* Spruce
   about: Picea abies: a cone to the ground about one straight trunk; boughs sweep down and turn up, their twigs hang. 24 m high, 9 m wide.
   source: flower-db.com, Picea abies (35–55 m when old, needles 2 cm); a cone with hanging twigs by the common floras
*/
gs = 11

footprint -> GrowVol(1, 1, 9, 24, 0, 0, wm(4.2))
tree -> DivFunc("sigma1"){branches}

k >= 1 -> foliage(4, 3)
`,
	"stone-pine": `/* Stone pine
   about: Pinus pinea: an umbrella, flat below and domed above, on a bare trunk that parts high up. 15 m high, 13 m wide.
   source: worldplants.ca, Pinus pinea (12–25 m high, 10–20 m wide, an umbrella when old, needles 10–20 cm, bark in red-brown plates)
*/
gs = 10

footprint -> GrowVol(1, 1, 14, 13, 7, 0, wm(15))
tree -> DivFunc("sigma1"){branches}

phototropism = 0.03
k >= 1 -> foliage(6)
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
	willow: `/* Weeping willow
   about: Salix babylonica: limbs rise and spread, and their branches hang to the ground. 13 m high, 14 m wide.
   source: van den Berk Nurseries, Salix babylonica (12–15 m, leaves 7–14 cm by 1.2 cm)
*/
gs = 10

footprint -> GrowVol(1, 1, 8, 14, 6, 0, wm(12))
tree -> DivFunc("sigma1"){branches}

phototropism = 0.08
k >= 1 -> foliage(6, 3)
`,
};
