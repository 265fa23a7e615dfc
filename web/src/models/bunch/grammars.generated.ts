// Made from wasm-core/grammars/bunch by wasm-core/tools/generate.mjs; edit the texts, not this.

/** wasm-core/grammars/bunch/grape-bunch-1.lsys */
export const GRAPE_BUNCH_1 = `/* L-system 1: the basic grape bunch, flat (Huang et al. 2013, section 4.3.1). Berries may overlap. */

#turtle huang  /* Table 1 of the paper: + turns right, & pitches up */

#input m    /* derivation steps of the rachis */
#input n[]  /* n[1] … n[m-1]: derivation steps of the first-order axes, from the tip upwards */

#define l 60      /* an internode's initial length */
#define r_l 1     /* length of an internode over the one before */
#define r_r 0.75  /* a berry's radius over the initial length */
#define alpha 45  /* yaw */

#role rachis Ar
#role axis Af
#role end Ae
#role pedicel Ap

axiom: Ar(m, l)

/* p1, p2: the rachis grows an internode and a first-order axis, then ends */
Ar(i,j) : i>1 --> F(j) [ // Ar(i-1, j*r_l) ] [ +(alpha) Af(n[i-1], j*r_l) ]
Ar(i,j) : i=1 --> Ae(j*r_l)

/* p3, p4: a first-order axis grows an internode and an end structure, then ends */
Af(i,j) : i>1 --> F(j) [ // Af(i-1, j*r_l) ] [ +(alpha) Ae(j*r_l) ]
Af(i,j) : i=1 --> Ae(j*r_l)

/* p5, p6: an end structure bears three pedicels, a pedicel one berry */
Ae(j) --> F(j) [ Ap(j*r_l) ] [ +(alpha) Ap(j*r_l) ] [ -(alpha) Ap(j*r_l) ]
Ap(j) --> F(j) S(l*r_r)
`;

/** wasm-core/grammars/bunch/grape-bunch-2.lsys */
export const GRAPE_BUNCH_2 = `/* L-system 2: L-system 1 opened to its environment (Huang et al. 2013, section 4.3.2). Every internode asks
   for room; the environment answers with a turn and a length. */

#turtle huang  /* Table 1 of the paper: + turns right, & pitches up */

#input m    /* derivation steps of the rachis */
#input n[]  /* n[1] … n[m-1]: derivation steps of the first-order axes, from the tip upwards */

#define l_i 60       /* an internode's initial length */
#define l_w 10       /* length of a withered pedicel */
#define r_l 1        /* length of an internode over the one before */
#define r_r 0.75     /* a berry's radius over the initial length */
#define alpha 45     /* yaw */
#define w 6          /* width of a line; left open in print */
#define b_r l_i*r_r  /* radius that a pedicel asks room for */

#role rachis Ar
#role axis Af
#role end Ae
#role pedicel Ap

axiom: Ar(m, l_i)

/* p1 … p4: rachis and first-order axes */
Ar(i,j) : i>1 --> ?E(0,0,j) [ // Ar(i-1, j*r_l) ] [ +(alpha) Af(n[i-1], j*r_l) ]
Ar(i,j) : i=1 --> Ae(j*r_l)
Af(i,j) : i>1 --> ?E(0,0,j) [ // Af(i-1, j*r_l) ] [ +(alpha) Ae(j*r_l) ]
Af(i,j) : i=1 --> Ae(j*r_l)

/* p5, p6: end structure and pedicel */
Ae(j) --> ?E(0,0,j) [ Ap(j*r_l) ] [ +(alpha) Ap(j*r_l) ] [ -(alpha) Ap(j*r_l) ]
Ap(j) --> ?E(1,0,j)

/* p7 … p9: what the environment answered; length 0 is no room at all, l_w a pedicel that lost its berry */
?E(type,theta,l) : type=0 && l>0    --> +(theta) !(w) F(l)
?E(type,theta,l) : type=0 && l=0    --> %
?E(type,theta,l) : type=1 && l=l_w  --> +(theta) !(w) F(l) %
?E(type,theta,l) : type=1 && l!=l_w --> +(theta) !(w) F(l) S(l_i*r_r)
`;

