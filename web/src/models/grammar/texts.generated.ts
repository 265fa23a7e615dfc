// Made from wasm-core/grammars/grammar by wasm-core/tools/generate.mjs; edit the texts, not this.

/** The texts of presets by their names: loaded when the first is grown. */
export const TEXTS: Readonly<Record<string, string>> = {
	algae: `/* Fibonacci’s filament
   about: The simplest of all L-systems: as many cells as Fibonacci’s rabbits.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 1.2; drawing is ours
   page: 4
*/
derivation length: 9

axiom: b

a --> a b
b --> a

homomorphism
a --> ;(2) F(1) f(0.2)
b --> ;(7) F(0.5) f(0.2)
`,
	"anabaena-heterocysts": `/* Anabaena with heterocysts
   about: A substance leaks out of the cells; where little is left, a cell becomes a heterocyst.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), L-system 1.1; t>0 and the drawing are ours
   page: 44
*/
#define CH 900
#define CT 0.4 /* 0.1 … 1 */
#define ST 3.9 /* 2 … 6 */
derivation length: 200
ignore: f H

axiom: -(90) F(0,0,CH) F(4,1,CH) F(0,0,CH)

F(s,t,c) : t=1 && s>=6 --> F(s/3*2,2,c) f(1) F(s/3,1,c)
F(s,t,c) : t=2 && s>=6 --> F(s/3,2,c) f(1) F(s/3*2,1,c)
F(h,i,k) < F(s,t,c) > F(o,p,r) : t>0 && (s>ST || c>CT) --> F(s+0.1,t,c+0.25*(k+r-3*c))
F(h,i,k) < F(s,t,c) > F(o,p,r) : !(s>ST || c>CT) --> F(0,0,CH) H(1)
H(s) : s<3 --> H(s*1.1)

homomorphism
F(s,t,c) : t>0 --> ;(2) F(s)
H(s) --> ;(7) @O(s)
`,
	anabaena: `/* Anabaena catenula
   about: A blue-green filament whose cells divide in one of two directions.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.4; after Lindenmayer 1968; drawing is ours
   page: 5
*/
derivation length: 8

axiom: ar

ar --> al br
al --> bl ar
br --> ar
bl --> al

homomorphism
ar --> ;(2) F(1) f(0.2)
al --> ;(3) F(1) f(0.2)
br --> ;(6) F(0.5) f(0.2)
bl --> ;(7) F(0.5) f(0.2)
`,
	"binary-tree": `/* Binary tree
   about: Every branch is the one before, made smaller by R.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.39
   page: 49
*/
#define R 1.456 /* 1.2 … 2 */
angle increment: 85
derivation length: 10

axiom: A(1)

A(s) --> F(s) [+A(s/R)] [-A(s/R)]
`,
	"borchert-slade": `/* Tree that branches ever less
   about: How often an axis branches falls with its age, so that the tips are as many as a surface holds.
   source: Synthetic topiary (Prusinkiewicz, James and Měch 1994), section 4; after Borchert and Slade 1981
*/
#define phi 90 /* 0 … 180 */
#define alpha 32 /* 0 … 90 */
#define beta 20 /* 0 … 90 */
derivation length: 14

axiom: F A(1)

A(k) --> /(phi) [+(alpha) F A(k+1)] -(beta) F A(k+1) : min(1, (2*k+1)/k^2)
A(k) --> /(phi) -(beta) F A(k+1) : max(0, 1-(2*k+1)/k^2)
`,
	bush: `/* Bush
   about: A bush in space, with leaves.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.25; J is S there
   page: 26
*/
angle increment: 22.5
line width: 0.6
line width increment: 0.08
derivation length: 6 /* 7 there */

axiom: A

A --> [& F L ! A] ///// ' [& F L ! A] /////// ' [& F L ! A]
F --> J ///// F
J --> F L
L --> [''' ^^ {-f+f+f-|-f+f+f}]
`,
	capitulum: `/* Capitulum
   about: A raceme without internodes or stalks: the flowers sit on a disc.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3: the type; numbers and shapes are ours
*/
derivation length: 80

#define c 0.16 /* 0.05 … 0.5 */
axiom: F(8) A(1)

A(n) --> [&(90) f(c*n^0.5) ^(90) K(n)] /(137.5) A(n+1)

homomorphism
K(n) : n<60 --> ;(6) @O(0.22)
K(n) --> &(60) ;(5) ~petal(1.4)
`,
	"compound-leaf-alternating": `/* Compound leaf with alternating branches
   about: Branches to one side and the other in turn.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 5.12
   page: 130
*/
#define D 1 /* 0 … 10 */
#define R 1.36 /* 1 … 2 */
angle increment: 45
derivation length: 18

axiom: A(0)

A(d) : d>0 --> A(d-1)
A(d) : d=0 --> F(1) [+A(D)] F(1) B(0)
B(d) : d>0 --> B(d-1)
B(d) : d=0 --> F(1) [-B(D)] F(1) A(0)
F(a) --> F(a*R)
`,
	"compound-leaf": `/* Compound leaf
   about: Leaflets in pairs; each branch is the whole, D steps younger.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 5.11; fewer steps than there
   page: 129
*/
#define D 1 /* 0 … 10 */
#define R 1.5 /* 1 … 2 */
#define n 11 /* 1 … 40 */
angle increment: 45
derivation length: n

axiom: A(0)

A(d) : d>0 --> A(d-1)
A(d) : d=0 --> F(1) [+A(D)] [-A(D)] F(1) A(0)
F(a) --> F(a*R)
`,
	"cordate-leaf": `/* Cordate leaf
   about: Its blade is made of polygons between growing ribs.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 5.5
   page: 122
*/
angle increment: 16
derivation length: 20

axiom: [A] [B]

A --> [+A {.] . C .}
B --> [-B {.] . C .}
C --> G C
`,
	crocus: `/* Crocus
   about: Leaves first, then one flower.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 3.2; shapes are ours
   page: 69
*/
#define Ta 7 /* 2 … 20 */
#define Tl 9 /* 1 … 20 */
#define Tk 5 /* 1 … 20 */
derivation length: 20

axiom: a(1)

a(t) : t<Ta --> F(1) [&(30) L(0)] /(137.5) a(t+1)
a(t) : t=Ta --> F(20) A
A --> K(0)
L(t) : t<Tl --> L(t+1)
K(t) : t<Tk --> K(t+1)
F(l) : l<2 --> F(l+0.2)

homomorphism
L(t) --> ~leaf(2*t)
K(t) --> ~flower(2*t)
`,
	"cyme-double": `/* Double cyme
   about: Each axis ends in a flower and goes on with two branches.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3: the type; numbers and shapes are ours
*/
derivation length: 7

axiom: A

A --> F(1) [&(40) /(90) A] [^(40) /(90) A] F(0.4) K(0)
K(t) --> K(t+1)

homomorphism
L --> ~leaf(1.6)
K(t) --> ~flower(min(0.8, 0.1*t))
`,
	cyme: `/* Simple cyme
   about: Each axis ends in a flower and goes on with one branch, to the same side.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3: the type; numbers and shapes are ours
*/
derivation length: 12

axiom: A

A --> F(1) [F(0.4) K(0)] +(30) A
K(t) --> K(t+1)

homomorphism
L --> ~leaf(1.6)
K(t) --> ~flower(min(0.8, 0.1*t))
`,
	"dragon-curve": `/* Dragon curve
   about: Two kinds of edge, one turning left and one right.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.10 a
   page: 11
*/
angle increment: 90
derivation length: 10

axiom: Fl

Fl --> Fl+Fr+
Fr --> -Fl-Fr

homomorphism
Fl --> F
Fr --> F
`,
	"flower-field": `/* Flower field
   about: Sixteen plants, no two alike.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.28; rows and distances are ours
   page: 29
*/
#define apart 24 /* 5 … 60 */
angle increment: 18
derivation length: 5

axiom: [row] -(90) f(apart) +(90) [row] -(90) f(apart) +(90) [row] -(90) f(apart) +(90) [row]

row --> [/(10) plant] &(90) f(apart) ^(90) [/(100) plant] &(90) f(apart) ^(90) [/(190) plant] &(90) f(apart) ^(90) [/(280) plant]
plant --> internode + [plant + flower] -- // [-- leaf] internode [++ leaf] - [plant flower] ++ plant flower
internode --> F seg [// && leaf] [// ^^ leaf] F seg
seg --> seg [// && leaf] [// ^^ leaf] F seg : 0.33
seg --> seg F seg : 0.33
seg --> seg : 0.34
leaf --> [' {+f-f f-f+|+f-f f-f}]
flower --> [&&& pedicel ' / wedge //// wedge //// wedge //// wedge //// wedge]
pedicel --> F F
wedge --> [' ^ F][{&&&& -f+f|-f+f}]
`,
	"flowering-plant": `/* Flowering plant
   about: A plant of internodes, leaves and flowers.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.26
   page: 27
*/
angle increment: 18
derivation length: 5

axiom: plant

plant --> internode + [plant + flower] -- // [-- leaf] internode [++ leaf] - [plant flower] ++ plant flower
internode --> F seg [// && leaf] [// ^^ leaf] F seg
seg --> seg F seg
leaf --> [' {+f-f f-f+|+f-f f-f}]
flower --> [&&& pedicel ' / wedge //// wedge //// wedge //// wedge //// wedge]
pedicel --> F F
wedge --> [' ^ F][{&&&& -f+f|-f+f}]
`,
	"flowering-signal": `/* Flowering by a signal
   about: A signal starts at the base after a while and turns the apex into flowers.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), L-system 3.1, put in other words; values are ours
   page: 77
*/
#define d 12 /* 1 … 30 */
#define m 2 /* 1 … 10 */
#define u 1 /* 1 … 10 */
angle increment: 45
derivation length: 40
ignore: + - /

axiom: D(1) a(1)

D(i) : i<d --> D(i+1)
D(i) : i=d --> s(1)
s(i) < a(j) --> I A
s(i) : i=u --> *
s(i) : i<u --> s(i+1)
s(i) < I : i=u --> I s(1)
a(i) : i<m --> a(i+1)
a(i) : i=m --> I [+L] /(180) a(1)
A --> I [+K(0)] /(180) A
K(t) : t<6 --> K(t+1)

homomorphism
I --> F(1)
L --> ~leaf(2)
K(t) --> ~flower(0.3*t)
s(i) --> ;(7) @O(0.4)
`,
	"hexagonal-gosper": `/* Hexagonal Gosper curve
   about: A curve that fills a plane of hexagons.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.11 a
   page: 12
*/
angle increment: 60
derivation length: 4

axiom: Fl

Fl --> Fl+Fr++Fr-Fl--Fl Fl-Fr+
Fr --> -Fl+Fr Fr++Fr+Fl--Fl-Fr

homomorphism
Fl --> F
Fr --> F
`,
	"hilbert-cube": `/* Hilbert curve in space
   about: A curve that comes to every point of a cube once.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.19
   page: 20
*/
angle increment: 90
derivation length: 3

axiom: A

A --> B-F+C F C+F-D&F^D-F+&&C F C+F+B//
B --> A&F^C F B^F^D^^-F-D^|F^B|F C^F^A//
C --> |D^|F^B-F+C^F^A&&F A&F^C+F+B^F^D//
D --> |C F B-F+B|F A&F^A&&F B-F+B|F C//
`,
	"hilbert-curve": `/* Hilbert curve
   about: Four copies, two of them mirrored, joined by three lines.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 1.4.2; after Hilbert 1891
*/
angle increment: 90
derivation length: 5

axiom: L

L --> +R F-L F L-F R+
R --> -L F+R F R+F L-
`,
	"hogeweg-hesper-a": `/* Hogeweg and Hesper’s plant a
   about: Cells in one of two states, each changed by its neighbours.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.31 a; after Hogeweg and Hesper 1974; o and i are 0 and 1 there
   page: 35
*/
angle increment: 22.5
derivation length: 30
ignore: + - F

axiom: F i F i F i

o < o > o --> o
o < o > i --> i[+F i F i]
o < i > o --> i
o < i > i --> i
i < o > o --> o
i < o > i --> i F i
i < i > o --> o
i < i > i --> o
+ --> -
- --> +
`,
	"hogeweg-hesper-b": `/* Hogeweg and Hesper’s plant b
   about: Cells in one of two states, each changed by its neighbours.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.31 b; after Hogeweg and Hesper 1974; o and i are 0 and 1 there
   page: 35
*/
angle increment: 22.5
derivation length: 30
ignore: + - F

axiom: F i F i F i

o < o > o --> i
o < o > i --> i[-F i F i]
o < i > o --> i
o < i > i --> i
i < o > o --> o
i < o > i --> i F i
i < i > o --> i
i < i > i --> o
+ --> -
- --> +
`,
	"hogeweg-hesper-c": `/* Hogeweg and Hesper’s plant c
   about: Cells in one of two states, each changed by its neighbours.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.31 c; after Hogeweg and Hesper 1974; o and i are 0 and 1 there
   page: 35
*/
angle increment: 25.75
derivation length: 26
ignore: + - F

axiom: F i F i F i

o < o > o --> o
o < o > i --> i
o < i > o --> o
o < i > i --> i[+F i F i]
i < o > o --> o
i < o > i --> i F i
i < i > o --> o
i < i > i --> o
+ --> -
- --> +
`,
	"hogeweg-hesper-d": `/* Hogeweg and Hesper’s plant d
   about: Cells in one of two states, each changed by its neighbours.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.31 d; after Hogeweg and Hesper 1974; o and i are 0 and 1 there
   page: 35
*/
angle increment: 25.75
derivation length: 24
ignore: + - F

axiom: F o F i F i

o < o > o --> i
o < o > i --> o
o < i > o --> o
o < i > i --> i F i
i < o > o --> i
i < o > i --> i[+F i F i]
i < i > o --> i
i < i > i --> o
+ --> -
- --> +
`,
	"hogeweg-hesper-e": `/* Hogeweg and Hesper’s plant e
   about: Cells in one of two states, each changed by its neighbours.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.31 e; after Hogeweg and Hesper 1974; o and i are 0 and 1 there
   page: 35
*/
angle increment: 22.5
derivation length: 26
ignore: + - F

axiom: F i F i F i

o < o > o --> o
o < o > i --> i[-F i F i]
o < i > o --> i
o < i > i --> i
i < o > o --> o
i < o > i --> i F i
i < i > o --> i
i < i > i --> o
+ --> -
- --> +
`,
	"islands-and-lakes": `/* Islands and lakes
   about: A move without drawing leaves islands in the lakes and lakes in the islands.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.8
   page: 9
*/
angle increment: 90
derivation length: 2

axiom: F+F+F+F

F --> F+f-F F+F+F F+F f+F F-f+F F-F-F F-F f-F F F
f --> f f f f f f
`,
	"koch-curve-a": `/* Koch curve a
   about: One of a sequence of Koch curves, made by small changes of the successor.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.9 a
   page: 10
*/
angle increment: 90
derivation length: 4

axiom: F-F-F-F

F --> F F-F-F-F-F-F+F
`,
	"koch-curve-b": `/* Koch curve b
   about: One of a sequence of Koch curves, made by small changes of the successor.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.9 b
   page: 10
*/
angle increment: 90
derivation length: 4

axiom: F-F-F-F

F --> F F-F-F-F-F F
`,
	"koch-curve-c": `/* Koch curve c
   about: One of a sequence of Koch curves, made by small changes of the successor.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.9 c
   page: 10
*/
angle increment: 90
derivation length: 3

axiom: F-F-F-F

F --> F F-F+F-F-F F
`,
	"koch-curve-d": `/* Koch curve d
   about: One of a sequence of Koch curves, made by small changes of the successor.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.9 d
   page: 10
*/
angle increment: 90
derivation length: 4

axiom: F-F-F-F

F --> F F-F--F-F
`,
	"koch-curve-e": `/* Koch curve e
   about: One of a sequence of Koch curves, made by small changes of the successor.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.9 e
   page: 10
*/
angle increment: 90
derivation length: 5

axiom: F-F-F-F

F --> F-F F--F-F
`,
	"koch-curve-f": `/* Koch curve f
   about: One of a sequence of Koch curves, made by small changes of the successor.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.9 f
   page: 10
*/
angle increment: 90
derivation length: 4

axiom: F-F-F-F

F --> F-F+F-F-F
`,
	"koch-island-18": `/* Koch island with 18 edges
   about: Each edge of a square is replaced by eighteen.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.7 a
   page: 9
*/
angle increment: 90
derivation length: 2

axiom: F-F-F-F

F --> F+F F-F F-F-F+F+F F-F-F+F+F F+F F-F
`,
	"koch-island": `/* Quadratic Koch island
   about: Each edge of a square is replaced by eight.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.6
   page: 8
*/
angle increment: 90
derivation length: 3

axiom: F-F-F-F

F --> F-F+F+F F-F-F+F
`,
	"koch-parametric": `/* Uneven Koch curve
   about: Four edges of three lengths.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.37
   page: 48
*/
#define c 1
#define p 0.3 /* 0.1 … 0.9 */
#define q c-p
#define h (p*q)^0.5
angle increment: 86 /* 60 … 90 */
derivation length: 6

axiom: -(90) F(1)

F(x) --> F(x*p) + F(x*h) -- F(x*h) + F(x*q)
`,
	leaf: `/* Leaf
   about: Blade, midrib and side veins of one rule; its numbers make other outlines.
   source: Interactive fractal tree generation method having multiple clipping volumes (Seo, Kim and Lee 2014), table 2, mended: the order of the corners, the tip and the bend; its choice of Fun is a family of functions, and the veins are ours
*/
#define n 49 /* 9 … 161 step 8 */
#define lo 1 /* 0.1 … 3 */
#define theta 105 /* 10 … 170 */
#define beta 0.6 /* -3 … 3 */
#define offset 0 /* 0 … 1 */
#define fall 1 /* 0 … 1 */
#define bow 1.5 /* 0 … 4 */
#define slim 0 /* 0 … 5 */
#define lobe 0 /* 0 … 1 */
#define turns 0 /* 0 … 720 */
#define round 1 /* 0.2 … 3 */
#define teeth 0 /* 0 … 0.5 */
#define veins 7 /* 0 … 12 */
#define reach 0.9 /* 0 … 1 */
#define feather 1 /* 0 … 1 */
#define stalk 0.35 /* 0 … 2 */
#define thick 4.5 /* 0 … 20: of the blade, thousandths; 0.27 mm in the preset's unit */
#define k floor(n/2)
#define alpha theta/k

derivation length: k+1

axiom: !(0.03) F(stalk) {(thick/1000) . L(1) [V(0).] R(1) } [!(0.025) M(0)] W(1)

L(i) : i<=k --> L(i+1) [+(alpha*i) &(beta*i*24/k) V(i/k).]
R(i) : i<=k --> [-(alpha*i) &(beta*i*24/k) V(i/k).] R(i+1)
W(i) : i<=veins --> [!(0.012) N(i/veins*reach, 1)] [!(0.012) N(i/veins*reach, -1)] W(i+1)

homomorphism
V(t) : {r = offset+lo*(1-fall*t)^bow*exp(-slim*t)*(1-lobe+lobe*abs(cos(turns*t)))^round*(1+teeth*cos(3600*t))} --> g(r)
M(t) : {r = offset+lo*(1-fall*t)^bow*exp(-slim*t)*(1-lobe+lobe*abs(cos(turns*t)))^round*(1+teeth*cos(3600*t))} --> F(0.97*r)
N(t,side) : {r = offset+lo*(1-fall*t)^bow*exp(-slim*t)*(1-lobe+lobe*abs(cos(turns*t)))^round*(1+teeth*cos(3600*t)); x = r*cos(24*beta*t)*cos(theta*t); y = r*cos(24*beta*t)*sin(theta*t); z = r*sin(24*beta*t); s = feather*max(0, x-0.84*y)} --> f(s) +(side*atan2(y, x-s)) &(atan2(z, sqrt((x-s)^2+y^2))) F(0.96*sqrt((x-s)^2+y^2+z^2))
`,
	lilac: `/* Lilac
   about: A panicle whose branches stand in crossed pairs, grown from its nodes. Syringa vulgaris.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3: the type; numbers and shapes are ours
*/
derivation length: 16

axiom: A(9, 1)

A(n,s) : n>0 --> F(s) [&(50) A(n-4,s*0.5)] [^(50) A(n-4,s*0.5)] /(90) A(n-1,s*0.93)
A(n,s) : n<=0 --> F(s) K(0)
F(s) : s<1.2 --> F(s*1.04)
K(t) --> K(t+1)

homomorphism
K(t) : t<6 --> ;(5) ~bud(0.06*t)
K(t) --> ;(5) ~flower(0.45)
`,
	"monopodial-tree": `/* Monopodial tree
   about: One trunk goes on; branches go to its sides. After Honda.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 2.6; after Honda 1971
   page: 56
*/
#define r1 0.9 /* 0.5 … 1 */
#define r2 0.6 /* 0.4 … 1 */
#define a0 45 /* 0 … 90 */
#define a2 45 /* -90 … 90 */
#define d 137.5 /* 0 … 360 */
#define wr 0.707 /* 0.5 … 0.9 */
derivation length: 10

axiom: A(1, 10)

A(l,w) --> !(w) F(l) [&(a0) B(l*r2, w*wr)] /(d) A(l*r1, w*wr)
B(l,w) --> !(w) F(l) [-(a2) $ C(l*r2, w*wr)] C(l*r1, w*wr)
C(l,w) --> !(w) F(l) [+(a2) $ B(l*r2, w*wr)] B(l*r1, w*wr)
`,
	panicle: `/* Panicle
   about: A raceme of racemes of racemes.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3: the type; numbers and shapes are ours
*/
derivation length: 14

axiom: A(9)

A(n) : n>0 --> F(0.25*(n+1)^0.5) [&(50) A(n-3)] /(137.5) A(n-1)
A(n) : n<=0 --> F(0.3) K(0)
K(t) --> K(t+1)

homomorphism
L --> ~leaf(1.6)
K(t) --> ~flower(min(0.8, 0.1*t))
`,
	"parametric-example": `/* Parametric L-system
   about: What numbers do in a grammar, in ten steps.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 1.10; drawing is ours
   page: 42
*/
derivation length: 4

axiom: B(2) A(4, 4)

A(x,y) : y<=3 --> A(x*2, x+y)
A(x,y) : y>3 --> B(x) A(x/y, 0)
B(x) : x<1 --> C
B(x) : x>=1 --> B(x-1)

homomorphism
A(x,y) --> ;(3) F(1+x)
B(x) --> ;(6) F(1+x)
C --> ;(7) F
`,
	"peano-curve": `/* Peano curve
   about: Nine copies, joined by eight lines.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 1.4.2; after Peano 1890
*/
angle increment: 90
derivation length: 3

axiom: L

L --> L F R F L-F-R F L F R+F+L F R F L
R --> R F L F R+F+L F R F L-F-R F L F R
`,
	"phyllotaxis-cylinder": `/* Phyllotaxis on a cylinder
   about: Each scale turned on from the one before and a little higher.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 4.2
   page: 111
*/
#define a 137.5281 /* 130 … 145 step 0.01 */
#define h 35.3 /* 5 … 100 */
#define r 500 /* 100 … 1000 */
derivation length: 80

axiom: A

A --> [&(90) f(r) D] f(h) /(a) A

homomorphism
D --> ;(3) @O(r/2)
`,
	"phyllotaxis-disc": `/* Phyllotaxis on a disc
   about: Each floret 137.5° on from the one before, as far out as the root of its number.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 4.1; after Vogel 1979
   page: 100
*/
#define a 137.5 /* 130 … 145 step 0.1 */
derivation length: 460

axiom: A(0)

A(n) --> +(a) [f(n^0.5) D] A(n+1)

homomorphism
D --> ;(6) @O(1.4)
`,
	"plant-a": `/* Plant-like structure a
   about: A branching structure in a plane, by brackets.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.24 a
   page: 25
*/
angle increment: 25.7
derivation length: 5

axiom: F

F --> F[+F]F[-F]F
`,
	"plant-b": `/* Plant-like structure b
   about: A branching structure in a plane, by brackets.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.24 b
   page: 25
*/
angle increment: 20
derivation length: 5

axiom: F

F --> F[+F]F[-F][F]
`,
	"plant-c": `/* Plant-like structure c
   about: A branching structure in a plane, by brackets.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.24 c
   page: 25
*/
angle increment: 22.5
derivation length: 4

axiom: F

F --> F F-[-F+F+F]+[+F-F-F]
`,
	"plant-d": `/* Plant-like structure d
   about: A branching structure in a plane, by brackets.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.24 d
   page: 25
*/
angle increment: 20
derivation length: 7

axiom: X

X --> F[+X]F[-X]+X
F --> F F
`,
	"plant-e": `/* Plant-like structure e
   about: A branching structure in a plane, by brackets.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.24 e
   page: 25
*/
angle increment: 25.7
derivation length: 7

axiom: X

X --> F[+X][-X]F X
F --> F F
`,
	"plant-f": `/* Plant-like structure f
   about: A branching structure in a plane, by brackets.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.24 f
   page: 25
*/
angle increment: 22.5
derivation length: 5

axiom: X

X --> F-[[X]+X]+F[+F X]-X
F --> F F
`,
	"pruned-branch": `/* Branch that is pruned
   about: Where an apex leaves the box it dies, and a signal wakes the buds below it.
   source: Synthetic topiary (Prusinkiewicz, James and Měch 1994), section 3; the box, that X vanishes and that a signal leaves its branch are ours; X, Z and D are T, S and @o there
*/
#define size 5.5 /* 2 … 12 */
#define high 12 /* 2 … 30 */
angle increment: 32
derivation length: 150
ignore: + /

axiom: F A ?P(0,0,0)

A > ?P(x,y,z) : max(abs(x),abs(z))<size && y>=0 && y<high --> D F /(180) A
A > ?P(x,y,z) : max(abs(x),abs(z))>=size || y<0 || y>=high --> X %
F > X --> Z
X --> *
F > Z --> Z F
F > [Z] --> Z F
Z --> *
D > Z --> [+ F A ?P(0,0,0)]
`,
	"pruned-tree": `/* Tree clipped to a cube
   about: A tree of Borchert and Slade’s, pruned wherever it leaves a cube.
   source: Synthetic topiary (Prusinkiewicz, James and Měch 1994), section 4; the cube, that X vanishes, that a signal leaves its branch and when a bud wakes are ours; X and Z are T and S there
*/
#define size 6 /* 2 … 20 */
#define phi 90 /* 0 … 180 */
#define alpha 32 /* 0 … 90 */
#define beta 20 /* 0 … 90 */
derivation length: 24
ignore: + - /

axiom: F A(1) ?P(0,0,0)

A(k) > ?P(x,y,z) : max(max(abs(x),abs(z)),abs(y-size))<size --> /(phi) [+(alpha) F A(k+1) ?P(0,0,0)] -(beta) F A(k+1) : min(1, (2*k+1)/k^2)
A(k) > ?P(x,y,z) : max(max(abs(x),abs(z)),abs(y-size))<size --> /(phi) B(k+1,k+1) -(beta) F A(k+1) : max(0, 1-(2*k+1)/k^2)
A(k) > ?P(x,y,z) : max(max(abs(x),abs(z)),abs(y-size))>=size --> X %
F > X --> Z
X --> *
F > Z --> Z F
F > [Z] --> Z F
Z --> *
B(m,n) > Z --> [+(alpha) F A(m) ?P(0,0,0)]
B(m,n) > F --> B(m+1,n)
`,
	"quadratic-gosper": `/* Quadratic Gosper curve
   about: A curve that fills a square; it comes to every point of the grid once.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.11 b
   page: 12
*/
angle increment: 90
derivation length: 2

axiom: -Fr

Fl --> Fl Fl-Fr-Fr+Fl+Fl-Fr-Fr Fl+Fr+Fl Fl Fr-Fl+Fr+Fl Fl+Fr-Fl Fr-Fr-Fl+Fl+Fr Fr-
Fr --> +Fl Fl-Fr-Fr+Fl+Fl Fr+Fl-Fr Fr-Fl-Fr+Fl Fr Fr-Fl-Fr Fl+Fl+Fr-Fr-Fl+Fl+Fr Fr

homomorphism
Fl --> F
Fr --> F
`,
	"quadratic-snowflake": `/* Quadratic snowflake curve
   about: The snowflake curve with right angles.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.7 b
   page: 9
*/
angle increment: 90
derivation length: 4

axiom: -F

F --> F+F-F-F+F
`,
	"raceme-closed": `/* Closed raceme
   about: A raceme whose axis ends in a flower.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3: the type; numbers and shapes are ours
*/
derivation length: 16

axiom: A(12)

A(n) : n>0 --> F(0.8) [&(50) F(0.5) K(0)] /(137.5) A(n-1)
A(n) : n=0 --> F(0.8) K(0)
K(t) --> K(t+1)

homomorphism
L --> ~leaf(1.6)
K(t) --> ~flower(min(0.8, 0.1*t))
`,
	raceme: `/* Open raceme
   about: The axis bears leaves, then flowers from below upwards, without end.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3: the type; numbers and shapes are ours
*/
derivation length: 16

axiom: a(5)

a(t) : t>0 --> F(1) [&(60) L] /(137.5) a(t-1)
a(t) : t=0 --> A
A --> F(0.8) [&(50) F(0.5) K(0)] /(137.5) A
K(t) --> K(t+1)

homomorphism
L --> ~leaf(1.6)
K(t) --> ~flower(min(0.8, 0.1*t))
`,
	"rose-campion": `/* Rose campion
   about: A cyme that forks at every flower, the two branches not of the same age. Lychnis coronaria.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3.2; shapes are ours
   page: 84
*/
derivation length: 28

axiom: A(7)

A(t) : t=7 --> F I(20) [&(60) L(0)] /(90) [&(45) A(0)] /(90) [&(60) L(0)] /(90) [&(45) A(4)] F I(10) K(0)
A(t) : t<7 --> A(t+1)
I(t) : t>0 --> F F I(t-1)
L(t) --> L(t+1)
K(t) --> K(t+1)

homomorphism
L(t) --> ~leaf(min(6, 0.6*t))
K(t) : t<10 --> ~flower(0.5*t)
K(t) --> ~bud(3)
`,
	"rose-leaf": `/* Rose leaf
   about: A leaf with notches along its margin.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 5.8
   page: 126
*/
#define LA 5 /* 1 … 10 */
#define RA 1.15 /* 1 … 1.5 */
#define LB 1.3 /* 0.2 … 5 */
#define RB 1.25 /* 1 … 1.5 */
#define LC 3 /* 0.2 … 10 */
#define RC 1.19 /* 1 … 1.5 */
angle increment: 60
derivation length: 25

axiom: [{A(0,0).}] [{A(0,1).}]

A(t,d) : d=0 --> . G(LA,RA) . [+B(t) G(LC,RC,t) .}] [+B(t) {.] A(t+1,d)
A(t,d) : d=1 --> . G(LA,RA) . [-B(t) G(LC,RC,t) .}] [-B(t) {.] A(t+1,d)
B(t) : t>0 --> G(LB,RB) B(t-1)
G(s,r) --> G(s*r,r)
G(s,r,t) : t>1 --> G(s*r,r,t-1)
`,
	"row-of-trees": `/* Row of trees
   about: The uneven Koch curve with delays grows into trees.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.38
   page: 49
*/
#define c 1
#define p 0.3 /* 0.1 … 0.9 */
#define q c-p
#define h (p*q)^0.5
angle increment: 86
derivation length: 10

axiom: -(90) F(1,0)

F(x,t) : t=0 --> F(x*p,2) + F(x*h,1) -- F(x*h,1) + F(x*q,0)
F(x,t) : t>0 --> F(x,t-1)
`,
	"shepherds-purse": `/* Shepherd’s purse
   about: A raceme that goes on for ever: fruit below, buds above. Capsella bursa-pastoris.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3.1; leaf, flower and fruit are ours
   page: 74
*/
angle increment: 18
derivation length: 34

axiom: I(9) a(13)

a(t) : t>0 --> [&(70) L] /(137.5) I(10) a(t-1)
a(t) : t=0 --> [&(70) L] /(137.5) I(10) A
A --> [&(18) u(4) F F I(10) I(5) X(5)] /(137.5) I(8) A
I(t) : t>0 --> F I(t-1)
I(t) : t=0 --> F
u(t) : t>0 --> &(9) u(t-1)
u(t) : t=0 --> &(9)
X(t) : t>0 --> X(t-1)

homomorphism
L --> ~leaf(12)
X(t) : t>0 --> ~flower(6-t)
X(t) --> ;(4) ~bud(5)
`,
	shrub: `/* Shrub
   about: A tree whose side branches leave one another by the golden angle, with leaves at its ends: a text to begin with.
   source: own text
*/

#define angle 42      /* 10 … 80: between a branch and its bearer, degrees */
#define shrink 0.86   /* 0.6 … 0.95: an internode over the one before */
#define side 0.72     /* 0.4 … 0.9: a branch over its bearer */
#define golden 137.5  /* 90 … 180: between a branch and the next, degrees */
#define blade 12      /* 4 … 30: length of a leaf */

derivation length: 16
axiom: A(20)

A(l) : l>2.4  --> F(l) [ &(angle+ran(8)) B(l*side) ] /(golden) A(l*shrink)
A(l) : l<=2.4 --> L /(golden) L
B(l) : l>2.4  --> F(l) [ &(angle) B(l*side*side) ] /(golden) B(l*shrink)
B(l) : l<=2.4 --> L /(golden) L
L --> [ &(35+ran(30)) /(ran(40)-20) F(1.5) ~leaf(blade*(0.7+ran(0.5))) ]
`,
	"sierpinski-gasket": `/* Sierpinski gasket
   about: One curve that fills the gasket.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.10 b
   page: 11
*/
angle increment: 60
derivation length: 6

axiom: Fr

Fl --> Fr+Fl+Fr
Fr --> Fl-Fr-Fl

homomorphism
Fl --> F
Fr --> F
`,
	"signal-acropetal": `/* Signal towards the tips
   about: A signal goes from the base into every branch.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.30 a; 45° are ours
   page: 33
*/
angle increment: 45
derivation length: 3
ignore: + -

axiom: Fb [+Fa] Fa [-Fa] Fa [+Fa] Fa

Fb < Fa --> Fb

homomorphism
Fa --> ;(2) F
Fb --> ;(7) F
`,
	"signal-basipetal": `/* Signal towards the base
   about: A signal goes from the tip down the axis, and into no branch.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.30 b; 45° are ours
   page: 33
*/
angle increment: 45
derivation length: 3
ignore: + -

axiom: Fa [+Fa] Fa [-Fa] Fa [+Fa] Fb

Fa > Fb --> Fb

homomorphism
Fa --> ;(2) F
Fb --> ;(7) F
`,
	signal: `/* Signal along a filament
   about: A signal passes from cell to cell, one a step.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 1.8; drawing is ours
   page: 30
*/
derivation length: 5

axiom: b a a a a a a a a

b < a --> b
b --> a

homomorphism
a --> ;(2) F
b --> ;(7) F
`,
	"simple-leaf": `/* Simple leaf
   about: One rule, six leaves: how fast its segments grow and for how long.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 5.6
   page: 124
*/
#define LA 5 /* 1 … 10 */
#define RA 1.1 /* 1 … 1.5 */
#define LB 1 /* 0.2 … 10 */
#define RB 1.2 /* 1 … 1.5 */
#define PD 1 /* 0 … 2 */
angle increment: 60
derivation length: 20

axiom: {.A(0)}

A(t) --> G(LA,RA) [-B(t).] [A(t+1)] [+B(t).]
B(t) : t>0 --> G(LB,RB) B(t-PD)
G(s,r) --> G(s*r,r)
`,
	spike: `/* Spike
   about: A raceme whose flowers have no stalks.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3: the type; numbers and shapes are ours
*/
derivation length: 30

axiom: F(4) A

A --> F(0.3) [&(60) K(0)] /(137.5) A
K(t) --> K(t+1)

homomorphism
L --> ~leaf(1.6)
K(t) --> ~flower(min(0.8, 0.1*t))
`,
	"square-curve-3": `/* Square-filling curve of 3 × 3 tiles
   about: A curve that comes to every point of a square once.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.16 a
   page: 17
*/
angle increment: 90
derivation length: 3

axiom: -L

L --> L F+R F R+F L-F-L F L F L-F R F R+
R --> -L F L F+R F R F R+F+R F-L F L-F R
`,
	"square-curve-4": `/* Square-filling curve of 4 × 4 tiles
   about: A curve that comes to every point of a square once.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.16 b
   page: 17
*/
angle increment: 90
derivation length: 2

axiom: -L

L --> L F L F+R F R+F L F L-F R F-L F L-F R+F+R F-L F L-F R F R F R+
R --> -L F L F L F+R F R+F L-F-L F+R F R+F L F+R F R F-L F L-F R F R
`,
	"square-root-growth": `/* Growth as a square root
   about: A signal runs to and fro between the ends: the length is 4 and the square root of the time.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 1.9; drawing is ours
   page: 38
*/
derivation length: 36

axiom: X Fu Fa X

Fu < Fa > Fa --> Fu
Fu < Fa > X --> Fd Fa
Fa < Fa > Fd --> Fd
X < Fa > Fd --> Fu
Fu --> Fa
Fd --> Fa

homomorphism
Fa --> ;(2) F
Fu --> ;(7) F
Fd --> ;(8) F
`,
	"stochastic-plant": `/* Stochastic plant
   about: Which of three ways an edge is replaced is drawn by lot.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 1.27; the angle is ours
   page: 29
*/
angle increment: 25.7
derivation length: 5

axiom: F

F --> F[+F]F[-F]F : 0.33
F --> F[+F]F : 0.33
F --> F[-F]F : 0.34
`,
	sunflower: `/* Sunflower head
   about: Florets by age: seeds within, then flowers, then rays.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 4.3; shapes are ours
   page: 103
*/
#define a 137.5 /* 130 … 145 step 0.1 */
derivation length: 634

axiom: A(0)

A(n) --> +(a) [f(n^0.5) C(n)] A(n+1)

homomorphism
C(n) : n<=440 --> ;(1) @O(1.5)
C(n) : n<=565 --> ;(4) @O(1.3)
C(n) : n<=600 --> ;(6) ^(60) ~petal(5)
C(n) --> ;(6) ^(20) ~petal(14)
`,
	"sympodial-tree": `/* Sympodial tree
   about: Every axis ends in two others. After Aono and Kunii.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 2.7; after Aono and Kunii 1984
   page: 59
*/
#define r1 0.9 /* 0.5 … 1 */
#define r2 0.7 /* 0.4 … 1 */
#define a1 5 /* 0 … 90 */
#define a2 65 /* 0 … 90 */
#define wr 0.707 /* 0.5 … 0.9 */
derivation length: 10

axiom: A(1, 10)

A(l,w) --> !(w) F(l) [&(a1) B(l*r1, w*wr)] /(180) [&(a2) B(l*r2, w*wr)]
B(l,w) --> !(w) F(l) [+(a1) $ B(l*r1, w*wr)] [-(a2) $ B(l*r2, w*wr)]
`,
	"ternary-tree": `/* Ternary tree
   about: Three branches at every node, bent by a tropism.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), figure 2.8
   page: 60
*/
#define d1 94.74 /* 0 … 360 */
#define d2 132.63 /* 0 … 360 */
#define a 18.95 /* 0 … 90 */
#define lr 1.109 /* 1 … 2 */
#define vr 1.732 /* 1 … 2 */
#define tx 0 /* -1 … 1 */
#define ty -1 /* -1 … 1 */
#define tz 0 /* -1 … 1 */
#define e 0.22 /* 0 … 1 */
#define n 6 /* 0 … 8 */
tropism: tx, ty, tz, e
derivation length: n

axiom: !(1) F(200) /(45) A

A --> !(vr) F(50) [&(a) F(50) A] /(d1) [&(a) F(50) A] /(d2) [&(a) F(50) A]
F(l) --> F(l*lr)
!(w) --> !(w*vr)
`,
	thyrsus: `/* Thyrsus
   about: A raceme of double cymes.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3: the type; numbers and shapes are ours
*/
derivation length: 14

axiom: A(10)

A(n) : n>0 --> F(1) [&(55) D(0.12*n+0.3)] /(180) [&(55) D(0.12*n+0.3)] /(90) A(n-1)
A(n) : n=0 --> F(1) K(0)
D(s) : s>0.5 --> F(s) [+(40) D(s*0.65)] [-(40) D(s*0.65)] F(s/2) K(0)
D(s) : s<=0.5 --> F(s) K(0)
K(t) --> K(t+1)

homomorphism
L --> ~leaf(1.6)
K(t) --> ~flower(min(0.8, 0.1*t))
`,
	topiary: `/* Topiary
   about: A main branch that passes from growth area to growth area, and laterals that stay inside theirs.
   source: Seo, Kim and Lee 2014, Table 1, restored
*/

#turtle cpfg

#input areas       /* growth areas, counted from 1 */
#input size[]      /* of each area the largest extent */
#input places      /* places that the main branch is led by */
#input path[]      /* their x, y, z */

#define part 15       /* 8 … 24: a leaf is as long as this part of its area's size, */
#define leaf 0        /* 0 … 0.3: or so long in all of them, metres */
#define alpha 35      /* 10 … 60: between a branch of a fork and what bears it */
#define phi 90        /* 0 … 180: how far a fork is rolled against the one before */
#define spread 70     /* 20 … 110: between a lateral and the main branch */
#define vary 0.3      /* 0 … 0.9: how much angles differ */
#define oldest 26     /* 5 … 60: segments from the main branch to a tip, at most */
#define stride 2      /* 0.5 … 4: from node to node of the main branch, leaves */

#role area Area       /* Area(n): what follows belongs to area n; Area(n,1): and is the main branch's */

derivation length: 240

/* ω: the main branch, in search of area 1 */
axiom: C(1, 0, 1) ?P(0,0,0) ?H(0,1,0)

/* What has been answered and read is taken out. */
?P(x,y,z) --> *
?H(x,y,z) --> *

/* The main branch C(area, entered, next place): where it stands and what lies ahead. h: a leaf's length here; m: a
   segment's of the main branch; o: all places are passed. */
C(a,e,j) > ?P(x,y,z) ?H(u,v,w) : {h=leaf+!leaf*size[a]/part; m=h*stride; o=j>places; i=3*min(j,places); p=o*u+!o*(path[i-2]-x); q=o*v+!o*(path[i-1]-y); r=o*w+!o*(path[i]-z)} * -->
  D(a, e, bound(x,y,z,a), reach(x,y,z,p,q,r,a,m), p, q, r, j+(!o && p*p+q*q+r*r<m*m), h*0.85, m)

/* Laterals A(order, area, length of a segment: 0.85 leaves): Borchert and Slade slow their forking down, so that a shell of any radius is as dense. */
A(k,a,l) > ?P(x,y,z) ?H(u,v,w) : {r=reach(x,y,z,u,v,w,a,3*l); f=min(1,(2*k+1)/k^2)} r>=l && k<oldest -->
  F(l) J(r,l) /(phi*(1-vary+ran(2*vary))) [ +(alpha*(1-vary+ran(2*vary))) A(k+1,a,l) ?P(0,0,0) ?H(0,0,0) ] -(alpha*(1-vary+ran(2*vary))) A(k+1,a,l) ?P(0,0,0) ?H(0,0,0) : f
A(k,a,l) > ?P(x,y,z) ?H(u,v,w) : {r=reach(x,y,z,u,v,w,a,3*l); f=min(1,(2*k+1)/k^2)} r>=l && k<oldest -->
  F(l) J(r,l) /(phi*(1-vary+ran(2*vary))) +(alpha/2*(1-2*RND(0,1))*(1-vary+ran(2*vary))) A(k+1,a,l) ?P(0,0,0) ?H(0,0,0) : 1-f
/* The last segment is shortened, so that its tip lies on the surface. */
A(k,a,l) > ?P(x,y,z) ?H(u,v,w) : {r=reach(x,y,z,u,v,w,a,l)} r<l && r>0.15*l --> F(r) J(0,l)
A(k,a,l) > ?P(x,y,z) ?H(u,v,w) --> J(0,l)

decomposition

/* Outside of an area that it has not entered yet, it goes on, across whatever gap. */
D(a,e,in,s,p,q,r,j,l,m) : !in && !e && j<=places --> @R(p,q,r) Area(0,1) F(m) C(a,0,j) ?P(0,0,0) ?H(0,0,0)
/* Inside (P1 of Table 1) it bears laterals, three a node; one segment below the top of the last area it is a lateral itself. */
D(a,e,in,s,p,q,r,j,l,m) : in && (a<areas || s>=m) -->
  @R(p,q,r) /(137.5) [ Area(a) &(spread*(1-vary+ran(2*vary))) A(1,a,l) ?P(0,0,0) ?H(0,0,0) ]
  [ Area(a) /(120) &(spread*(1-vary+ran(2*vary))) A(1,a,l) ?P(0,0,0) ?H(0,0,0) ]
  [ Area(a) /(240) &(spread*(1-vary+ran(2*vary))) A(1,a,l) ?P(0,0,0) ?H(0,0,0) ]
  Area(a,1) F(m) C(a,1,j) ?P(0,0,0) ?H(0,0,0)
D(a,e,in,s,p,q,r,j,l,m) : in --> @R(p,q,r) Area(a) A(1,a,l) ?P(0,0,0) ?H(0,0,0)
/* It has left its area (P2): the next is its own now. */
D(a,e,in,s,p,q,r,j,l,m) : !in && e && a<areas --> @R(p,q,r) Area(0,1) F(m) C(a+1,0,j) ?P(0,0,0) ?H(0,0,0)
D(a,e,in,s,p,q,r,j,l,m) --> *

homomorphism

/* Leaves where the surface is near. */
J(r,l) : r<3*l --> [ /(ran(360)) &(40+ran(30)) ~elliptic(l/0.85) ] [ /(120+ran(60)) &(40+ran(40)) ~elliptic(l/0.85) ] [ /(240+ran(60)) &(20+ran(30)) ~elliptic(l/0.85) ]
`,
	umbel: `/* Umbel
   about: A raceme without internodes: all stalks from one place.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.3: the type; numbers and shapes are ours
*/
derivation length: 22

axiom: F(8) A(20)

A(n) : n>0 --> [&(70*(n/20)^0.5) F(4) K(n)] /(137.5) A(n-1)
K(t) --> K(t+1)

homomorphism
L --> ~leaf(1.6)
K(t) --> ~flower(min(0.8, 0.1*t))
`,
	"wall-lettuce": `/* Wall lettuce
   about: Signals stop the growth and wake the branches from the tip downwards. Mycelis muralis.
   source: The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990), section 3.4, model III; Z, X and B are S, T and G there; that W is considered and the shapes are ours
   page: 90
*/
angle increment: 30
derivation length: 64
consider: M Z X V W

axiom: I(20) F A(0)

Z < A(t) --> X V K(0)
V < A(t) --> X V K(0)
A(t) : t>0 --> A(t-1)
A(t) : t=0 --> M [+(30) B] F /(180) A(2)
Z < M --> Z
Z > X --> X
X < B --> F A(2)
V < M --> Z
X > V --> W
W --> V
I(t) : t>0 --> I(t-1)
I(t) : t=0 --> Z
K(t) --> K(t+1)

homomorphism
K(t) --> ~flower(min(1.5, 0.1*t))
B --> ~bud(0.3)
`,
};
