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
	topiary: `/* Topiary
   kind: none
   about: A main branch that passes from growth area to growth area, and laterals that stay inside theirs.
   source: Seo, Kim and Lee 2014, Table 1, restored
   set: unit=1000 thickness=9 thickening=0.36 colour1=6b5a45 colour3=3f6b2c sides=8
*/

#turtle cpfg

#input areas       /* growth areas, counted from 1 */
#input places      /* places that the main branch is led by */
#input path[]      /* their x, y, z */

#define leaf 0.07     /* 0.03 … 0.3: length of a leaf, metres */
#define alpha 35      /* 10 … 60: between a branch of a fork and what bears it */
#define phi 90        /* 0 … 180: how far a fork is rolled against the one before */
#define spread 70     /* 20 … 110: between a lateral and the main branch */
#define vary 0.3      /* 0 … 0.9: how much angles differ */
#define oldest 26     /* 5 … 60: segments from the main branch to a tip, at most */
#define stride 2      /* 0.5 … 4: from node to node of the main branch, leaves */

#define L leaf*0.85   /* a lateral's segment */
#define M leaf*stride /* one of the main branch */

#role area Area       /* Area(n): what follows belongs to area n; Area(n,1): and is the main branch's */

derivation length: 240

/* ω: the main branch, in search of area 1 */
axiom: C(1, 0, 1) ?P(0,0,0) ?H(0,1,0)

/* What has been answered and read is taken out. */
?P(x,y,z) --> *
?H(x,y,z) --> *

/* The main branch C(area, entered, next place): where it stands and what lies ahead. o: all places are passed. */
C(a,e,j) > ?P(x,y,z) ?H(u,v,w) : {o=j>places; i=3*min(j,places); p=o*u+!o*(path[i-2]-x); q=o*v+!o*(path[i-1]-y); r=o*w+!o*(path[i]-z)} 1 -->
  D(a, e, bound(x,y,z,a), reach(x,y,z,p,q,r,a,M), p, q, r, j+(!o && p*p+q*q+r*r<M*M))

/* Laterals A(order, area): Borchert and Slade slow their forking down, so that a shell of any radius is as dense. */
A(k,a) > ?P(x,y,z) ?H(u,v,w) : {r=reach(x,y,z,u,v,w,a,3*L); f=min(1,(2*k+1)/k^2)} r>=L && k<oldest -->
  F(L) J(r) /(phi*(1-vary+ran(2*vary))) [ +(alpha*(1-vary+ran(2*vary))) A(k+1,a) ?P(0,0,0) ?H(0,0,0) ] -(alpha*(1-vary+ran(2*vary))) A(k+1,a) ?P(0,0,0) ?H(0,0,0) : f
A(k,a) > ?P(x,y,z) ?H(u,v,w) : {r=reach(x,y,z,u,v,w,a,3*L); f=min(1,(2*k+1)/k^2)} r>=L && k<oldest -->
  F(L) J(r) /(phi*(1-vary+ran(2*vary))) +(alpha/2*(1-2*RND(0,1))*(1-vary+ran(2*vary))) A(k+1,a) ?P(0,0,0) ?H(0,0,0) : 1-f
/* The last segment is shortened, so that its tip lies on the surface. */
A(k,a) > ?P(x,y,z) ?H(u,v,w) : {r=reach(x,y,z,u,v,w,a,L)} r<L && r>0.15*L --> F(r) J(0)
A(k,a) > ?P(x,y,z) ?H(u,v,w) --> J(0)

decomposition

/* P1: outside of an area that it has not entered yet, it goes on, across whatever gap. */
D(a,e,in,s,p,q,r,j) : !in && !e && j<=places --> @R(p,q,r) Area(0,1) F(M) C(a,0,j) ?P(0,0,0) ?H(0,0,0)
/* P2: inside, it bears laterals, three a node; one segment below the top of the last area it is a lateral itself. */
D(a,e,in,s,p,q,r,j) : in && (a<areas || s>=M) -->
  @R(p,q,r) /(137.5) [ Area(a) &(spread*(1-vary+ran(2*vary))) A(1,a) ?P(0,0,0) ?H(0,0,0) ]
  [ Area(a) /(120) &(spread*(1-vary+ran(2*vary))) A(1,a) ?P(0,0,0) ?H(0,0,0) ]
  [ Area(a) /(240) &(spread*(1-vary+ran(2*vary))) A(1,a) ?P(0,0,0) ?H(0,0,0) ]
  Area(a,1) F(M) C(a,1,j) ?P(0,0,0) ?H(0,0,0)
D(a,e,in,s,p,q,r,j) : in --> @R(p,q,r) Area(a) A(1,a) ?P(0,0,0) ?H(0,0,0)
/* P3: it has left its area: the next is its own now. */
D(a,e,in,s,p,q,r,j) : !in && e && a<areas --> @R(p,q,r) Area(0,1) F(M) C(a+1,0,j) ?P(0,0,0) ?H(0,0,0)
D(a,e,in,s,p,q,r,j) --> *

homomorphism

/* Leaves where the surface is near. */
J(r) : r<3*L --> [ /(ran(360)) &(40+ran(30)) ~leaf(leaf) ] [ /(120+ran(60)) &(40+ran(40)) ~leaf(leaf) ] [ /(240+ran(60)) &(20+ran(30)) ~leaf(leaf) ]
`,
};