/** wasm-core/grammars/bunch/grape-bunch-3.lsys */
export const GRAPE_BUNCH_3 = `/* L-system 3: the complete grape bunch in space (Huang et al. 2013, section 4.3.3), with what print leaves open
   filled in: the roll of p6, the widths of p1 … p8, the raceme p7b, the cut p10b. \`vary\`, \`stretch\` and \`reach\` are
   ours; vary 0, stretch 1 and reach 1 leave the paper's productions. */

#turtle huang  /* Table 1 of the paper: + turns right, & pitches up */

#input m        /* rachis segments */
#input n[]      /* n[1] … n[m-1]: segments of the first-order axes, from the tip upwards */
#input reach[]  /* reach[1] … reach[m-1]: lengths of each axis, times what the rates give */

#define l_i 50       /* an internode's initial length */
#define l_w 10       /* length of a withered pedicel */
#define w_i 15       /* an internode's initial width */
#define r_w 0.98     /* width of an internode over the one before */
#define r_rr 0.99    /* length: rachis to rachis */
#define r_rf 0.89    /* length: rachis to first-order axis */
#define r_e 0.6      /* length: axis to end structure */
#define r_ff 0.99    /* length: first-order axis to first-order axis */
#define r_p 1.5      /* length: end structure to pedicel */
#define r_min 20     /* least radius of a berry */
#define r_max 30     /* greatest radius of a berry */
#define alpha_y 60   /* yaw */
#define alpha_r 120  /* roll of the outer pedicels */
#define stretch 1    /* lengths of the rachis, times what the rates give */
#define vary 0.3     /* how much modules differ: at 1 by 15° of yaw, 25° of roll and a fifth of their length */

#role rachis Ar1 Ar2 Ar3 Ar4
#role axis Af
#role end Ae
#role pedicel Ap

axiom: Ar1(m, l_i*stretch, w_i)

/* p1 … p4: the rachis, its axes to the right, left, front and back in turn */
Ar1(i,l,w) : i>1 --> ?E(0,0,0,l*(1+vary*(ran(0.4)-0.2)),w,0)
  [ // Ar2(i-1, l*r_rr, w*r_w) ]
  [ /(vary*(ran(50)-25)) +(alpha_y+vary*(ran(30)-15)) Af(n[i-1], l*r_rf*reach[i-1], w*r_w) ]
Ar2(i,l,w) : i>1 --> ?E(0,0,0,l*(1+vary*(ran(0.4)-0.2)),w,0)
  [ / Ar3(i-1, l*r_rr, w*r_w) ]
  [ /(vary*(ran(50)-25)) +(alpha_y+vary*(ran(30)-15)) Af(n[i-1], l*r_rf*reach[i-1], w*r_w) ]
Ar3(i,l,w) : i>1 --> ?E(0,0,0,l*(1+vary*(ran(0.4)-0.2)),w,0)
  [ // Ar4(i-1, l*r_rr, w*r_w) ]
  [ /(vary*(ran(50)-25)) +(alpha_y+vary*(ran(30)-15)) Af(n[i-1], l*r_rf*reach[i-1], w*r_w) ]
Ar4(i,l,w) : i>1 --> ?E(0,0,0,l*(1+vary*(ran(0.4)-0.2)),w,0)
  [ \\ Ar1(i-1, l*r_rr, w*r_w) ]
  [ /(vary*(ran(50)-25)) +(alpha_y+vary*(ran(30)-15)) Af(n[i-1], l*r_rf*reach[i-1], w*r_w) ]

/* p5: the rachis ends in an end structure */
Ar1(i,l,w) : i=1 --> Ae(l*r_e, w)
Ar2(i,l,w) : i=1 --> Ae(l*r_e, w)
Ar3(i,l,w) : i=1 --> Ae(l*r_e, w)
Ar4(i,l,w) : i=1 --> Ae(l*r_e, w)

/* p6, p7, p7b: a first-order axis; one without segments is a single pedicel, as in a raceme */
Af(i,l,w) : i>1 --> ?E(0,0,0,l*(1+vary*(ran(0.4)-0.2)),w,0)
  [ / Af(i-1, l*r_ff, w*r_w) ]
  [ /(vary*(ran(50)-25)) +(alpha_y+vary*(ran(30)-15)) Ae(l*r_e, w*r_w) ]
Af(i,l,w) : i=1 --> Ae(l*r_e, w)
Af(i,l,w) : i<1 --> Ap(l*r_e*r_p, w*r_w)

/* p8: three pedicels at the end of a twig */
Ae(l,w) --> ?E(0,0,0,l,w,0)
  [ Ap(l*r_p, w*r_w) ]
  [ /(vary*(ran(50)-25)) +(alpha_y+vary*(ran(30)-15)) /(alpha_r) Ap(l*r_p, w*r_w) ]
  [ /(vary*(ran(50)-25)) -(alpha_y+vary*(ran(30)-15)) \\(alpha_r) Ap(l*r_p, w*r_w) ]

/* p9: a pedicel asks room for its berry */
Ap(l,w) --> ?E(1,0,0,l,w,RND(r_min,r_max))

/* p10 … p12: what the environment answered */
?E(type,theta,phi,l,w,b) : type=0 && l>0    --> +(theta) &(phi) !(w*r_w) F(l)
?E(type,theta,phi,l,w,b) : type=0 && l=0    --> %
?E(type,theta,phi,l,w,b) : type=1 && l=l_w  --> +(theta) &(phi) !(w*r_w) F(l) %
?E(type,theta,phi,l,w,b) : type=1 && l!=l_w --> +(theta) &(phi) !(w*r_w) F(l) S(b)
`;

/** wasm-core/grammars/bunch/grape-bunch-4.lsys */
export const GRAPE_BUNCH_4 = `/* L-system 4: the natural bunch. The rachis, axes, end structures and pedicels of L-system 3, counted in lengths in
   place of whole segments: the last internode of an axis is as long as what is left, so that everything follows the
   outline without a step. Nobody asks for room here; berries make theirs when they swell. Lengths are in the paper's unit. */

#turtle huang  /* Table 1 of the paper: + turns right, & pitches up */

#input length   /* of the rachis */
#input spacing  /* of the rachis's nodes, in its upper part */
#input step     /* of the nodes of a first-order axis */
#input stride   /* of those of a second-order axis */
#input twig     /* the internode of an end structure */
#input stalk    /* a pedicel */
#input girth    /* width of the rachis at its top */
#input fine     /* width of a pedicel */
#input arm[]    /* arm[1] … from the top: lengths of the first-order axes; below 0 there is one pedicel in place of one */
#input way[]    /* way[1] …: how far round the rachis they stand, from p3 by way of p6 */
#input aim[]    /* aim[1] …: angles at which they leave the rachis */
#input node[]   /* node[1] …: which is their first, counted over the nodes of all axes */
#input beyond[]   /* beyond[1] …: how far an end structure at a node may go on as an axis of second order */

#define near 0.6    /* spacing at the tip, over that in the upper part */
#define tip 0.4      /* share of the rachis over which nodes draw together */
#define r_w 0.98     /* width of an internode over the one before */
#define r_a 0.62     /* width: rachis to first-order axis */
#define stout 0.15   /* so much wider is an axis that bears axes */
#define r_t 0.7      /* width: axis to twig */
#define lateral 0.6  /* an axis of second order and a stride, over what is left of the one that bears it */
#define turn 137.5  /* from one axis to the next, round the rachis */
#define alpha_y 60   /* yaw of twigs and pedicels */
#define vary 0.3     /* how much modules differ: at 1 by 15° of yaw, 25° of roll and a fifth of their length */

#role rachis Ar
#role axis Af Ag Ab
#role end Ae
#role pedicel Ap

axiom: Ar(1, length, spacing, girth)

/* the rachis: a node bears one axis, the next another \`turn\` round; d is how far that is. The last node is as far as is left,
   and its axis as strong. */
Ar(k,left,d,w) : left>0 --> ?E(0,0,0,min(left,d),w,0)
  [ Ar(k+1, left-d, spacing*min(1,near+(1-near)*(left-d)/(tip*length)), w*r_w) ]
  [ /(way[k]+vary*(ran(50)-25)) +(aim[k]+vary*(ran(20)-10)) Af(node[k], arm[k], w*r_a*(1+stout*min(1,max(beyond[node[k]],beyond[node[k]+1])/stride)), min(1,left/d)) ]

/* a first-order axis: an end structure at every node, weak at a node that is not far from the one before; in a raceme a
   single pedicel. i is its node: the lower end structures of a long one go on as axes of second order. */
Af(i,left,w,s) : left>0  --> ?E(0,0,0,min(left,step),w,0)
  [ /(90+vary*(ran(50)-25)) Ag(i+1, left-step, w*r_w, s) ]
  [ /(vary*(ran(50)-25)) +(alpha_y+vary*(ran(30)-15)) Ae(min(beyond[i],lateral*(left-step)-stride), w*r_t, s) ]
Ag(i,left,w,s) : left>0  --> ?E(0,0,0,min(left,step),w,0)
  [ /(90+vary*(ran(50)-25)) Ag(i+1, left-step, w*r_w, s) ]
  [ /(vary*(ran(50)-25)) +(alpha_y+vary*(ran(30)-15)) Ae(min(beyond[i],lateral*(left-step)-stride), w*r_t, s*min(1,left/step)) ]
Af(i,left,w,s) : left<=0 --> Ap(fine, s)

/* three pedicels at the end of a twig, as p8; where it goes on, the one in the middle stands aside */
Ae(on,w,s) --> ?E(0,0,0,twig*(1+vary*(ran(0.4)-0.2)),w,0)
  [ /(90) +(alpha_y*clamp(on/stride,0,1)) Ap(fine, s) ]
  [ /(vary*(ran(50)-25)) +(alpha_y+vary*(ran(30)-15)) Ap(fine, s) ]
  [ /(vary*(ran(50)-25)) -(alpha_y+vary*(ran(30)-15)) Ap(fine, s) ]
  [ Ab(on, w*r_w, s) ]

/* an axis of second order: it bears end structures only */
Ab(left,w,s) : left>0  --> ?E(0,0,0,min(left,stride),w,0)
  [ /(90+vary*(ran(50)-25)) Ab(left-stride, w*r_w, s) ]
  [ /(270+vary*(ran(50)-25)) +(alpha_y+vary*(ran(30)-15)) Ae(0, w*r_t, s*min(1,left/stride)) ]

/* a pedicel and its flower, as strong as what bears it; the berry's size is settled later */
Ap(w,s) --> ?E(1,0,0,stalk*(1+vary*(ran(0.4)-0.2)),w,s)

/* what was answered */
?E(type,theta,phi,l,w,b) : type=0 && l>0 --> +(theta) &(phi) !(w*r_w) F(l)
?E(type,theta,phi,l,w,b) : type=0 && l=0 --> %
?E(type,theta,phi,l,w,b) : type=1        --> +(theta) &(phi) !(w) F(l) S(b)
`;
