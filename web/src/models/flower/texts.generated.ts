// Made from wasm-core/grammars/flower by wasm-core/tools/generate.mjs; edit the texts, not this.

/** The texts of presets by their names: loaded when the first is grown. */
export const TEXTS: Readonly<Record<string, string>> = {
	bluebell: `/* Bluebell
   about: A one-sided raceme that nods; bells of six tepals that roll back, open below and in bud above; narrow leaves.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=175 /* 90 … 280 mm, of the stalk */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define tall=length*math.random(0.86,1.14)
#define bells=floor(math.random(7,11))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define STEM(12,0,0,0,20,3.4,3.4,1)
#define OLD(12,0,0,0,20,3.4,3.4,1)
#define NODE(12,0,0,0,5,2.8,2.8,1)
#define DONE(12,0,0,0,5,2.8,2.8,1)
#define finalStep=14+bells

#material 1 stem "6c8a4c" "6c7a78"
#material 2 leaf "3f7038" "4f8044" name "leaf, upper epidermis"
#material 12 leaf "5b8a50" "6a985c" name "leaf, mesophyll"
#material 13 leaf "587f52" "6a9060" name "leaf, lower epidermis"
#material 4 petal "6670c0" "8890ec" bud "5f6a9a" "5a64b4" wilted "8a86a8" "a8a0b4" name "tepal, upper epidermis"
#material 8 petal "363f8c" "4d57b2" bud "4c5688" "4a54a0" wilted "716d92" "8c86a0" name "tepal, mesophyll"
#material 5 petal "4a50a6" "6a74d8" bud "5a6492" "545ea8" wilted "827e9c" "9a92a6" name "tepal, lower epidermis"
#material 6 stamen "e6e2d0" "efe9cf"
#material 7 petal "4d5590" "5c64b8"

#axiom: STEM(,,,55,,,,)
STEM{}{step<4}{} -> OLD[STEM]_{E}[&PETAL{K=12; J=1; len=math.random(250,300); wide=math.random(8,12); thick=0.9; start=-66+math.random(-9,9); sway=math.random(-8,8); low=6; mid=16; high=math.random(30,80); cup=14; peak=0.8; foot=0.4; tip=1.2; claw=0.8; upper=2; middle=12; lower=13}]_{C(1+(5*step)%12)}
STEM{}{step>3&&step<12}{} -> OLD[STEM(,<bend+0.9+math.random(-1,1)>,<math.random(-1,1)>,0,<tall/9>,3.2,3.2,)]_{E}
STEM{}{step==12}{} -> OLD[NODE]_{E}
/* Each node bows a little more; pedicels stand to this side and that, and all hang to the front. */
NODE{k=step-13; q=k/bells}{step<finalStep-1}{} -> DONE[NODE(,<6+4*q>,<math.random(-4,4)>,,<15-7*q>,<2.8-1.4*q>,<2.8-1.4*q>,)]_{E}[&BELL{open=min(1,max(0,open*1.5-0.75*q)); wilt=wilt; size=math.random(0.94,1.06)*(1-0.1*q); droop=18-q*8}]_{C(3-(step%2)*4+12*(step%2))}

#module BELL
#define open=1
#define wilt=0
#define size=1
#define droop=16
#define STALK(12,0,0,0,size*2.4,1.1,1.1,1)
#define WHORL(12,0,0,0,1.2,3.4,3.4,7)
#define INNER(12,0,0,0,1,3.2,3.2,7)
#define finalStep=9
#axiom: STALK(,<-16+math.random(-10,10)>,<math.random(-10,10)>,,,,,)
STALK{}{step<5}{} -> STALK[STALK(,<droop+math.random(-2,2)>,,,,,,)]_{E}
STALK{}{step==5}{} -> STALK[WHORL]_{E}
WHORL -> WHORL[INNER]_{E}
WHORL -> WHORL[&PETAL{K=8; J=1; len=size*(12.7+5.4*open); wide=size*(2.8+1*open); thick=0.45; start=-52-6*(1-open); low=-44+10*(1-open); mid=-46*open-10*(1-open); high=-20+(215+math.random(0,45))*open+40*wilt; cup=34-12*open; foot=0.5; tip=1; claw=0.9; upper=4; middle=8; lower=5}]_{C1,C5,C9}
INNER -> INNER[&PETAL{K=8; J=1; len=size*(12.7+5.4*open); wide=size*(2.8+1*open); thick=0.45; start=-56-6*(1-open); low=-40+8*(1-open); mid=-46*open-10*(1-open); high=-20+(205+math.random(0,45))*open+40*wilt; cup=34-12*open; foot=0.5; tip=1; claw=0.9; upper=4; middle=8; lower=5}]_{C3,C7,C11}
INNER -> INNER[&STAMEN{long=size*(5+2*open); lean=-84; head=2.6*size}]_{C1,C5,C9}

#module PETAL
/* A vein of K segments; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 1 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,,,)]_{E}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2

#module STAMEN
#define long=5
#define lean=-50
#define head=1.6
#define FILAMENT(4,0,0,0,long/4,0.3,0.3,6)
#define ANTHER(4,0,0,0,head/2,0.75*head/1.6,0.5*head/1.6,7)
#define finalStep=6
#axiom: FILAMENT(,lean,,,,,,)
FILAMENT{}{step<3}{} -> FILAMENT[FILAMENT(,<-lean*0.12-8>,,,,,,)]_{E}
FILAMENT{}{step==3}{} -> FILAMENT[ANTHER]_{E}
ANTHER{}{step<5}{} -> ANTHER[ANTHER]_{E}
`,
	buttercup: `/* Buttercup
   about: Five petals that shine, five sepals, many stamens round a head of carpels; three flowers of a cyme over leaves of five lobes.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=150 /* 80 … 250 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1 /* 0.7 … 1.4, of the flower */
#define tall=length*math.random(0.83,1.17)
#define size=scale*math.random(0.92,1.1)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define STEM(10,0,0,0,20,2.4,2.4,1)
#define LOWER(10,0,0,0,3,2.6,2.6,1)
#define UPPER(10,0,0,0,3,2.4,2.4,1)
#define finalStep=18

#material 1 stem "6f9150" "86a862"
#material 2 leaf "47793a" "5f9449" veins "7cae60" 4 0.4 feathered name "leaf, upper epidermis"
#material 12 leaf "558544" "6b9e53" name "leaf, mesophyll"
#material 13 leaf "668c58" "7ca068" name "leaf, lower epidermis"
#material 3 sepal "c2c45a" "d2d066" name "sepal, upper epidermis"
#material 14 sepal "b9bd58" "c8c862" name "sepal, mesophyll"
#material 15 sepal "a3ae4e" "bcc05c" name "sepal, lower epidermis"
#material 4 petal "ecc80a" "fce80c" veins "d9a808" 7 0.2 bud "b8b83a" "c9c040" wilted "e4c424" "ecd850" name "petal, upper epidermis"
#material 9 petal "e8c40c" "f4dc10" bud "b8b83a" "c9c040" wilted "dcc030" "e6d048" name "petal, mesophyll"
#material 5 petal "dcc83a" "f2e250" bud "b8b83a" "c9c040" wilted "d8c448" "e6d868" name "petal, lower epidermis"
#material 6 stamen "d9c238" "e3cd44"
#material 7 stamen "dba51c" "ebb92a"
#material 8 pistil "9ab04a" "b9c95a"

#axiom: STEM
STEM{}{step<13&&step!=6&&step!=9}{} -> STEM[STEM(,<bend+math.random(-2,2)>,<math.random(-2,2)>,,<tall/13>,<2.4-0.06*step>,<2.4-0.06*step>,)]_{E}
STEM{}{step==6}{} -> STEM[LOWER]_{E}
STEM{}{step==9}{} -> STEM[UPPER]_{E}
LOWER -> LOWER[STEM(,<math.random(-5,5)>,<math.random(-5,5)>,,<tall/13>,2,2,)]_{E}
UPPER -> UPPER[STEM(,<math.random(-5,5)>,<math.random(-5,5)>,,<tall/13>,1.8,1.8,)]_{E}
STEM{}{step==0}{} -> STEM[&PALMATE{stalk=math.random(50,80); len=math.random(26,34); start=-38+math.random(-10,10); sway=math.random(-12,12)}]_{C1,C4,C8}
LOWER -> LOWER[&PALMATE{stalk=10; len=math.random(22,30); start=-36}]_{C2}[&TWIG{long=tall*0.36; open=max(0,open-0.25)}]_{C3}
UPPER -> UPPER[&PALMATE{stalk=5; len=math.random(14,20); start=-40}]_{C7}[&TWIG{long=tall*0.2; open=max(0,open-0.7)}]_{C8}
STEM{}{step==13}{} -> STEM[&FLOWER{open=open; wilt=wilt; size=size}]_{E}

#module TWIG
#define long=80
#define open=1
#define SHOOT(10,0,0,0,long/7,1.9,1.9,1)
#define finalStep=9
#axiom: SHOOT(,<-40+math.random(-8,8)>,,,,,,)
SHOOT{}{step<6}{} -> SHOOT[SHOOT(,<-6+math.random(-3,3)>,<math.random(-3,3)>,,,<1.9-0.06*step>,<1.9-0.06*step>,)]_{E}
SHOOT{}{step==6}{} -> SHOOT[&FLOWER{open=open; size=math.random(0.86,1)}]_{E}

#module FLOWER
#define open=1
#define wilt=0
#define size=1
#define CALYX(10,0,0,0,0.9,2.8,2.8,1)
#define DISC(10,0,0,0,0.7,3,3,4)
#define RING(10,0,0,18,0.5,2.8,2.8,8)
#define HEART(10,0,0,8,0.5,2.6,2.6,8)
#define finalStep=14
#axiom: CALYX(,<20*open>,,,,,,)
CALYX -> CALYX[DISC]_{E}
CALYX -> CALYX[&PETAL{K=6; J=1; len=size*7.2; wide=size*(4.6-1.2*open); thick=0.4; start=-46+36*open+20*wilt; low=-50+30*open; high=-50*(1-open); cup=24-14*open; peak=0.85; tip=1.4; claw=0.7; upper=3; middle=14; lower=15}]_{C1,C3,C5,C7,C9}
DISC -> DISC[RING]_{E}
DISC -> DISC[&PETAL{K=9; J=3; kept=1-0.97*clamp((wilt-math.random(0.4,0.75))/0.28,0,1); len=size*(5+5.6*open)*math.random(0.95,1.03); wide=size*(3.8+4.8*open); thick=0.42; start=-50+34*open+math.random(-5,5)+20*wilt; low=-48+30*open; mid=-8; high=-44+34*open; cup=18-8*open; edge=3; wave=2+3*wilt; peak=1.3; foot=0.85; tip=0.5; claw=0.3; upper=4; middle=9; lower=5}]_{C2,C4,C6,C8,C10}
RING{}{step<6}{} -> RING[RING]_{E}
RING{}{step==6}{} -> RING[HEART]_{E}
RING -> RING[&STAMEN{long=(1+2.4*open)*math.random(0.85,1.15); lean=-70+34*open+step*-4+math.random(-8,8); head=0.6+0.9*open}]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10}
HEART{}{step<13}{} -> HEART[HEART(,,,,<0.44*(1+wilt*0.9)>,<2.7*cos(11*(step-6))>,<2.7*cos(11*(step-6))>,)]_{E}
HEART{}{step<12}{} -> HEART[&BLADE{S=2; len=0.9; wide=0.75; thick=0.5; start=-50-5*(step-6); claw=0.9; blunt=0.4; paint=8}]_{C1,C3,C5,C7,C9}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 3 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define kept=1      /* how much of it is left: it withers, hangs and falls */
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,kept*len*sin(90/K)^2,kept*thick,kept*thick,middle)
#define RU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#axiom: VEIN(,start+50*(1-kept),sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<kept*len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<kept*thick*max(0.25,1-u^3)>,<kept*thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RU2[RU3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RM2[RM3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RL2[RL3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LU2[LU3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LM2[LM3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LL2[LL3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}

#module STAMEN
#define long=5
#define lean=-50
#define head=1.6
#define FILAMENT(4,0,0,0,long/4,0.3,0.3,6)
#define ANTHER(4,0,0,0,head/2,0.75*head/1.6,0.5*head/1.6,7)
#define finalStep=6
#axiom: FILAMENT(,lean,,,,,,)
FILAMENT{}{step<3}{} -> FILAMENT[FILAMENT(,<-lean*0.12-8>,,,,,,)]_{E}
FILAMENT{}{step==3}{} -> FILAMENT[ANTHER]_{E}
ANTHER{}{step<5}{} -> ANTHER[ANTHER]_{E}

#module PALMATE
/* A leaf of five lobes that spread from the end of its stalk. */
#define stalk=60
#define len=30
#define start=0
#define sway=0
#define teeth=0.4
#define PETIOLE(8,0,0,0,stalk/8,1.3,1.3,1)
#define NODE(8,0,0,0,0.6,1.3,1.3,1)
#define LAST(8,0,0,0,0.6,1.3,1.3,1)
#define finalStep=12
#axiom: PETIOLE(,start,sway,,,,,)
PETIOLE{}{step<7}{} -> PETIOLE[PETIOLE(,<4+math.random(-3,3)>,<math.random(-4,4)>,,,,,)]_{E}
PETIOLE{}{step==7}{} -> PETIOLE[NODE(,<16>,,,,,,)]_{E}
NODE -> NODE[LAST]_{E}
NODE -> NODE[&PETAL{K=12; J=2; len=len*0.72; wide=len*0.58; thick=0.5; start=6; roll=-90; low=-12; cup=5; peak=1.7; foot=1.3; tip=0.8; claw=0.1; teeth=teeth; bites=4; barb=-26; upper=2; middle=12; lower=13}]_{C3}[&PETAL{K=12; J=2; len=len*0.72; wide=len*0.58; thick=0.5; start=6; roll=90; low=-12; cup=5; peak=1.7; foot=1.3; tip=0.8; claw=0.1; teeth=teeth; bites=4; barb=-26; upper=2; middle=12; lower=13}]_{C7}
LAST -> LAST[&PETAL{K=12; J=2; len=len*0.93; wide=len*0.62; thick=0.5; start=-42; roll=-90; low=-12; cup=5; peak=1.7; foot=1.3; tip=0.8; claw=0.1; teeth=teeth; bites=4; barb=-26; upper=2; middle=12; lower=13}]_{C3}[&PETAL{K=12; J=2; len=len*0.93; wide=len*0.62; thick=0.5; start=-42; roll=90; low=-12; cup=5; peak=1.7; foot=1.3; tip=0.8; claw=0.1; teeth=teeth; bites=4; barb=-26; upper=2; middle=12; lower=13}]_{C7}[&PETAL{K=12; J=2; len=len; wide=len*0.64; thick=0.5; low=12; cup=5; peak=1.7; foot=1.3; tip=0.8; claw=0.1; teeth=teeth; bites=4; barb=-26; upper=2; middle=12; lower=13}]_{E}
`,
	capitulum: `/* Capitulum
   about: Many florets on one receptacle, as if they were a flower: cornflower, trumpets round its violet middle, bracts like tiles below.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=145 /* 70 … 240 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1 /* 0.7 … 1.4, of the flower */
#define tall=length*math.random(0.83,1.17)
#define size=scale*math.random(0.93,1.07)
#define outer=floor(math.random(15,19))
#define inner=floor(math.random(18,24))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define STEM(13,0,0,0,20,2.2,2.2,1)
#define OLD(13,0,0,0,20,2.2,2.2,1)
#define CUP(13,0,0,-0.954,1.5,7,7,3)
#define TILED(13,0,0,0,1.5,7,7,3)
#define RIM(13,0,0,-0.954,0.16,6.4,6.4,3)
#define DISC(13,0,0,-0.954,0.05,6,6,3)
#define BARE(13,0,0,0,0,6,6,3)
#define finalStep=42+outer+inner

#material 1 stem "7f9a78" "93ab86"
#material 2 leaf "66886a" "7fa07c"
#material 3 sepal "7d9a68" "7d9a68" name "involucre"
#material 8 sepal "8fa874" "6f8250" margin "3c3024" 0.3 name "bract"
#material 4 petal "6a86e0" "2f4fd0" bud "4a5fc0" "3a4fc0" wilted "a9aec4" "c4c6d0"
#material 5 petal "4a5fc8" "3a55d6" bud "4a58a8" "3a4cb0" wilted "9a9eb4" "b4b6c2"
#material 6 stamen "4a3a9a" "3a2468"
#material 7 stamen "7a5ac0" "4a2a7a"

#axiom: STEM
STEM{}{step<14}{} -> OLD[STEM(,<bend+math.random(-2,2)+2*wilt>,<math.random(-2,2)>,,<tall/14>,<2.4-0.06*step>,<2.4-0.06*step>,)]_{E}
STEM{}{step>0&&step<13}{} -> STEM[&BLADE{S=6; len=(60-3*step)*math.random(0.85,1.1); wide=5-0.2*step; thick=0.6; start=-50+math.random(-10,10); bend=math.random(10,50); high=10; peak=0.8; round=0.7; claw=0.7; paint=2}]_{C(1+(5*step)%13)}
STEM{}{step==14}{} -> STEM[CUP(,<-28*open>,,,0.4,4,4,)]_{E}
/* The involucre bulges, two bracts to a ring, each by the golden angle. */
CUP{k=step-15}{step<41}{} -> TILED[CUP(,,,,<size*0.5>,<size*(4+5.2*sin(7*k)^0.8)>,<size*(4+5.2*sin(7*k)^0.8)>,)]_{E}[&BLADE{S=4; len=size*(5.4+0.1*k); wide=size*4.2; thick=0.6; start=-66-0.3*k; bend=-6; peak=0.7; round=0.8; claw=1; paint=8}]_{C(1+(5*step)%13),C(1+(5*step+6)%13)}
CUP{}{step==41}{} -> TILED[RIM]_{E}
RIM{k=step-42}{k<outer}{} -> BARE[RIM]_{E}[&TRUMPET{start=-84+(70-6*(k%3))*open+math.random(-6,6)+20*wilt; sway=math.random(-6,6); long=size*(9+13*open)*math.random(0.94,1.05); open=open; wilt=wilt}]_{C(1+(5*step)%13)}
RIM{k=step-42}{k==outer}{} -> BARE[DISC]_{E}
DISC{q=(step-43-outer)/inner}{step<finalStep-1}{} -> BARE[DISC(,,,,0.08,<6*sqrt(max(0.02,1-q))>,<6*sqrt(max(0.02,1-q))>,)]_{E}[&TUBE{start=-66-20*q+math.random(-8,8); long=size*(5+6*open)*math.random(0.85,1.1); open=open}]_{C(1+(5*step)%13)}

#module TRUMPET
/* A floret that widens to seven lobes, hollow since its last prisms grow backwards. */
#define start=0
#define sway=0
#define long=20
#define open=1
#define wilt=0
#define T(7,0,0,0,long*0.2,0.9,0.9,5)
#define MOUTH(7,0,0,0,1,1,1,4)
#define IN(7,0,0,0,-1,1,1,5)
#define finalStep=8
#axiom: T(,start,sway,,,,,)
T{}{step<3}{} -> T[T(,<-3+6*wilt>,,,<long*0.18>,<0.9+0.4*step+open*0.7*step>,<0.9+0.4*step+open*0.7*step>,)]_{E}
T{}{step==3}{} -> T[MOUTH(,,,,<long*0.12>,<1.8+5.2*open>,<1.8+5.2*open>,)]_{E}
MOUTH -> MOUTH[IN(,,,,<-long*0.1>,<1.2+2.6*open>,<1.2+2.6*open>,)]_{E}
IN{}{step==5}{} -> IN[IN(,,,,<-long*0.12>,0.8,0.8,)]_{E}
MOUTH -> MOUTH[&BLADE{S=3; len=long*0.36; wide=1.2+1.4*open; thick=0.35; start=-80+44*open; bend=24*open; high=14; peak=0.8; claw=0.9; blunt=0.2; paint=4}]_{C1,C2,C3,C4,C5,C6,C7}

#module TUBE
#define start=-80
#define long=9
#define open=1
#define T(5,0,0,0,long*0.4,0.8,0.8,6)
#define finalStep=3
#axiom: T(,start,,,,,,)
T{}{step<2}{} -> T[T(,<math.random(-8,8)>,,,<long*0.3>,<1.5-0.8*step*open>,<1.5-0.8*step*open>,<6+step>)]_{E}

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}
`,
	crocus: `/* Crocus
   about: Six tepals on a long tube, three stamens, a style of three frilled branches; leaves with a white rib.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=62 /* 30 … 100 mm, of the tube */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1 /* 0.7 … 1.4, of the flower */
#define tall=length*math.random(0.75,1.19)
#define size=scale*math.random(0.9,1.12)
#define leaves=floor(math.random(3,5))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define SHEATH(12,0,0,0,6,6,6,10)
#define GROWN(12,0,0,0,6,6,6,10)
#define TUBE(12,0,0,0,10,3.6,3.6,11)
#define WHORL(12,0,0,0,1.6,5.4,5.4,4)
#define INNER(12,0,0,0,1.4,5,5,4)
#define TOP(12,0,0,0,1,4,4,11)
#define finalStep=17

#material 2 leaf "3d6b3c" "578546" name "leaf, upper epidermis"
#material 3 leaf "c9d6c0" "b9cbae" name "leaf, mesophyll"
#material 13 leaf "5c8458" "729a62" name "leaf, lower epidermis"
#material 4 petal "ece4f2" "8a5fc4" foot 0.4 veins "5a34a0" 7 0.5 bud "dcd3e6" "7b58b4" wilted "c4b0b8" "8a6a86" name "tepal, upper epidermis"
#material 9 petal "d9cce8" "6f48ae" foot 0.4 bud "d0c2e0" "6442a0" wilted "baa4b0" "7c5e7a" name "tepal, mesophyll"
#material 12 petal "5d3a9a" "b49ada" foot 0.9 margin "cdbce6" 0.22 veins "47228a" 3 0.7 bud "593a90" "9c84c6" wilted "80667e" "a08aa0" name "outer tepal, lower epidermis"
#material 5 petal "e4daee" "774cb2" foot 0.4 veins "4e2a92" 7 0.55 bud "d8cce4" "6a469f" wilted "bca8ae" "7d5f76" name "inner tepal, lower epidermis"
#material 6 stamen "e8dfb8" "e8d79a"
#material 7 stamen "e9b62a" "f2c840"
#material 8 pistil "e2952a" "ec7a1a"
#material 10 sepal "e4e6d6" "cdd6b8"
#material 11 petal "eeeaf2" "cbb5e2"

#axiom: SHEATH
SHEATH{}{step<4}{} -> GROWN[SHEATH(,,,,6,<6-0.4*step>,<6-0.4*step>,)]_{E}
SHEATH{}{step<leaves}{} -> SHEATH[&PETAL{K=12; J=1; len=math.random(80,130); wide=math.random(4.4,6.5); thick=1; start=-66+math.random(-8,8)-10*(1-open); sway=math.random(-6,6); low=8; mid=14; high=20+math.random(0,40); cup=-14; peak=0.8; foot=0.4; tip=0.8; claw=0.9; upper=2; middle=3; lower=13}]_{C(2+5*step%12)}
SHEATH{}{step==4}{} -> SHEATH[TUBE]_{E}
TUBE{}{step<10}{} -> TUBE[TUBE(,<bend+math.random(-2,2)+7*wilt>,<math.random(-2,2)>,,<tall*(0.7+0.3*open)/6>,<3.6+0.16*(step-4)>,<3.6+0.16*(step-4)>,)]_{E}
TUBE{}{step==10}{} -> TUBE[WHORL(,<9*open>,,,,,,)]_{E}
WHORL -> WHORL[INNER]_{E}
WHORL -> WHORL[&PETAL{K=11; J=3; kept=1-math.random(0.3,0.5)*wilt; len=size*(28+15*open); wide=size*(13+3.8*open); thick=0.7; start=-72+34*open+math.random(-3,3)-6*wilt; low=-12-14*open; mid=-4+wilt*14; high=-16+22*open+40*wilt+math.random(-5,5); cup=20-8*open; wave=22*wilt; peak=1.12; foot=1; tip=1; claw=0.3; upper=4; middle=9; lower=12}]_{C1,C5,C9}
INNER -> INNER[TOP]_{E}
INNER -> INNER[&PETAL{K=11; J=3; kept=1-math.random(0.3,0.5)*wilt; len=size*(26+13*open); wide=size*(13+4*open); thick=0.7; start=-76+30*open+math.random(-3,3)-10*wilt; low=-10-14*open; mid=-4+wilt*10; high=-16+18*open+30*wilt+math.random(-5,5); cup=21-8*open; wave=22*wilt; peak=1.12; foot=1; tip=1; claw=0.3; upper=4; middle=9; lower=5}]_{C3,C7,C11}
TOP -> TOP[&STAMEN{long=3+5*open; lean=-90+9*open; head=3+6*open}]_{C1,C5,C9}
TOP -> TOP[&STYLE{long=size*(15+5*open)}]_{E}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 3 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define kept=1      /* how much of it is left: it withers, hangs and falls */
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,kept*len*sin(90/K)^2,kept*thick,kept*thick,middle)
#define RU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#axiom: VEIN(,start+50*(1-kept),sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<kept*len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<kept*thick*max(0.25,1-u^3)>,<kept*thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RU2[RU3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RM2[RM3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RL2[RL3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LU2[LU3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LM2[LM3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LL2[LL3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

#module STAMEN
#define long=5
#define lean=-50
#define head=1.6
#define FILAMENT(4,0,0,0,long/4,0.9,0.9,6)
#define ANTHER(4,0,0,0,head/2,2.2,1.5,7)
#define finalStep=6
#axiom: FILAMENT(,lean,,,,,,)
FILAMENT{}{step<2}{} -> FILAMENT[FILAMENT(,<-2>,,,,,,)]_{E}
FILAMENT{}{step==2}{} -> FILAMENT[ANTHER]_{E}
ANTHER{}{step<5}{} -> ANTHER[ANTHER]_{E}

#module STYLE
#define long=20
#define COLUMN(6,0,0,0,long/6,1,1,8)
#define SHAFT(6,0,0,0,long/6,1,1,8)
#define BRANCH(4,0,0,0,1.8,1.1,0.9,8)
#define finalStep=10
#axiom: COLUMN
COLUMN{}{step<5}{} -> SHAFT[COLUMN]_{E}
COLUMN{}{step==5}{} -> COLUMN[BRANCH(,<-72+26*open>,,,,,,)]_{C1,C3,C5}
BRANCH{}{step<9}{} -> BRANCH[BRANCH(,<4*open>,,,<0.9+0.8*open>,<1.1+(0.1+0.5*open)*(step-5)>,<0.9+0.1*(step-5)>,)]_{E}
`,
	cyme: `/* Cyme
   about: Each axis ends in a flower and two branches do the same below it: red campion, a module that calls itself.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=130 /* 70 … 210 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1.18 /* 0.7 … 1.6, of the flower */
#define tall=length*math.random(0.85,1.15)
#define size=scale*math.random(0.94,1.06)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define STEM(10,0,0,0,20,3,3,1)
#define PAIR(10,0,0,0,3,3.4,3.4,1)
#define finalStep=9

#material 1 stem "77804e" "8a6a58"
#material 2 leaf "4d7c42" "679a56" veins "86b072" 3 0.4
#material 3 sepal "7a4a48" "8a3f50"
#material 4 petal "f3d3dc" "d9477f" foot 0.45 veins "b82f66" 5 0.3 bud "b0506a" "b8446a" wilted "cfa2ac" "a86a7c"
#material 5 petal "eec4d0" "cc5a86" bud "a84c64" "b04864" wilted "c49aa2" "a06a78"
#material 6 stamen "f0dfe0" "f2e6e2"
#material 7 stamen "e6d3c0" "efe0d0"

#axiom: STEM
STEM{}{step<6&&step!=3}{} -> STEM[STEM(,<bend+math.random(-3,3)>,<math.random(-3,3)>,,<tall*0.16>,,,)]_{E}
STEM{}{step==3}{} -> STEM[PAIR]_{E}
PAIR -> PAIR[STEM(,,,,<tall*0.14>,2.8,2.8,)]_{E}
PAIR -> PAIR[&PETAL{K=12; J=2; len=math.random(48,60); wide=math.random(20,26); thick=0.7; start=-40+math.random(-10,10); low=14; mid=12; high=math.random(10,40); cup=7; peak=0.85; foot=0.9; tip=1.5; claw=0.14; upper=2; middle=2; lower=2}]_{C3,C8}
STEM{}{step==0}{} -> STEM[&PETAL{K=12; J=2; len=math.random(54,66); wide=math.random(22,28); thick=0.7; start=-30+math.random(-8,8); low=14; mid=14; high=math.random(0,30); cup=7; peak=1; foot=1.1; tip=1.2; claw=0.16; upper=2; middle=2; lower=2}]_{C1,C6}
STEM{}{step==6}{} -> STEM[&CYME{again=2; open=open; long=tall*0.2; size=size; wilt=wilt}]_{E}

#module CYME
#define again=0    /* how often it branches */
#define open=1
#define wilt=0
#define long=30
#define size=1
#define start=0
#define AXIS(10,0,0,0,long/3,2.2,2.2,1)
#define FORK(10,0,0,0,2,2.6,2.6,1)
#define FOOT(10,0,0,0,long/6,1.8,1.8,1)
#define finalStep=7
#axiom: AXIS(,start,,,,,,)
AXIS{}{step<2}{} -> AXIS[AXIS(,<-start*0.22+math.random(-4,4)>,<math.random(-4,4)>,,,,,)]_{E}
AXIS{}{step==2}{} -> AXIS[FORK]_{E}
FORK{}{again>0}{} -> FORK[&CYME{again=again-1; open=max(0,open-0.24); wilt=wilt*0.6; long=long*0.95; size=size*0.94; start=-50+math.random(-6,6)}]_{C3,C8}
FORK{}{again>0}{} -> FORK[&PETAL{K=7; J=1; len=9+8*again; wide=3+3*again; thick=0.6; start=-30; low=10; high=20; cup=8; peak=0.7; tip=1.6; claw=0.6; upper=2; middle=2; lower=2}]_{C2,C7}
FORK -> FORK[FOOT(,<math.random(-6,6)>,<math.random(-6,6)>,,,,,)]_{E}
FOOT{}{step==4}{} -> FOOT[&FLOWER{open=open; wilt=wilt; size=size}]_{E}

#module FLOWER
#define open=1
#define wilt=0
#define size=1
#define CALYX(10,0,0,0,size*1.4,3,3,3)
#define MOUTH(10,0,0,0,1,4,4,3)
#define THROAT(10,0,0,0,0.6,3.4,3.4,4)
#define finalStep=10
#axiom: CALYX
CALYX{}{step<6}{} -> CALYX[CALYX(,,,,<size*(1.2+0.6*open)>,<3+2.3*sin(30*step)>,<3+2.3*sin(30*step)>,)]_{E}
CALYX{}{step==6}{} -> CALYX[MOUTH(,,,,<1>,<2.8+1.2*open>,<2.8+1.2*open>,)]_{E}
MOUTH -> MOUTH[THROAT]_{E}
MOUTH -> MOUTH[&BLADE{S=2; len=2.6*size; wide=1.9*size; thick=0.4; start=-80+14*open; claw=1; blunt=0.2; paint=3}]_{C1,C3,C5,C7,C9}
THROAT -> THROAT[&PETAL{K=8; J=2; len=size*(3+8.6*open)*(1-0.2*wilt); wide=size*(2+7.4*open); thick=0.4; start=-82+80*open-30*wilt; low=-8*(1-open); mid=4; high=-30+34*open-60*wilt; cup=14-10*open; wave=3+8*wilt; peak=1.6; foot=0.9; tip=0.5; claw=0.3; spread=62; upper=4; lower=5}]_{C2,C4,C6,C8,C10}
THROAT -> THROAT[&BLADE{S=2; len=2.2*open+0.2; wide=0.9; thick=0.5; start=-70; claw=0.9; paint=6}]_{C1,C3,C5,C7,C9}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 2 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<thick*max(0.25,1-u^3)>,<thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}
`,
	daisy: `/* Daisy
   about: A head of white rays round a dome of yellow florets in spirals by the golden angle, over a rosette of spoon-shaped leaves.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=60 /* 30 … 110 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1 /* 0.7 … 1.4, of the flower */
#define tall=length*math.random(0.73,1.30)
#define size=scale*math.random(0.9,1.12)
#define rays=floor(math.random(35,51))
#define discs=floor(math.random(80,104))
#define radius=4*size*(0.55+0.45*sin(90*min(age,1)))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

/* A prism of 13 sides: five on is 138.46 degrees, and each is turned back by 0.954. */
#define ROSETTE(13,0,0,-0.954,0.3,4,4,2)
#define GROWN(13,0,0,0,0.3,4,4,2)
#define STEM(13,0,0,0,10,1.3,1.3,1)
#define CUP(13,0,0,0,1.4,5.6*size*(0.7+0.3*open),5.6*size*(0.7+0.3*open),3)
#define RIM(13,0,0,-0.954,0.05,8.2*size*(0.6+0.4*open),8.2*size*(0.6+0.4*open),3)
#define FULL(13,0,0,0,0,8,8,3)
#define DISC(13,0,0,-0.954,0.05,2*radius,2*radius,6)
#define BARE(13,0,0,0,0,8,8,6)
#define leaves=floor(math.random(6,10))
#define finalStep=leaves+12+rays+discs+2

#material 1 stem "7b9a56" "93ae6a"
#material 2 leaf "4e7a3c" "669249" veins "86ac66" 5 0.3 feathered name "leaf, upper epidermis"
#material 12 leaf "5c8747" "719b53" name "leaf, mesophyll"
#material 13 leaf "6c9058" "809f68" name "leaf, lower epidermis"
#material 3 sepal "557f40" "6f9450" name "bract"
#material 4 petal "e6e9ee" "f4f6fa" light 0.25 bud "f3e3e8" "eec2d0" wilted "e6dccb" "c9b79c" name "ray, upper epidermis"
#material 8 petal "e8e4e8" "f0ecf0" light 0.25 bud "f0dce2" "ebbccb" wilted "e0d2c0" "c2ac94" name "ray, mesophyll"
#material 5 petal "f0ecf0" "e6aec0" foot 1 light 0.25 bud "efd3dc" "e29cb4" wilted "dcc4b4" "b99a86" name "ray, lower epidermis"
#material 6 stamen "dcae14" "f4cc1c"
#material 7 stamen "eec81c" "fce03a"

#axiom: ROSETTE
ROSETTE{}{step<leaves}{} -> GROWN[ROSETTE]_{E}[&PETAL{K=10; J=2; len=math.random(20,32); wide=math.random(8,11); thick=0.8; start=-26+math.random(-9,9)-20*(1-open); sway=math.random(-8,8); low=14; mid=10; high=-8; cup=9; peak=2.1; foot=1.2; tip=0.75; claw=0.26; upper=2; middle=12; lower=13}]_{C(1+(5*step)%13)}
ROSETTE{}{step==leaves}{} -> ROSETTE[STEM]_{E}
STEM{}{step<leaves+9}{} -> STEM[STEM(,<bend+math.random(-2.5,2.5)+wilt*3>,<math.random(-2.5,2.5)>,,<tall*(0.5+0.5*open)/9>,,,)]_{E}
STEM{}{step==leaves+9}{} -> STEM[CUP(,<26*open>,,,,,,)]_{E}
CUP -> CUP[RIM]_{E}
CUP -> CUP[&BLADE{len=5*size; wide=1.9*size; thick=0.4; start=-14-60*(1-open)+30*wilt; bend=-4-30*(1-open); peak=0.9; claw=0.8; paint=3}]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12,C13}
RIM{k=step-leaves-11}{k<rays}{} -> FULL[RIM]_{E}[&PETAL{rib=0; K=5; J=1; len=size*(5.8+3.4*open)*math.random(0.93,1.05); wide=size*(1.4+0.7*open); thick=0.26; start=-76+(62-14*k/rays)*open+math.random(-6,6)*open+34*wilt; sway=math.random(-4,4); low=-14*open; mid=-10*(1-open); high=-76+82*open; cup=16; foot=0.6; tip=0.62; peak=1.3; claw=0.5; upper=4; middle=8; lower=5}]_{C(1+(5*step)%13)}
RIM{k=step-leaves-11}{k>=rays}{} -> FULL[DISC]_{E}
DISC{k=step-leaves-12-rays; r=sqrt(max(0.01,1-k/discs))}{step<finalStep-1}{} -> BARE[DISC(,,,,<(0.012+0.016*k/discs)*size>,<2*radius*r>,<2*radius*r>,)]_{E}[&BLADE{S=3; len=size*(0.5+0.65*open); wide=size*(0.7+0.3*open); thick=size*(0.7+0.3*open); start=-44-44*k/discs; claw=0.8; blunt=0.72; paint=6+(k<discs*0.45)}]_{C(1+(5*step)%13)}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 2 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define rib=1      /* its middle layer shows along the vein; 0: its epidermises meet over it */
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define VU(4,0,0,0,1,1,1,upper)
#define VD(4,0,0,0,1,1,1,lower)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<thick*max(0.25,1-u^3)>,<thick*max(0.25,1-u^3)>,)]_{E}
VEIN{}{step<=K&&rib<1}{} -> VEIN[VU(,,,,<0.05*W>,<0.42*W>,H,)]_{C5}[VD(,,,,<0.05*W>,<0.42*W>,H,)]_{C1}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
VU : VU_C1 < VU_C3 -> VU_C1 | VU_C3
VD : VD_C1 < VD_C3 -> VD_C1 | VD_C3
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}
`,
	"dandelion-clock": `/* Dandelion clock
   about: What becomes of the dandelion: a ball of achenes, each on its beak with a parachute of hairs; age opens it.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=100 /* 50 … 180 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1 /* 0.7 … 1.4, of the flower */
#define tall=length*math.random(0.80,1.25)
#define size=scale*math.random(0.95,1.1)
#define seeds=floor(math.random(104,126))
#define leaves=floor(math.random(5,8))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define ROSETTE(13,0,0,-0.954,0.5,5,5,2)
#define GROWN(13,0,0,0,0.5,5,5,2)
#define STEM(13,0,0,0,20,3.4,3.4,1)
#define CUP(13,0,0,0,1.5,8,8,3)
#define BALL(13,0,0,-0.954,0.11,7,7,6)
#define BARE(13,0,0,0,0,12,12,6)
#define finalStep=leaves+13+seeds

#material 1 stem "a8927c" "a3b37c"
#material 2 leaf "4a7a34" "62913f" veins "b9c98f" 8 0.3 feathered name "leaf, upper epidermis"
#material 12 leaf "7d9f5d" "8aaa61" name "leaf, mesophyll"
#material 13 leaf "688f52" "7ba05c" name "leaf, lower epidermis"
#material 3 sepal "567f45" "6d9452" name "bract"
#material 5 seed "6f5a3c" "b9ab90"
#material 8 seed "b3a68a" "e6e0d0" name "beak"
#material 6 sepal "c9c09a" "d8d0ac" name "receptacle"
#material 7 petal "a8a294" "d2cdc1" name "pappus"

#axiom: ROSETTE
ROSETTE{}{step<leaves}{} -> GROWN[ROSETTE]_{E}[&PETAL{K=20; J=2; len=math.random(66,92); wide=math.random(24,30); thick=0.9; start=-20+math.random(-10,10)-24*(1-open); sway=math.random(-9,9); low=16; mid=12; high=math.random(-6,16); cup=5; peak=1.7; foot=1; tip=0.8; claw=0.12; teeth=0.9; bites=5; barb=24; upper=2; middle=12; lower=13}]_{C(1+(5*step)%13)}
ROSETTE{}{step==leaves}{} -> ROSETTE[STEM]_{E}
STEM{}{step<leaves+10}{} -> STEM[STEM(,<bend+math.random(-2,2)>,<math.random(-2,2)>,,<tall/10>,,,)]_{E}
STEM{}{step==leaves+10}{} -> STEM[CUP]_{E}
CUP -> CUP[BALL]_{E}
CUP -> CUP[&BLADE{len=16.5*size; wide=2.6; thick=0.6; start=66-130*(1-open)+math.random(-9,9); bend=20*open; peak=0.8; claw=0.9; paint=3}]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12,C13}
/* The ball's own outline: what stands on it leans as far as its pole is away. */
BALL{q=(step-leaves-11)/seeds; r=sqrt(max(0.02,1-(2*q-1)^2*0.96))}{step<finalStep-1}{} -> BARE[BALL(,,,,<8.4*size/seeds>,<8.4*size*r>,<8.4*size*r>,)]_{E}[&ACHENE{start=-90*open*(2*q-1)-86*(1-open)+math.random(-4,4); open=open; far=size*(0.55+0.45*open); gone=clamp(4*(wilt*math.random(0.6,1.6)-0.6),0,1)}]_{C(1+(5*step)%13)}

#module ACHENE
#define start=0
#define open=1
#define far=1
#define gone=0
#define NUT(4,0,0,0,1.6,0.9,0.6,5)
#define BEAK(4,0,0,0,5,0.16,0.16,8)
#define HUB(14,0,0,0,0.14,0.36,0.36,7)
#define ROOT(4,0,0,0,0.1,0.04,0.04,7)
#define HAIR(4,0,0,0,3.2,0.12,0.12,7)
#define finalStep=8
#axiom: NUT(,start,,,<1.6*(1-gone)+0.02>,<0.9*(1-gone)+0.02>,<0.6*(1-gone)+0.02>,)
NUT{}{step==0}{} -> NUT[NUT(,,,,<(1-gone)*1.6+0.02>,<(1-gone)*0.7+0.02>,<(1-gone)*0.5+0.02>,)]_{E}
NUT{}{step==1}{} -> NUT[BEAK(,,,,<(5*far)*(1-gone)+0.02>,<0.16*(1-gone)+0.01>,<0.16*(1-gone)+0.01>,)]_{E}
BEAK{}{step==2}{} -> BEAK[BEAK(,<math.random(-8,8)>,,,H,L,W,)]_{E}
BEAK{}{step==3}{} -> BEAK[HUB(,,,,<0.14*(1-gone)+0.01>,<0.3*(1-gone)+0.01>,<0.3*(1-gone)+0.01>,)]_{E}
/* Each hair has a thin short root, so that rounding does not make it a ray of a star. */
ROOT -> ROOT[HAIR(,,,,<(3.6+1.6*open)*(1-gone)+0.02>,<0.06*(1-gone)+0.004>,<0.06*(1-gone)+0.004>,)]_{E}
HUB -> HUB[ROOT(,<-22-60*(1-open)+math.random(-12,12)>,,,<0.12*(1-gone)+0.01>,<0.05*(1-gone)+0.004>,<0.05*(1-gone)+0.004>,)]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12,C13,C14}

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 2 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<thick*max(0.25,1-u^3)>,<thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
`,
	dandelion: `/* Dandelion
   about: A head of ligules in spirals by the golden angle on a hollow stalk; the outer bracts turn back; toothed leaves in a rosette.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=85 /* 40 … 150 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1 /* 0.7 … 1.4, of the flower */
#define tall=length*math.random(0.73,1.24)
#define size=scale*math.random(0.92,1.1)
#define florets=floor(math.random(110,150))
#define leaves=floor(math.random(5,8))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define ROSETTE(13,0,0,-0.954,0.5,5,5,2)
#define GROWN(13,0,0,0,0.5,5,5,2)
#define STEM(13,0,0,0,20,3.4,3.4,1)
#define CUP(13,0,0,0,1.5,9,9,3)
#define RIM(13,0,0,14,2.5,12,12,3)
#define HEAD(13,0,0,-0.954,0.04,11,11,6)
#define BARE(13,0,0,0,0,12,12,6)
#define finalStep=leaves+14+florets

#material 1 stem "a8927c" "a3b37c"
#material 2 leaf "4a7a34" "62913f" veins "b9c98f" 8 0.3 feathered light 0.35 name "leaf, upper epidermis"
#material 12 leaf "7d9f5d" "8aaa61" light 0.35 name "leaf, mesophyll"
#material 13 leaf "688f52" "7ba05c" light 0.35 name "leaf, lower epidermis"
#material 3 sepal "567f45" "6d9452" name "bract"
#material 4 petal "f6c60e" "ffe414" bud "d6b818" "dcc83a" wilted "d0a030" "b98f3c" name "ligule, upper epidermis"
#material 8 petal "eebc10" "f6d818" bud "c8a01a" "d0b038" wilted "c49630" "b0883a" name "ligule, mesophyll"
#material 9 petal "a8985a" "dcc430" foot 0.9 bud "7d8450" "8f9058" wilted "8a7a50" "94804c" name "ligule, lower epidermis"
#material 5 petal "f2bc0c" "ffdf12" wilted "c8942a" "a8803a" name "ligule"
#material 6 stamen "ecb814" "f8d41c"

#axiom: ROSETTE
ROSETTE{}{step<leaves}{} -> GROWN[ROSETTE]_{E}[&PETAL{K=20; J=2; len=math.random(66,92); wide=math.random(24,30); thick=0.9; start=-20+math.random(-10,10)-24*(1-open); sway=math.random(-9,9); low=16; mid=12; high=math.random(-6,16); cup=5; peak=1.7; foot=1; tip=0.8; claw=0.12; teeth=0.9; bites=5; barb=24; upper=2; middle=12; lower=13}]_{C(1+(5*step)%13)}
ROSETTE{}{step==leaves}{} -> ROSETTE[STEM]_{E}
STEM{}{step<leaves+10}{} -> STEM[STEM(,<bend+math.random(-2,2)+2*wilt>,<math.random(-2,2)>,,<tall*(0.35+0.65*open)/10>,,,)]_{E}
STEM{}{step==leaves+10}{} -> STEM[CUP(,<22*open>,,,,,,)]_{E}
CUP -> CUP[RIM]_{E}
CUP -> CUP[&BLADE{len=14*size; wide=2.6; thick=0.6; start=-64+122*open-20*wilt+math.random(-9,9); bend=36*open; peak=0.8; claw=0.9; paint=3}]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12,C13}
RIM -> RIM[HEAD]_{E}
RIM -> RIM[&BLADE{len=16.7*size; wide=3.2; thick=0.6; start=-72+106*min(open,1-wilt)+math.random(-5,5); bend=-14-46*(1-min(open,1-wilt)); peak=0.8; claw=0.95; paint=3}]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12,C13}
HEAD{k=step-leaves-12; q=k/florets; shut=max(1-open,wilt)}{step<finalStep-1}{} -> BARE[HEAD(,,,,<0.045*size>,<12*size*sqrt(max(0.01,1-q))>,<12*size*sqrt(max(0.01,1-q))>,)]_{E}[&LIGULE{len=size*(17.6-10.6*q)*math.random(0.9,1.06)*(1-0.35*(1-open)); wide=size*(1.3+1.3*open); start=-84+(96-92*q)*(1-shut)-q*4+math.random(-7,7); bend=(-22*(1-q)+10)*(1-shut); layered=(q<0.2); upper=4+(q>0.5)}]_{C(1+(5*step)%13)}

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 2 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<thick*max(0.25,1-u^3)>,<thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2

#module LIGULE
/* A floret's one petal, as BLADE; of the outer ones, whose back is seen, the epidermises grow on both its sides. */
#define S=5
#define len=18     /* mm */
#define wide=2
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define layered=0
#define upper=4
#define middle=8
#define lower=9
#define finalStep=7
#define B(4,0,0,0,len/S,wide*max(0.45,sin(180*(1/S)^1.2)^0.5),thick/(1+2*layered),upper+(middle-upper)*layered)
#define U(4,0,0,0,thick/3,wide,1,upper)
#define D(4,0,0,0,thick/3,wide,1,lower)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S>,,,,<wide*max(max(0.45*(1-s),0.7),sin(180*min(1,s)^1.2)^0.5)>,,)]_{E}
B{}{layered>0}{} -> B[U(,,,,,L,H,)]_{C3}[D(,,,,,L,H,)]_{C1}
U : U_C1 < U_C3 -> U_C1 | U_C3
D : D_C1 < D_C3 -> D_C1 | D_C3
`,
	"designed-buttercup": `/* Buttercup by choices
   about: Five sepals, five obovate petals, many stamens, and carpels each for itself.
   source: own text, assembled; the method is Petrenko 2014, section 3.3
*/
@organ stem section=round growth=arching length=160 thickness=2.2 base=6f9150 tip=86a862@
#define sides=12 /* 3 … 24, of the stem */
#define thick=2.2 /* 0.8 … 24 step 0.1 mm, of the stem */
#define length=160 /* 10 … 900 mm, of the stem */
#define bend=2.2 /* -5 … 5 step 0.1, degrees, of the stem from piece to piece */
#define piece=length/17*math.random(0.92,1.08)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)
#define STEM(sides,0,0,0,piece,thick,thick*1,1)
#define COLLAR(sides,0,0,0,1,thick,thick*1,1)
#define finalStep=18
#material 1 stem "6f9150" "86a862"
#axiom: STEM
STEM{}{step<16}{} -> STEM[STEM(,<bend*step/6+math.random(-0.8,0.8)+1.5*wilt>,<math.random(-0.8,0.8)>,,,,,)]_{E}
STEM{}{step==16}{} -> STEM[COLLAR]_{E}
COLLAR -> COLLAR[&CALYX]_{E}

@organ leaf count=4 arrangement=alternate outline=oblanceolate section=wavy length=62 width=16 thickness=0.7 stalk=0 angle=34 bend=30 curl=20 base=47793a tip=5f9449@
#define NODE1(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==1}{} -> STEM[NODE1]_{E}
NODE1 -> NODE1[STEM]_{E}
NODE1 -> NODE1[&LEAF{part=1}]_{C(1+floor(0*sides/12))}
#define NODE2(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==5}{} -> STEM[NODE2]_{E}
NODE2 -> NODE2[STEM]_{E}
NODE2 -> NODE2[&LEAF{part=0.92}]_{C(1+floor(5*sides/12))}
#define NODE3(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==9}{} -> STEM[NODE3]_{E}
NODE3 -> NODE3[STEM]_{E}
NODE3 -> NODE3[&LEAF{part=0.84}]_{C(1+floor(10*sides/12))}
#define NODE4(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==13}{} -> STEM[NODE4]_{E}
NODE4 -> NODE4[STEM]_{E}
NODE4 -> NODE4[&LEAF{part=0.76}]_{C(1+floor(3*sides/12))}

#module LEAF
#define part=1
#define tilt=0
#define K=12
#define J=2
#define len=62*part*1*math.random(0.96,1.04)
#define wide=16*part*1
#define thick=0.7
#define even=0
#define start=-(34)-tilt+math.random(-3,3)
#define low=13.5+13.5*wilt
#define mid=10.5+10.5*wilt
#define high=26+6*wilt
#define cup=4
#define wave=14
#define fan=0
#define phase=math.random(0,360)
#define finalStep=K+3
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,12)
#define RU1(4,0,0,0,1,0.3*thick,1,2)
#define RU2(4,0,0,0,1,0.3*thick,1,2)
#define RM1(4,0,0,0,1,0.3*thick,1,12)
#define RM2(4,0,0,0,1,0.3*thick,1,12)
#define RL1(4,0,0,0,1,0.3*thick,1,22)
#define RL2(4,0,0,0,1,0.3*thick,1,22)
#define LU1(4,0,0,0,1,0.3*thick,1,2)
#define LU2(4,0,0,0,1,0.3*thick,1,2)
#define LM1(4,0,0,0,1,0.3*thick,1,12)
#define LM2(4,0,0,0,1,0.3*thick,1,12)
#define LL1(4,0,0,0,1,0.3*thick,1,22)
#define LL2(4,0,0,0,1,0.3*thick,1,22)
#material 2 leaf "47793a" "5f9449" wilted "69723d" "797b44" name "leaf, upper epidermis"
#material 12 leaf "578449" "6c9c57" wilted "717745" "7e7e49" name "leaf, mesophyll"
#material 22 leaf "638d55" "77a362" wilted "777c4b" "82814e" name "leaf, lower epidermis"
#axiom: VEIN(,start,,,,,,)
VEIN{u=even*(step+1)/K+(1-even)*(1-cos(180*(step+1)/K))/2; d=even/K+(1-even)*sin(90/K)*sin(180*(step+1)/K)}{step<K-1}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*d>,0,0,<len*((1-even)*sin(90/K)*sin(180*(step+1.5)/K)+even/K)>,,,)]_{E}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,-0.016+s*(1.015+s*(-13.601+s*(72.378+s*(-112.881+s*(58.052+s*(-4.937))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,,H,)]_{C4}[RM1(,f,<cup/2>,,w,,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,,H,)]_{C2}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,-0.016+s*(1.015+s*(-13.601+s*(72.378+s*(-112.881+s*(58.052+s*(-4.937))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[LU1(,f,<45-cup/2>,,w,,H,)]_{C6}[LM1(,f,<-cup/2>,,w,,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,,H,)]_{C8}
RU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RU1[RU2(,,<cup+r>,,H,,W,)]_{E}
RM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RM1[RM2(,,<cup+r>,,H,,W,)]_{E}
RL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RL1[RL2(,,<cup+r>,,H,,W,)]_{E}
LU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LU1[LU2(,,<-cup-r>,,H,,W,)]_{E}
LM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LM1[LM2(,,<-cup-r>,,H,,W,)]_{E}
LL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LL1[LL2(,,<-cup-r>,,H,,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2

@organ sepal count=5 outline=ovate section=cupped length=7 width=4.5 thickness=0.4 angle=14 bend=-30 curl=10 radius=1.7 base=b7bd55 tip=c9c95e@
#module CALYX
#define FOOT(5,180,0,0,1,1,1,1)
#define RING1(10,0,0,0,2.2,3.4,3.4,1)
#define finalStep=2
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[&COROLLA]_{E}
RING1 -> RING1[&SEPAL]_{C2,C4,C6,C8,C10}

#module SEPAL
#define part=1
#define tilt=0
#define K=12
#define J=3
#define len=7*part*(0.55+0.45*open)*math.random(0.96,1.04)
#define wide=4.5*part*(0.55+0.45*open)
#define thick=0.4
#define even=0
#define start=-(14+72*(1-open)-18*wilt)-tilt+math.random(-3,3)
#define low=-13.5*open-22.5*(1-open)+10.8*wilt
#define mid=-10.5*open-17.5*(1-open)+8.4*wilt
#define high=4*open-10*(1-open)+4.8*wilt
#define cup=7
#define wave=0+8*wilt
#define fan=0
#define phase=math.random(0,360)
#define finalStep=K+3
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,13)
#define RU1(4,0,0,0,1,0.3*thick,1,3)
#define RU2(4,0,0,0,1,0.3*thick,1,3)
#define RU3(4,0,0,0,1,0.3*thick,1,3)
#define RM1(4,0,0,0,1,0.3*thick,1,13)
#define RM2(4,0,0,0,1,0.3*thick,1,13)
#define RM3(4,0,0,0,1,0.3*thick,1,13)
#define RL1(4,0,0,0,1,0.3*thick,1,23)
#define RL2(4,0,0,0,1,0.3*thick,1,23)
#define RL3(4,0,0,0,1,0.3*thick,1,23)
#define LU1(4,0,0,0,1,0.3*thick,1,3)
#define LU2(4,0,0,0,1,0.3*thick,1,3)
#define LU3(4,0,0,0,1,0.3*thick,1,3)
#define LM1(4,0,0,0,1,0.3*thick,1,13)
#define LM2(4,0,0,0,1,0.3*thick,1,13)
#define LM3(4,0,0,0,1,0.3*thick,1,13)
#define LL1(4,0,0,0,1,0.3*thick,1,23)
#define LL2(4,0,0,0,1,0.3*thick,1,23)
#define LL3(4,0,0,0,1,0.3*thick,1,23)
#material 3 sepal "b7bd55" "c9c95e" wilted "a1944b" "a3904c" name "sepal, upper epidermis"
#material 13 sepal "bbc162" "cccc6a" wilted "a39651" "a49151" name "sepal, mesophyll"
#material 23 sepal "bfc46c" "cece73" wilted "a59756" "a59254" name "sepal, lower epidermis"
#axiom: VEIN(,start,,,,,,)
VEIN{u=even*(step+1)/K+(1-even)*(1-cos(180*(step+1)/K))/2; d=even/K+(1-even)*sin(90/K)*sin(180*(step+1)/K)}{step<K-1}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*d>,0,0,<len*((1-even)*sin(90/K)*sin(180*(step+1.5)/K)+even/K)>,,,)]_{E}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,-0.005+s*(2.643+s*(10.507+s*(-38.511+s*(27.774+s*(4.812+s*(-7.221))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,,H,)]_{C4}[RM1(,f,<cup/2>,,w,,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,,H,)]_{C2}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,-0.005+s*(2.643+s*(10.507+s*(-38.511+s*(27.774+s*(4.812+s*(-7.221))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[LU1(,f,<45-cup/2>,,w,,H,)]_{C6}[LM1(,f,<-cup/2>,,w,,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,,H,)]_{C8}
RU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RU1[RU2(,,<cup+r>,,H,,W,)]_{E}
RM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RM1[RM2(,,<cup+r>,,H,,W,)]_{E}
RL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RL1[RL2(,,<cup+r>,,H,,W,)]_{E}
LU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LU1[LU2(,,<-cup-r>,,H,,W,)]_{E}
LM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LM1[LM2(,,<-cup-r>,,H,,W,)]_{E}
LL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LL1[LL2(,,<-cup-r>,,H,,W,)]_{E}
RU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RU2[RU3(,,<cup+r>,,H,,W,)]_{E}
RM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RM2[RM3(,,<cup+r>,,H,,W,)]_{E}
RL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RL2[RL3(,,<cup+r>,,H,,W,)]_{E}
LU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LU2[LU3(,,<-cup-r>,,H,,W,)]_{E}
LM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LM2[LM3(,,<-cup-r>,,H,,W,)]_{E}
LL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LL2[LL3(,,<-cup-r>,,H,,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

@organ petal count=5 whorls=1 symmetry=radial lip=35 outline=obovate section=cupped length=15 width=14 thickness=0.5 angle=22 bend=-38 curl=6 veins=0 radius=2 base=e6b70c tip=f8d414@
#module COROLLA
#define FOOT(5,180,0,0,1,1,1,4)
#define RING1(10,0,0,0,2.2,4,4,4)
#define finalStep=2
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[&ANDROECIUM]_{E}
RING1 -> RING1[&PETAL]_{C1,C3,C5,C7,C9}

#module PETAL
#define part=1
#define tilt=0
#define K=12
#define J=3
#define len=15*part*(0.55+0.45*open)*math.random(0.96,1.04)
#define wide=14*part*(0.55+0.45*open)
#define thick=0.5
#define even=0
#define start=-(22+64*(1-open)-18*wilt)-tilt+math.random(-3,3)
#define low=-17.1*open-22.5*(1-open)+10.8*wilt
#define mid=-13.3*open-17.5*(1-open)+8.4*wilt
#define high=-1.6*open-10*(1-open)+4.8*wilt
#define cup=7
#define wave=0+8*wilt
#define fan=0
#define phase=math.random(0,360)
#define finalStep=K+3
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,14)
#define RU1(4,0,0,0,1,0.3*thick,1,4)
#define RU2(4,0,0,0,1,0.3*thick,1,4)
#define RU3(4,0,0,0,1,0.3*thick,1,4)
#define RM1(4,0,0,0,1,0.3*thick,1,14)
#define RM2(4,0,0,0,1,0.3*thick,1,14)
#define RM3(4,0,0,0,1,0.3*thick,1,14)
#define RL1(4,0,0,0,1,0.3*thick,1,24)
#define RL2(4,0,0,0,1,0.3*thick,1,24)
#define RL3(4,0,0,0,1,0.3*thick,1,24)
#define LU1(4,0,0,0,1,0.3*thick,1,4)
#define LU2(4,0,0,0,1,0.3*thick,1,4)
#define LU3(4,0,0,0,1,0.3*thick,1,4)
#define LM1(4,0,0,0,1,0.3*thick,1,14)
#define LM2(4,0,0,0,1,0.3*thick,1,14)
#define LM3(4,0,0,0,1,0.3*thick,1,14)
#define LL1(4,0,0,0,1,0.3*thick,1,24)
#define LL2(4,0,0,0,1,0.3*thick,1,24)
#define LL3(4,0,0,0,1,0.3*thick,1,24)
#material 4 petal "e6b70c" "f8d414" bud "a8a43a" "c3b831" wilted "b89126" "b6942e" name "petal, upper epidermis"
#material 14 petal "e6bc20" "f6d627" bud "a8a640" "c2b93b" wilted "b89330" "b59536" name "petal, mesophyll"
#material 24 petal "e5bf30" "f4d736" bud "a7a745" "c1ba42" wilted "b89538" "b4963c" name "petal, lower epidermis"
#axiom: VEIN(,start,,,,,,)
VEIN{u=even*(step+1)/K+(1-even)*(1-cos(180*(step+1)/K))/2; d=even/K+(1-even)*sin(90/K)*sin(180*(step+1)/K)}{step<K-1}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*d>,0,0,<len*((1-even)*sin(90/K)*sin(180*(step+1.5)/K)+even/K)>,,,)]_{E}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,-0.001+s*(0.045+s*(1.426+s*(23.712+s*(-56.479+s*(38.513+s*(-7.221))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,,H,)]_{C4}[RM1(,f,<cup/2>,,w,,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,,H,)]_{C2}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,-0.001+s*(0.045+s*(1.426+s*(23.712+s*(-56.479+s*(38.513+s*(-7.221))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[LU1(,f,<45-cup/2>,,w,,H,)]_{C6}[LM1(,f,<-cup/2>,,w,,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,,H,)]_{C8}
RU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RU1[RU2(,,<cup+r>,,H,,W,)]_{E}
RM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RM1[RM2(,,<cup+r>,,H,,W,)]_{E}
RL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RL1[RL2(,,<cup+r>,,H,,W,)]_{E}
LU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LU1[LU2(,,<-cup-r>,,H,,W,)]_{E}
LM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LM1[LM2(,,<-cup-r>,,H,,W,)]_{E}
LL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LL1[LL2(,,<-cup-r>,,H,,W,)]_{E}
RU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RU2[RU3(,,<cup+r>,,H,,W,)]_{E}
RM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RM2[RM3(,,<cup+r>,,H,,W,)]_{E}
RL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RL2[RL3(,,<cup+r>,,H,,W,)]_{E}
LU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LU2[LU3(,,<-cup-r>,,H,,W,)]_{E}
LM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LM2[LM3(,,<-cup-r>,,H,,W,)]_{E}
LL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LL2[LL3(,,<-cup-r>,,H,,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

@organ stamen count=12 whorls=3 attachment=basifixed length=4 thickness=0.3 anther=1.6 angle=52 bend=-14 radius=2.2 base=d9c238 tip=dba51c@
#module ANDROECIUM
#define FOOT(5,180,0,0,1,1,1,6)
#define RING1(24,0,0,0,2.2,4.4,4.4,6)
#define RING2(24,0,0,0,1.2,4,4,6)
#define RING3(24,0,0,0,1.2,3.6,3.6,6)
#define finalStep=4
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[RING2]_{E}
RING1 -> RING1[&STAMEN]_{C2,C4,C6,C8,C10,C12,C14,C16,C18,C20,C22,C24}
RING2 -> RING2[RING3]_{E}
RING2 -> RING2[&STAMEN{part=0.92; tilt=6}]_{C1,C3,C5,C7,C9,C11,C13,C15,C17,C19,C21,C23}
RING3 -> RING3[&GYNOECIUM]_{E}
RING3 -> RING3[&STAMEN{part=0.84; tilt=12}]_{C2,C4,C6,C8,C10,C12,C14,C16,C18,C20,C22,C24}

#module STAMEN
#define part=1
#define tilt=0
#define long=4*part*(0.6+0.4*open)*math.random(0.94,1.06)
#define head=1.6*math.random(0.95,1.05)
#define FILAMENT(6,0,0,0,long/8,0.3,0.3,6)
#define JOINT(4,0,0,0,0.32,0.32,0.32,7)
#define ANTHER(4,0,0,0,head/5,0.32,0.32,7)
#define finalStep=14
#material 6 stamen "d9c238" "d9c238"
#material 7 stamen "dba51c" "dba51c"
#axiom: FILAMENT(,<-(52+(85-52)*(1-open))-tilt+math.random(-4,4)>,,,,,,)
FILAMENT{}{step<7}{} -> FILAMENT[FILAMENT(,<-14/7>,,,,,,)]_{E}
FILAMENT{}{step==7}{} -> FILAMENT[JOINT]_{E}
JOINT -> JOINT[ANTHER]_{E}
ANTHER{k=step-8}{step>7&&step<13}{} -> ANTHER[ANTHER(,0,,,,<0.32*(1.9-0.1*(k-2)^2)>,<0.32*(1.5-0.1*(k-2)^2)>,)]_{E}

@organ pistil count=14 fusion=apocarpous length=2 width=2.6 style=0.4 stigma=0.5 angle=62 radius=1.4 base=9ab04a tip=b9c95a@
#module GYNOECIUM
#define FOOT(5,180,0,0,1,1,1,8)
#define RING1(28,0,0,0,2.2,2.8,2.8,8)
#define finalStep=2
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[&PISTIL]_{C1,C3,C5,C7,C9,C11,C13,C15,C17,C19,C21,C23,C25,C27}

#module PISTIL
#define wide=2.6*0.25
#define OVARY(6,0,0,0,2/6,wide*0.7,wide*0.7,8)
#define STYLE(6,0,0,0,0.4*(0.7+0.3*open)/4,wide*0.3,wide*0.3,8)
#define STIGMA(6,0,0,0,0.5/4,0.5*0.6,0.5*0.6,9)
#define LOBE(4,0,0,0,0.5/5,0.5/5,0.5/5,9)
#define finalStep=15
#material 8 pistil "9ab04a" "9ab04a"
#material 9 pistil "b9c95a" "b9c95a"
#axiom: OVARY(,-62+math.random(-3,3),,,,,,)
OVARY{}{step<5}{} -> OVARY[OVARY(,0,,,,<wide*(0.55+0.45*sin(36*(step+1)))>,<wide*(0.55+0.45*sin(36*(step+1)))>,)]_{E}
OVARY{}{step==5}{} -> OVARY[STYLE]_{E}
STYLE{}{step<9}{} -> STYLE[STYLE]_{E}
STYLE{}{step==9}{} -> STYLE[STIGMA]_{E}
STIGMA -> STIGMA[LOBE]_{C1,C3,C5}
LOBE{}{step>10&&step<13}{} -> LOBE[LOBE(,20,,,,,,)]_{E}

`,
	"designed-lily": `/* Lily by choices
   about: Two whorls of lanceolate petals that roll back, long filaments with dorsifixed anthers, one long style.
   source: own text, assembled; the method is Petrenko 2014, section 3.3
*/
@organ stem section=round growth=arching length=420 thickness=6 base=6d8f4e tip=8aa862@
#define sides=12 /* 3 … 24, of the stem */
#define thick=6 /* 0.8 … 24 step 0.1 mm, of the stem */
#define length=420 /* 10 … 900 mm, of the stem */
#define bend=2.2 /* -5 … 5 step 0.1, degrees, of the stem from piece to piece */
#define piece=length/17*math.random(0.92,1.08)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)
#define STEM(sides,0,0,0,piece,thick,thick*1,1)
#define COLLAR(sides,0,0,0,1,thick,thick*1,1)
#define finalStep=18
#material 1 stem "6d8f4e" "8aa862"
#axiom: STEM
STEM{}{step<16}{} -> STEM[STEM(,<bend*step/6+math.random(-0.8,0.8)+1.5*wilt>,<math.random(-0.8,0.8)>,,,,,)]_{E}
STEM{}{step==16}{} -> STEM[COLLAR]_{E}
COLLAR -> COLLAR[&CALYX]_{E}

@organ leaf count=8 arrangement=alternate outline=lanceolate section=channelled length=110 width=17 thickness=1 stalk=0 angle=24 bend=22 curl=20 base=3f6f3a tip=4f8446@
#define NODE1(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==0}{} -> STEM[NODE1]_{E}
NODE1 -> NODE1[STEM]_{E}
NODE1 -> NODE1[&LEAF{part=1}]_{C(1+floor(0*sides/12))}
#define NODE2(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==2}{} -> STEM[NODE2]_{E}
NODE2 -> NODE2[STEM]_{E}
NODE2 -> NODE2[&LEAF{part=0.92}]_{C(1+floor(5*sides/12))}
#define NODE3(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==4}{} -> STEM[NODE3]_{E}
NODE3 -> NODE3[STEM]_{E}
NODE3 -> NODE3[&LEAF{part=0.84}]_{C(1+floor(10*sides/12))}
#define NODE4(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==6}{} -> STEM[NODE4]_{E}
NODE4 -> NODE4[STEM]_{E}
NODE4 -> NODE4[&LEAF{part=0.76}]_{C(1+floor(3*sides/12))}
#define NODE5(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==8}{} -> STEM[NODE5]_{E}
NODE5 -> NODE5[STEM]_{E}
NODE5 -> NODE5[&LEAF{part=0.68}]_{C(1+floor(8*sides/12))}
#define NODE6(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==10}{} -> STEM[NODE6]_{E}
NODE6 -> NODE6[STEM]_{E}
NODE6 -> NODE6[&LEAF{part=0.6}]_{C(1+floor(1*sides/12))}
#define NODE7(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==12}{} -> STEM[NODE7]_{E}
NODE7 -> NODE7[STEM]_{E}
NODE7 -> NODE7[&LEAF{part=0.52}]_{C(1+floor(6*sides/12))}
#define NODE8(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==14}{} -> STEM[NODE8]_{E}
NODE8 -> NODE8[STEM]_{E}
NODE8 -> NODE8[&LEAF{part=0.44}]_{C(1+floor(11*sides/12))}

#module LEAF
#define part=1
#define tilt=0
#define K=12
#define J=2
#define len=110*part*1*math.random(0.96,1.04)
#define wide=17*part*1
#define thick=1
#define even=0
#define start=-(24)-tilt+math.random(-3,3)
#define low=9.9+13.5*wilt
#define mid=7.7+10.5*wilt
#define high=24.4+6*wilt
#define cup=18
#define wave=0
#define fan=0
#define phase=math.random(0,360)
#define finalStep=K+3
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,12)
#define RU1(4,0,0,0,1,0.3*thick,1,2)
#define RU2(4,0,0,0,1,0.3*thick,1,2)
#define RM1(4,0,0,0,1,0.3*thick,1,12)
#define RM2(4,0,0,0,1,0.3*thick,1,12)
#define RL1(4,0,0,0,1,0.3*thick,1,22)
#define RL2(4,0,0,0,1,0.3*thick,1,22)
#define LU1(4,0,0,0,1,0.3*thick,1,2)
#define LU2(4,0,0,0,1,0.3*thick,1,2)
#define LM1(4,0,0,0,1,0.3*thick,1,12)
#define LM2(4,0,0,0,1,0.3*thick,1,12)
#define LL1(4,0,0,0,1,0.3*thick,1,22)
#define LL2(4,0,0,0,1,0.3*thick,1,22)
#material 2 leaf "3f6f3a" "4f8446" wilted "656d3d" "727442" name "leaf, upper epidermis"
#material 12 leaf "4f7b49" "5e8e54" wilted "6d7345" "787848" name "leaf, mesophyll"
#material 22 leaf "5c8455" "69965f" wilted "73774b" "7d7c4c" name "leaf, lower epidermis"
#axiom: VEIN(,start,,,,,,)
VEIN{u=even*(step+1)/K+(1-even)*(1-cos(180*(step+1)/K))/2; d=even/K+(1-even)*sin(90/K)*sin(180*(step+1)/K)}{step<K-1}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*d>,0,0,<len*((1-even)*sin(90/K)*sin(180*(step+1.5)/K)+even/K)>,,,)]_{E}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.011+s*(-0.066+s*(32.723+s*(-102.646+s*(103.332+s*(-28.433+s*(-4.937))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,,H,)]_{C4}[RM1(,f,<cup/2>,,w,,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,,H,)]_{C2}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.011+s*(-0.066+s*(32.723+s*(-102.646+s*(103.332+s*(-28.433+s*(-4.937))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[LU1(,f,<45-cup/2>,,w,,H,)]_{C6}[LM1(,f,<-cup/2>,,w,,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,,H,)]_{C8}
RU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RU1[RU2(,,<cup+r>,,H,,W,)]_{E}
RM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RM1[RM2(,,<cup+r>,,H,,W,)]_{E}
RL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RL1[RL2(,,<cup+r>,,H,,W,)]_{E}
LU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LU1[LU2(,,<-cup-r>,,H,,W,)]_{E}
LM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LM1[LM2(,,<-cup-r>,,H,,W,)]_{E}
LL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LL1[LL2(,,<-cup-r>,,H,,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2

@organ sepal count=0 outline=ovate section=cupped length=14 width=8 thickness=0.5 angle=30 bend=-20 curl=0 radius=4 base=8aa356 tip=9fb868@
#module CALYX
#define FOOT(5,180,0,0,1,1,1,1)
#define RING1(10,0,0,0,2.2,8,8,1)
#define finalStep=2
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[&COROLLA]_{E}

@organ petal count=3 whorls=2 symmetry=radial lip=35 outline=lanceolate section=channelled length=105 width=34 thickness=1.2 angle=62 bend=40 curl=85 veins=0 radius=3.8 base=f6e9c4 tip=f4f1ee@
#module COROLLA
#define FOOT(5,180,0,0,1,1,1,4)
#define RING1(12,0,0,0,2.2,7.6,7.6,4)
#define RING2(12,0,0,0,1.2,6.8,6.8,4)
#define finalStep=3
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[RING2]_{E}
RING1 -> RING1[&PETAL]_{C1,C5,C9}
RING2 -> RING2[&ANDROECIUM]_{E}
RING2 -> RING2[&PETAL{part=0.92; tilt=6}]_{C3,C7,C11}

#module PETAL
#define part=1
#define tilt=0
#define K=12
#define J=3
#define len=105*part*(0.55+0.45*open)*math.random(0.96,1.04)
#define wide=34*part*(0.55+0.45*open)
#define thick=1.2
#define even=0
#define start=-(62+24*(1-open)-18*wilt)-tilt+math.random(-3,3)
#define low=18*open-22.5*(1-open)+10.8*wilt
#define mid=14*open-17.5*(1-open)+8.4*wilt
#define high=93*open-10*(1-open)+4.8*wilt
#define cup=18
#define wave=0+8*wilt
#define fan=0
#define phase=math.random(0,360)
#define finalStep=K+3
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,14)
#define RU1(4,0,0,0,1,0.3*thick,1,4)
#define RU2(4,0,0,0,1,0.3*thick,1,4)
#define RU3(4,0,0,0,1,0.3*thick,1,4)
#define RM1(4,0,0,0,1,0.3*thick,1,14)
#define RM2(4,0,0,0,1,0.3*thick,1,14)
#define RM3(4,0,0,0,1,0.3*thick,1,14)
#define RL1(4,0,0,0,1,0.3*thick,1,24)
#define RL2(4,0,0,0,1,0.3*thick,1,24)
#define RL3(4,0,0,0,1,0.3*thick,1,24)
#define LU1(4,0,0,0,1,0.3*thick,1,4)
#define LU2(4,0,0,0,1,0.3*thick,1,4)
#define LU3(4,0,0,0,1,0.3*thick,1,4)
#define LM1(4,0,0,0,1,0.3*thick,1,14)
#define LM2(4,0,0,0,1,0.3*thick,1,14)
#define LM3(4,0,0,0,1,0.3*thick,1,14)
#define LL1(4,0,0,0,1,0.3*thick,1,24)
#define LL2(4,0,0,0,1,0.3*thick,1,24)
#define LL3(4,0,0,0,1,0.3*thick,1,24)
#material 4 petal "f6e9c4" "f4f1ee" bud "adb371" "c1c79e" wilted "c0aa82" "b4a086" name "petal, upper epidermis"
#material 14 petal "f4e9c5" "f2f0eb" bud "acb372" "c0c69d" wilted "bfaa83" "b4a084" name "petal, mesophyll"
#material 24 petal "f2e8c7" "f1efe9" bud "abb372" "bfc69c" wilted "bea984" "b39f84" name "petal, lower epidermis"
#axiom: VEIN(,start,,,,,,)
VEIN{u=even*(step+1)/K+(1-even)*(1-cos(180*(step+1)/K))/2; d=even/K+(1-even)*sin(90/K)*sin(180*(step+1)/K)}{step<K-1}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*d>,0,0,<len*((1-even)*sin(90/K)*sin(180*(step+1.5)/K)+even/K)>,,,)]_{E}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.011+s*(-0.066+s*(32.723+s*(-102.646+s*(103.332+s*(-28.433+s*(-4.937))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,,H,)]_{C4}[RM1(,f,<cup/2>,,w,,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,,H,)]_{C2}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.011+s*(-0.066+s*(32.723+s*(-102.646+s*(103.332+s*(-28.433+s*(-4.937))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[LU1(,f,<45-cup/2>,,w,,H,)]_{C6}[LM1(,f,<-cup/2>,,w,,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,,H,)]_{C8}
RU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RU1[RU2(,,<cup+r>,,H,,W,)]_{E}
RM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RM1[RM2(,,<cup+r>,,H,,W,)]_{E}
RL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RL1[RL2(,,<cup+r>,,H,,W,)]_{E}
LU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LU1[LU2(,,<-cup-r>,,H,,W,)]_{E}
LM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LM1[LM2(,,<-cup-r>,,H,,W,)]_{E}
LL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LL1[LL2(,,<-cup-r>,,H,,W,)]_{E}
RU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RU2[RU3(,,<cup+r>,,H,,W,)]_{E}
RM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RM2[RM3(,,<cup+r>,,H,,W,)]_{E}
RL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RL2[RL3(,,<cup+r>,,H,,W,)]_{E}
LU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LU2[LU3(,,<-cup-r>,,H,,W,)]_{E}
LM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LM2[LM3(,,<-cup-r>,,H,,W,)]_{E}
LL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LL2[LL3(,,<-cup-r>,,H,,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

@organ stamen count=3 whorls=2 attachment=dorsifixed length=74 thickness=1.2 anther=14 angle=76 bend=16 radius=3 base=dfe6b4 tip=a8481c@
#module ANDROECIUM
#define FOOT(5,180,0,0,1,1,1,6)
#define RING1(12,0,0,0,2.2,6,6,6)
#define RING2(12,0,0,0,1.2,5.4,5.4,6)
#define finalStep=3
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[RING2]_{E}
RING1 -> RING1[&STAMEN]_{C3,C7,C11}
RING2 -> RING2[&GYNOECIUM]_{E}
RING2 -> RING2[&STAMEN{part=0.92; tilt=6}]_{C1,C5,C9}

#module STAMEN
#define part=1
#define tilt=0
#define long=74*part*(0.6+0.4*open)*math.random(0.94,1.06)
#define head=14*math.random(0.95,1.05)
#define FILAMENT(6,0,0,0,long/8,1.2,1.2,6)
#define JOINT(4,0,0,0,2.8,2.8,2.8,7)
#define ANTHER(4,0,0,0,head/6,2.8,2.8,7)
#define finalStep=14
#material 6 stamen "dfe6b4" "dfe6b4"
#material 7 stamen "a8481c" "a8481c"
#axiom: FILAMENT(,<-(76+(85-76)*(1-open))-tilt+math.random(-4,4)>,,,,,,)
FILAMENT{}{step<7}{} -> FILAMENT[FILAMENT(,<16/7>,,,,,,)]_{E}
FILAMENT{}{step==7}{} -> FILAMENT[JOINT]_{E}
JOINT -> JOINT[ANTHER]_{C1,C3}
ANTHER{k=step-8}{step>7&&step<11}{} -> ANTHER[ANTHER(,0,,,,<2.8*(1.9-0.16*(k-0)^2)>,<2.8*(1.5-0.16*(k-0)^2)>,)]_{E}

@organ pistil count=3 fusion=syncarpous length=26 width=4.6 style=58 stigma=5 angle=60 radius=2.2 base=9fb56a tip=b5b86e@
#module GYNOECIUM
#define FOOT(5,180,0,0,1,1,1,8)
#define RING1(10,0,0,0,2.2,4.4,4.4,8)
#define finalStep=2
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[&PISTIL]_{E}

#module PISTIL
#define wide=4.6*1
#define OVARY(12,0,0,0,26/6,wide*0.7,wide*0.7,8)
#define STYLE(12,0,0,0,58*(0.7+0.3*open)/4,wide*0.3,wide*0.3,8)
#define STIGMA(12,0,0,0,5/4,5*0.6,5*0.6,9)
#define LOBE(4,0,0,0,5/5,5/5,5/5,9)
#define finalStep=15
#material 8 pistil "9fb56a" "9fb56a"
#material 9 pistil "b5b86e" "b5b86e"
#axiom: OVARY(,0,,,,,,)
OVARY{}{step<5}{} -> OVARY[OVARY(,0,,,,<wide*(0.55+0.45*sin(36*(step+1)))>,<wide*(0.55+0.45*sin(36*(step+1)))>,)]_{E}
OVARY{}{step==5}{} -> OVARY[STYLE]_{E}
STYLE{}{step<9}{} -> STYLE[STYLE]_{E}
STYLE{}{step==9}{} -> STYLE[STIGMA]_{E}
STIGMA -> STIGMA[LOBE]_{C1,C5,C9}
LOBE{}{step>10&&step<13}{} -> LOBE[LOBE(,20,,,,,,)]_{E}

`,
	"designed-tulip": `/* Tulip by choices
   about: The thesis's example, described organ by organ: an erect round stem, apical leaves, no sepals, six rounded petals, six basifixed stamens, a syncarpous pistil.
   source: own text, assembled; the method is Petrenko 2014, section 3.3
*/
@organ stem section=round growth=erect length=300 thickness=6.4 base=7f9a55 tip=9ab36c@
#define sides=12 /* 3 … 24, of the stem */
#define thick=6.4 /* 0.8 … 24 step 0.1 mm, of the stem */
#define length=300 /* 10 … 900 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees, of the stem from piece to piece */
#define piece=length/17*math.random(0.92,1.08)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)
#define STEM(sides,0,0,0,piece,thick,thick*1,1)
#define COLLAR(sides,0,0,0,1,thick,thick*1,1)
#define finalStep=18
#material 1 stem "7f9a55" "9ab36c"
#axiom: STEM
STEM{}{step<16}{} -> STEM[STEM(,<bend*step/6+math.random(-0.8,0.8)+1.5*wilt>,<math.random(-0.8,0.8)>,,,,,)]_{E}
STEM{}{step==16}{} -> STEM[COLLAR]_{E}
COLLAR -> COLLAR[&CALYX]_{E}

@organ leaf count=2 arrangement=alternate outline=apical section=channelled length=210 width=48 thickness=1.6 stalk=0 angle=72 bend=18 curl=22 base=587f58 tip=6c9a64@
#define NODE1(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==1}{} -> STEM[NODE1]_{E}
NODE1 -> NODE1[STEM]_{E}
NODE1 -> NODE1[&LEAF{part=1}]_{C(1+floor(0*sides/12))}
#define NODE2(sides,0,0,0,piece,thick,thick,1)
STEM{}{step==5}{} -> STEM[NODE2]_{E}
NODE2 -> NODE2[STEM]_{E}
NODE2 -> NODE2[&LEAF{part=0.92}]_{C(1+floor(5*sides/12))}

#module LEAF
#define part=1
#define tilt=0
#define K=12
#define J=2
#define len=210*part*1*math.random(0.96,1.04)
#define wide=48*part*1
#define thick=1.6
#define even=0
#define start=-(72)-tilt+math.random(-3,3)
#define low=8.1+13.5*wilt
#define mid=6.3+10.5*wilt
#define high=25.6+6*wilt
#define cup=18
#define wave=0
#define fan=0
#define phase=math.random(0,360)
#define finalStep=K+3
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,12)
#define RU1(4,0,0,0,1,0.3*thick,1,2)
#define RU2(4,0,0,0,1,0.3*thick,1,2)
#define RM1(4,0,0,0,1,0.3*thick,1,12)
#define RM2(4,0,0,0,1,0.3*thick,1,12)
#define RL1(4,0,0,0,1,0.3*thick,1,22)
#define RL2(4,0,0,0,1,0.3*thick,1,22)
#define LU1(4,0,0,0,1,0.3*thick,1,2)
#define LU2(4,0,0,0,1,0.3*thick,1,2)
#define LM1(4,0,0,0,1,0.3*thick,1,12)
#define LM2(4,0,0,0,1,0.3*thick,1,12)
#define LL1(4,0,0,0,1,0.3*thick,1,22)
#define LL2(4,0,0,0,1,0.3*thick,1,22)
#material 2 leaf "587f58" "6c9a64" wilted "71754c" "7e7d4e" name "leaf, upper epidermis"
#material 12 leaf "668964" "78a26f" wilted "787a52" "838053" name "leaf, mesophyll"
#material 22 leaf "71926e" "81a878" wilted "7e7e57" "868356" name "leaf, lower epidermis"
#axiom: VEIN(,start,,,,,,)
VEIN{u=even*(step+1)/K+(1-even)*(1-cos(180*(step+1)/K))/2; d=even/K+(1-even)*sin(90/K)*sin(180*(step+1)/K)}{step<K-1}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*d>,0,0,<len*((1-even)*sin(90/K)*sin(180*(step+1.5)/K)+even/K)>,,,)]_{E}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.54+s*(0.074+s*(4.099+s*(9.281+s*(-52.327+s*(56.925+s*(-18.594))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,,H,)]_{C4}[RM1(,f,<cup/2>,,w,,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,,H,)]_{C2}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.54+s*(0.074+s*(4.099+s*(9.281+s*(-52.327+s*(56.925+s*(-18.594))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[LU1(,f,<45-cup/2>,,w,,H,)]_{C6}[LM1(,f,<-cup/2>,,w,,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,,H,)]_{C8}
RU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RU1[RU2(,,<cup+r>,,H,,W,)]_{E}
RM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RM1[RM2(,,<cup+r>,,H,,W,)]_{E}
RL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RL1[RL2(,,<cup+r>,,H,,W,)]_{E}
LU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LU1[LU2(,,<-cup-r>,,H,,W,)]_{E}
LM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LM1[LM2(,,<-cup-r>,,H,,W,)]_{E}
LL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LL1[LL2(,,<-cup-r>,,H,,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2

@organ sepal count=0 outline=ovate section=cupped length=14 width=8 thickness=0.5 angle=30 bend=-20 curl=0 radius=4 base=8aa356 tip=9fb868@
#module CALYX
#define FOOT(5,180,0,0,1,1,1,1)
#define RING1(10,0,0,0,2.2,8,8,1)
#define finalStep=2
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[&COROLLA]_{E}

@organ petal count=3 whorls=2 symmetry=radial lip=35 outline=tulip section=cupped length=60 width=40 thickness=1.1 angle=12 bend=-84 curl=4 veins=0 radius=5.5 base=d8a23a tip=c21d2c@
#module COROLLA
#define FOOT(5,180,0,0,1,1,1,4)
#define RING1(12,0,0,0,2.2,11,11,4)
#define RING2(12,0,0,0,1.2,9.9,9.9,4)
#define finalStep=3
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[RING2]_{E}
RING1 -> RING1[&PETAL]_{C1,C5,C9}
RING2 -> RING2[&ANDROECIUM]_{E}
RING2 -> RING2[&PETAL{part=0.92; tilt=6}]_{C3,C7,C11}

#module PETAL
#define part=1
#define tilt=0
#define K=12
#define J=3
#define len=60*part*(0.55+0.45*open)*math.random(0.96,1.04)
#define wide=40*part*(0.55+0.45*open)
#define thick=1.1
#define even=0
#define start=-(12+74*(1-open)-18*wilt)-tilt+math.random(-3,3)
#define low=-37.8*open-22.5*(1-open)+10.8*wilt
#define mid=-29.4*open-17.5*(1-open)+8.4*wilt
#define high=-12.8*open-10*(1-open)+4.8*wilt
#define cup=7
#define wave=0+8*wilt
#define fan=0
#define phase=math.random(0,360)
#define finalStep=K+3
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,14)
#define RU1(4,0,0,0,1,0.3*thick,1,4)
#define RU2(4,0,0,0,1,0.3*thick,1,4)
#define RU3(4,0,0,0,1,0.3*thick,1,4)
#define RM1(4,0,0,0,1,0.3*thick,1,14)
#define RM2(4,0,0,0,1,0.3*thick,1,14)
#define RM3(4,0,0,0,1,0.3*thick,1,14)
#define RL1(4,0,0,0,1,0.3*thick,1,24)
#define RL2(4,0,0,0,1,0.3*thick,1,24)
#define RL3(4,0,0,0,1,0.3*thick,1,24)
#define LU1(4,0,0,0,1,0.3*thick,1,4)
#define LU2(4,0,0,0,1,0.3*thick,1,4)
#define LU3(4,0,0,0,1,0.3*thick,1,4)
#define LM1(4,0,0,0,1,0.3*thick,1,14)
#define LM2(4,0,0,0,1,0.3*thick,1,14)
#define LM3(4,0,0,0,1,0.3*thick,1,14)
#define LL1(4,0,0,0,1,0.3*thick,1,24)
#define LL2(4,0,0,0,1,0.3*thick,1,24)
#define LL3(4,0,0,0,1,0.3*thick,1,24)
#material 4 petal "d8a23a" "c21d2c" bud "a49e48" "a85d3d" wilted "b1863d" "a04b38" name "petal, upper epidermis"
#material 14 petal "d9a949" "c5313d" bud "a4a04d" "a96746" wilted "b28a45" "a2533f" name "petal, mesophyll"
#material 24 petal "daae55" "c8414a" bud "a4a150" "ab6f4c" wilted "b28c4b" "a35a44" name "petal, lower epidermis"
#axiom: VEIN(,start,,,,,,)
VEIN{u=even*(step+1)/K+(1-even)*(1-cos(180*(step+1)/K))/2; d=even/K+(1-even)*sin(90/K)*sin(180*(step+1)/K)}{step<K-1}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*d>,0,0,<len*((1-even)*sin(90/K)*sin(180*(step+1.5)/K)+even/K)>,,,)]_{E}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.465+s*(1.062+s*(-15.74+s*(96.338+s*(-206.369+s*(181.38+s*(-57.158))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,,H,)]_{C4}[RM1(,f,<cup/2>,,w,,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,,H,)]_{C2}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.465+s*(1.062+s*(-15.74+s*(96.338+s*(-206.369+s*(181.38+s*(-57.158))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[LU1(,f,<45-cup/2>,,w,,H,)]_{C6}[LM1(,f,<-cup/2>,,w,,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,,H,)]_{C8}
RU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RU1[RU2(,,<cup+r>,,H,,W,)]_{E}
RM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RM1[RM2(,,<cup+r>,,H,,W,)]_{E}
RL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RL1[RL2(,,<cup+r>,,H,,W,)]_{E}
LU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LU1[LU2(,,<-cup-r>,,H,,W,)]_{E}
LM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LM1[LM2(,,<-cup-r>,,H,,W,)]_{E}
LL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LL1[LL2(,,<-cup-r>,,H,,W,)]_{E}
RU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RU2[RU3(,,<cup+r>,,H,,W,)]_{E}
RM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RM2[RM3(,,<cup+r>,,H,,W,)]_{E}
RL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RL2[RL3(,,<cup+r>,,H,,W,)]_{E}
LU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LU2[LU3(,,<-cup-r>,,H,,W,)]_{E}
LM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LM2[LM3(,,<-cup-r>,,H,,W,)]_{E}
LL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LL2[LL3(,,<-cup-r>,,H,,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

@organ stamen count=3 whorls=2 attachment=basifixed length=16 thickness=1.5 anther=11 angle=72 bend=-8 radius=4 base=e8dfa5 tip=2f2633@
#module ANDROECIUM
#define FOOT(5,180,0,0,1,1,1,6)
#define RING1(12,0,0,0,2.2,8,8,6)
#define RING2(12,0,0,0,1.2,7.2,7.2,6)
#define finalStep=3
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[RING2]_{E}
RING1 -> RING1[&STAMEN]_{C3,C7,C11}
RING2 -> RING2[&GYNOECIUM]_{E}
RING2 -> RING2[&STAMEN{part=0.92; tilt=6}]_{C1,C5,C9}

#module STAMEN
#define part=1
#define tilt=0
#define long=16*part*(0.6+0.4*open)*math.random(0.94,1.06)
#define head=11*math.random(0.95,1.05)
#define FILAMENT(6,0,0,0,long/8,1.5,1.5,6)
#define JOINT(4,0,0,0,2.2,2.2,2.2,7)
#define ANTHER(4,0,0,0,head/5,2.2,2.2,7)
#define finalStep=14
#material 6 stamen "e8dfa5" "e8dfa5"
#material 7 stamen "2f2633" "2f2633"
#axiom: FILAMENT(,<-(72+(85-72)*(1-open))-tilt+math.random(-4,4)>,,,,,,)
FILAMENT{}{step<7}{} -> FILAMENT[FILAMENT(,<-8/7>,,,,,,)]_{E}
FILAMENT{}{step==7}{} -> FILAMENT[JOINT]_{E}
JOINT -> JOINT[ANTHER]_{E}
ANTHER{k=step-8}{step>7&&step<13}{} -> ANTHER[ANTHER(,0,,,,<2.2*(1.9-0.1*(k-2)^2)>,<2.2*(1.5-0.1*(k-2)^2)>,)]_{E}

@organ pistil count=3 fusion=syncarpous length=24 width=8 style=2 stigma=7 angle=60 radius=3 base=a3b873 tip=e3dfa0@
#module GYNOECIUM
#define FOOT(5,180,0,0,1,1,1,8)
#define RING1(10,0,0,0,2.2,6,6,8)
#define finalStep=2
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[&PISTIL]_{E}

#module PISTIL
#define wide=8*1
#define OVARY(12,0,0,0,24/6,wide*0.7,wide*0.7,8)
#define STYLE(12,0,0,0,2*(0.7+0.3*open)/4,wide*0.3,wide*0.3,8)
#define STIGMA(12,0,0,0,7/4,7*0.6,7*0.6,9)
#define LOBE(4,0,0,0,7/5,7/5,7/5,9)
#define finalStep=15
#material 8 pistil "a3b873" "a3b873"
#material 9 pistil "e3dfa0" "e3dfa0"
#axiom: OVARY(,0,,,,,,)
OVARY{}{step<5}{} -> OVARY[OVARY(,0,,,,<wide*(0.55+0.45*sin(36*(step+1)))>,<wide*(0.55+0.45*sin(36*(step+1)))>,)]_{E}
OVARY{}{step==5}{} -> OVARY[STYLE]_{E}
STYLE{}{step<9}{} -> STYLE[STYLE]_{E}
STYLE{}{step==9}{} -> STYLE[STIGMA]_{E}
STIGMA -> STIGMA[LOBE]_{C1,C5,C9}
LOBE{}{step>10&&step<13}{} -> LOBE[LOBE(,20,,,,,,)]_{E}

`,
	"designed-violet": `/* Violet by choices
   about: An irregular flower: its lower lip is larger than its upper petals; leaves at the foot, heart-shaped.
   source: own text, assembled; the method is Petrenko 2014, section 3.3
*/
@organ stem section=square growth=nodding length=90 thickness=1.8 base=6f8d4c tip=8c8f58@
#define sides=4 /* 3 … 24, of the stem */
#define thick=1.8 /* 0.8 … 24 step 0.1 mm, of the stem */
#define length=90 /* 10 … 900 mm, of the stem */
#define bend=5 /* -5 … 5 step 0.1, degrees, of the stem from piece to piece */
#define piece=length/17*math.random(0.92,1.08)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)
#define STEM(sides,0,0,0,piece,thick,thick*1,1)
#define COLLAR(sides,0,0,0,1,thick,thick*1,1)
#define finalStep=18
#material 1 stem "6f8d4c" "8c8f58"
#axiom: STEM
STEM{}{step<16}{} -> STEM[STEM(,<bend*step/6+math.random(-0.8,0.8)+1.5*wilt>,<math.random(-0.8,0.8)>,,,,,)]_{E}
STEM{}{step==16}{} -> STEM[COLLAR]_{E}
COLLAR -> COLLAR[&CALYX]_{E}

@organ leaf count=5 arrangement=basal outline=cordate section=cupped length=42 width=34 thickness=0.7 stalk=0 angle=30 bend=10 curl=25 base=3c6a33 tip=558a45@
#define NODE1(sides,0,0,0,1+0.3*thick,thick,thick,1)
STEM{}{step==0}{} -> STEM[NODE1]_{E}
NODE1 -> NODE1[NODE2]_{E}
NODE1 -> NODE1[&LEAF{part=1}]_{C(1+floor(0*sides/12)),C(1+floor(4*sides/12)),C(1+floor(8*sides/12))}
#define NODE2(sides,0,0,0,1+0.3*thick,thick,thick,1)
NODE2 -> NODE2[STEM]_{E}
NODE2 -> NODE2[&LEAF{part=0.92}]_{C(1+floor(2*sides/12)),C(1+floor(6*sides/12))}

#module LEAF
#define part=1
#define tilt=0
#define K=12
#define J=3
#define len=42*part*1*math.random(0.96,1.04)
#define wide=34*part*1
#define thick=0.7
#define even=0
#define start=-(30)-tilt+math.random(-3,3)
#define low=4.5+13.5*wilt
#define mid=3.5+10.5*wilt
#define high=27+6*wilt
#define cup=7
#define wave=0
#define fan=55
#define phase=math.random(0,360)
#define finalStep=K+3
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,12)
#define RU1(4,0,0,0,1,0.3*thick,1,2)
#define RU2(4,0,0,0,1,0.3*thick,1,2)
#define RU3(4,0,0,0,1,0.3*thick,1,2)
#define RM1(4,0,0,0,1,0.3*thick,1,12)
#define RM2(4,0,0,0,1,0.3*thick,1,12)
#define RM3(4,0,0,0,1,0.3*thick,1,12)
#define RL1(4,0,0,0,1,0.3*thick,1,22)
#define RL2(4,0,0,0,1,0.3*thick,1,22)
#define RL3(4,0,0,0,1,0.3*thick,1,22)
#define LU1(4,0,0,0,1,0.3*thick,1,2)
#define LU2(4,0,0,0,1,0.3*thick,1,2)
#define LU3(4,0,0,0,1,0.3*thick,1,2)
#define LM1(4,0,0,0,1,0.3*thick,1,12)
#define LM2(4,0,0,0,1,0.3*thick,1,12)
#define LM3(4,0,0,0,1,0.3*thick,1,12)
#define LL1(4,0,0,0,1,0.3*thick,1,22)
#define LL2(4,0,0,0,1,0.3*thick,1,22)
#define LL3(4,0,0,0,1,0.3*thick,1,22)
#material 2 leaf "3c6a33" "558a45" wilted "636a3a" "757742" name "leaf, upper epidermis"
#material 12 leaf "4d7643" "639353" wilted "6c7042" "7a7a48" name "leaf, mesophyll"
#material 22 leaf "5a8050" "6e9b5e" wilted "727548" "7f7e4c" name "leaf, lower epidermis"
#axiom: VEIN(,start,,,,,,)
VEIN{u=even*(step+1)/K+(1-even)*(1-cos(180*(step+1)/K))/2; d=even/K+(1-even)*sin(90/K)*sin(180*(step+1)/K)}{step<K-1}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*d>,0,0,<len*((1-even)*sin(90/K)*sin(180*(step+1.5)/K)+even/K)>,,,)]_{E}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.729+s*(0.061+s*(2.788+s*(8.075+s*(-45.868+s*(51.743+s*(-17.529))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,,H,)]_{C4}[RM1(,f,<cup/2>,,w,,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,,H,)]_{C2}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.729+s*(0.061+s*(2.788+s*(8.075+s*(-45.868+s*(51.743+s*(-17.529))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[LU1(,f,<45-cup/2>,,w,,H,)]_{C6}[LM1(,f,<-cup/2>,,w,,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,,H,)]_{C8}
RU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RU1[RU2(,,<cup+r>,,H,,W,)]_{E}
RM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RM1[RM2(,,<cup+r>,,H,,W,)]_{E}
RL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RL1[RL2(,,<cup+r>,,H,,W,)]_{E}
LU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LU1[LU2(,,<-cup-r>,,H,,W,)]_{E}
LM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LM1[LM2(,,<-cup-r>,,H,,W,)]_{E}
LL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LL1[LL2(,,<-cup-r>,,H,,W,)]_{E}
RU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RU2[RU3(,,<cup+r>,,H,,W,)]_{E}
RM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RM2[RM3(,,<cup+r>,,H,,W,)]_{E}
RL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RL2[RL3(,,<cup+r>,,H,,W,)]_{E}
LU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LU2[LU3(,,<-cup-r>,,H,,W,)]_{E}
LM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LM2[LM3(,,<-cup-r>,,H,,W,)]_{E}
LL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LL2[LL3(,,<-cup-r>,,H,,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

@organ sepal count=5 outline=acicular section=cupped length=7 width=2.5 thickness=0.4 angle=30 bend=0 curl=0 radius=1.7 base=708a4a tip=86a05c@
#module CALYX
#define FOOT(5,180,0,0,1,1,1,1)
#define RING1(10,0,0,0,2.2,3.4,3.4,1)
#define finalStep=2
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[&COROLLA]_{E}
RING1 -> RING1[&SEPAL]_{C2,C4,C6,C8,C10}

#module SEPAL
#define part=1
#define tilt=0
#define K=12
#define J=3
#define len=7*part*(0.55+0.45*open)*math.random(0.96,1.04)
#define wide=2.5*part*(0.55+0.45*open)
#define thick=0.4
#define even=1
#define start=-(30+56*(1-open)-18*wilt)-tilt+math.random(-3,3)
#define low=0*open-22.5*(1-open)+10.8*wilt
#define mid=0*open-17.5*(1-open)+8.4*wilt
#define high=0*open-10*(1-open)+4.8*wilt
#define cup=7
#define wave=0+8*wilt
#define fan=0
#define phase=math.random(0,360)
#define finalStep=K+3
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,13)
#define RU1(4,0,0,0,1,0.3*thick,1,3)
#define RU2(4,0,0,0,1,0.3*thick,1,3)
#define RU3(4,0,0,0,1,0.3*thick,1,3)
#define RM1(4,0,0,0,1,0.3*thick,1,13)
#define RM2(4,0,0,0,1,0.3*thick,1,13)
#define RM3(4,0,0,0,1,0.3*thick,1,13)
#define RL1(4,0,0,0,1,0.3*thick,1,23)
#define RL2(4,0,0,0,1,0.3*thick,1,23)
#define RL3(4,0,0,0,1,0.3*thick,1,23)
#define LU1(4,0,0,0,1,0.3*thick,1,3)
#define LU2(4,0,0,0,1,0.3*thick,1,3)
#define LU3(4,0,0,0,1,0.3*thick,1,3)
#define LM1(4,0,0,0,1,0.3*thick,1,13)
#define LM2(4,0,0,0,1,0.3*thick,1,13)
#define LM3(4,0,0,0,1,0.3*thick,1,13)
#define LL1(4,0,0,0,1,0.3*thick,1,23)
#define LL2(4,0,0,0,1,0.3*thick,1,23)
#define LL3(4,0,0,0,1,0.3*thick,1,23)
#material 3 sepal "708a4a" "86a05c" wilted "7d7a45" "88804b" name "sepal, upper epidermis"
#material 13 sepal "7b9358" "8fa768" wilted "837f4c" "8c8250" name "sepal, mesophyll"
#material 23 sepal "859b62" "97ad71" wilted "888351" "8f8554" name "sepal, lower epidermis"
#axiom: VEIN(,start,,,,,,)
VEIN{u=even*(step+1)/K+(1-even)*(1-cos(180*(step+1)/K))/2; d=even/K+(1-even)*sin(90/K)*sin(180*(step+1)/K)}{step<K-1}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*d>,0,0,<len*((1-even)*sin(90/K)*sin(180*(step+1.5)/K)+even/K)>,,,)]_{E}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.439+s*(-1.399+s*(40.741+s*(-166.743+s*(281.359+s*(-220.101+s*(65.721))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,,H,)]_{C4}[RM1(,f,<cup/2>,,w,,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,,H,)]_{C2}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,0.439+s*(-1.399+s*(40.741+s*(-166.743+s*(281.359+s*(-220.101+s*(65.721))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[LU1(,f,<45-cup/2>,,w,,H,)]_{C6}[LM1(,f,<-cup/2>,,w,,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,,H,)]_{C8}
RU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RU1[RU2(,,<cup+r>,,H,,W,)]_{E}
RM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RM1[RM2(,,<cup+r>,,H,,W,)]_{E}
RL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RL1[RL2(,,<cup+r>,,H,,W,)]_{E}
LU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LU1[LU2(,,<-cup-r>,,H,,W,)]_{E}
LM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LM1[LM2(,,<-cup-r>,,H,,W,)]_{E}
LL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LL1[LL2(,,<-cup-r>,,H,,W,)]_{E}
RU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RU2[RU3(,,<cup+r>,,H,,W,)]_{E}
RM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RM2[RM3(,,<cup+r>,,H,,W,)]_{E}
RL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RL2[RL3(,,<cup+r>,,H,,W,)]_{E}
LU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LU2[LU3(,,<-cup-r>,,H,,W,)]_{E}
LM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LM2[LM3(,,<-cup-r>,,H,,W,)]_{E}
LL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LL2[LL3(,,<-cup-r>,,H,,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

@organ petal count=5 whorls=1 symmetry=irregular lip=32 outline=obovate section=wavy length=15 width=11 thickness=0.5 angle=30 bend=10 curl=25 veins=5 radius=1.9 base=efe3a0 tip=6a4fb0@
#module COROLLA
#define FOOT(5,180,0,0,1,1,1,4)
#define RING1(10,0,0,0,2.2,3.8,3.8,4)
#define finalStep=2
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[&ANDROECIUM]_{E}
RING1 -> RING1[&PETAL{part=1.32; tilt=-22}]_{C1}
RING1 -> RING1[&PETAL{part=1.099; tilt=-6.798}]_{C3,C9}
RING1 -> RING1[&PETAL{part=0.741; tilt=17.798}]_{C5,C7}

#module PETAL
#define part=1
#define tilt=0
#define K=12
#define J=3
#define len=15*part*(0.55+0.45*open)*math.random(0.96,1.04)
#define wide=11*part*(0.55+0.45*open)
#define thick=0.5
#define even=0
#define start=-(30+56*(1-open)-18*wilt)-tilt+math.random(-3,3)
#define low=4.5*open-22.5*(1-open)+10.8*wilt
#define mid=3.5*open-17.5*(1-open)+8.4*wilt
#define high=27*open-10*(1-open)+4.8*wilt
#define cup=4
#define wave=14+8*wilt
#define fan=0
#define phase=math.random(0,360)
#define finalStep=K+3
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,14)
#define RU1(4,0,0,0,1,0.3*thick,1,4)
#define RU2(4,0,0,0,1,0.3*thick,1,4)
#define RU3(4,0,0,0,1,0.3*thick,1,4)
#define RM1(4,0,0,0,1,0.3*thick,1,14)
#define RM2(4,0,0,0,1,0.3*thick,1,14)
#define RM3(4,0,0,0,1,0.3*thick,1,14)
#define RL1(4,0,0,0,1,0.3*thick,1,24)
#define RL2(4,0,0,0,1,0.3*thick,1,24)
#define RL3(4,0,0,0,1,0.3*thick,1,24)
#define LU1(4,0,0,0,1,0.3*thick,1,4)
#define LU2(4,0,0,0,1,0.3*thick,1,4)
#define LU3(4,0,0,0,1,0.3*thick,1,4)
#define LM1(4,0,0,0,1,0.3*thick,1,14)
#define LM2(4,0,0,0,1,0.3*thick,1,14)
#define LM3(4,0,0,0,1,0.3*thick,1,14)
#define LL1(4,0,0,0,1,0.3*thick,1,24)
#define LL2(4,0,0,0,1,0.3*thick,1,24)
#define LL3(4,0,0,0,1,0.3*thick,1,24)
#material 4 petal "efe3a0" "6a4fb0" veins "412854" 5 0.35 bud "aab167" "7c767f" wilted "bda770" "7d5f6d" name "petal, upper epidermis"
#material 14 petal "eee3a5" "765eb3" bud "aab168" "827d81" wilted "bca773" "82656e" name "petal, mesophyll"
#material 24 petal "ede4a9" "806ab6" bud "aab269" "878382" wilted "bca775" "866a6f" name "petal, lower epidermis"
#axiom: VEIN(,start,,,,,,)
VEIN{u=even*(step+1)/K+(1-even)*(1-cos(180*(step+1)/K))/2; d=even/K+(1-even)*sin(90/K)*sin(180*(step+1)/K)}{step<K-1}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*d>,0,0,<len*((1-even)*sin(90/K)*sin(180*(step+1.5)/K)+even/K)>,,,)]_{E}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,-0.001+s*(0.045+s*(1.426+s*(23.712+s*(-56.479+s*(38.513+s*(-7.221))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,,H,)]_{C4}[RM1(,f,<cup/2>,,w,,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,,H,)]_{C2}
VEIN{s=(step+0.5)/K; w=wide/2/J*max(0.004,-0.001+s*(0.045+s*(1.426+s*(23.712+s*(-56.479+s*(38.513+s*(-7.221))))))); f=fan*max(0,1-4*s)}{}{} -> VEIN[LU1(,f,<45-cup/2>,,w,,H,)]_{C6}[LM1(,f,<-cup/2>,,w,,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,,H,)]_{C8}
RU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RU1[RU2(,,<cup+r>,,H,,W,)]_{E}
RM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RM1[RM2(,,<cup+r>,,H,,W,)]_{E}
RL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> RL1[RL2(,,<cup+r>,,H,,W,)]_{E}
LU1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LU1[LU2(,,<-cup-r>,,H,,W,)]_{E}
LM1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LM1[LM2(,,<-cup-r>,,H,,W,)]_{E}
LL1{r=wave*1/J*sin(900*(step-1)/K+phase)}{}{} -> LL1[LL2(,,<-cup-r>,,H,,W,)]_{E}
RU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RU2[RU3(,,<cup+r>,,H,,W,)]_{E}
RM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RM2[RM3(,,<cup+r>,,H,,W,)]_{E}
RL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> RL2[RL3(,,<cup+r>,,H,,W,)]_{E}
LU2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LU2[LU3(,,<-cup-r>,,H,,W,)]_{E}
LM2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LM2[LM3(,,<-cup-r>,,H,,W,)]_{E}
LL2{r=wave*2/J*sin(900*(step-2)/K+phase)}{}{} -> LL2[LL3(,,<-cup-r>,,H,,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

@organ stamen count=5 whorls=1 attachment=basifixed length=1.5 thickness=0.4 anther=1.6 angle=80 bend=-10 radius=1.4 base=e2d58a tip=d78a2a@
#module ANDROECIUM
#define FOOT(5,180,0,0,1,1,1,6)
#define RING1(10,0,0,0,2.2,2.8,2.8,6)
#define finalStep=2
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[&GYNOECIUM]_{E}
RING1 -> RING1[&STAMEN]_{C2,C4,C6,C8,C10}

#module STAMEN
#define part=1
#define tilt=0
#define long=1.5*part*(0.6+0.4*open)*math.random(0.94,1.06)
#define head=1.6*math.random(0.95,1.05)
#define FILAMENT(6,0,0,0,long/8,0.4,0.4,6)
#define JOINT(4,0,0,0,0.4,0.4,0.4,7)
#define ANTHER(4,0,0,0,head/5,0.4,0.4,7)
#define finalStep=14
#material 6 stamen "e2d58a" "e2d58a"
#material 7 stamen "d78a2a" "d78a2a"
#axiom: FILAMENT(,<-(80+(85-80)*(1-open))-tilt+math.random(-4,4)>,,,,,,)
FILAMENT{}{step<7}{} -> FILAMENT[FILAMENT(,<-10/7>,,,,,,)]_{E}
FILAMENT{}{step==7}{} -> FILAMENT[JOINT]_{E}
JOINT -> JOINT[ANTHER]_{E}
ANTHER{k=step-8}{step>7&&step<13}{} -> ANTHER[ANTHER(,0,,,,<0.4*(1.9-0.1*(k-2)^2)>,<0.4*(1.5-0.1*(k-2)^2)>,)]_{E}

@organ pistil count=3 fusion=syncarpous length=3 width=1.8 style=1.4 stigma=0.9 angle=60 radius=1 base=a7b868 tip=d8d79a@
#module GYNOECIUM
#define FOOT(5,180,0,0,1,1,1,8)
#define RING1(10,0,0,0,2.2,2,2,8)
#define finalStep=2
#axiom: FOOT
FOOT -> FOOT[RING1(,180,,,,,,)]_{E}
RING1 -> RING1[&PISTIL]_{E}

#module PISTIL
#define wide=1.8*1
#define OVARY(12,0,0,0,3/6,wide*0.7,wide*0.7,8)
#define STYLE(12,0,0,0,1.4*(0.7+0.3*open)/4,wide*0.3,wide*0.3,8)
#define STIGMA(12,0,0,0,0.9/4,0.9*0.6,0.9*0.6,9)
#define LOBE(4,0,0,0,0.9/5,0.9/5,0.9/5,9)
#define finalStep=15
#material 8 pistil "a7b868" "a7b868"
#material 9 pistil "d8d79a" "d8d79a"
#axiom: OVARY(,0,,,,,,)
OVARY{}{step<5}{} -> OVARY[OVARY(,0,,,,<wide*(0.55+0.45*sin(36*(step+1)))>,<wide*(0.55+0.45*sin(36*(step+1)))>,)]_{E}
OVARY{}{step==5}{} -> OVARY[STYLE]_{E}
STYLE{}{step<9}{} -> STYLE[STYLE]_{E}
STYLE{}{step==9}{} -> STYLE[STIGMA]_{E}
STIGMA -> STIGMA[LOBE]_{C1,C5,C9}
LOBE{}{step>10&&step<13}{} -> LOBE[LOBE(,20,,,,,,)]_{E}

`,
	"double-umbel": `/* Double umbel
   about: An umbel of umbels: wild carrot, with the dark floret in the midst of its lace.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=160 /* 80 … 250 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define tall=length*math.random(0.88,1.12)
#define rays=floor(math.random(15,20))
#define broad=math.random(44,54)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define STEM(13,0,0,0,20,4,4,1)
#define OLD(13,0,0,0,20,4,4,1)
#define HEAD(13,0,0,-0.954,0.16,4.6,4.6,1)
#define BARE(13,0,0,0,0,4,4,1)
#define finalStep=14+rays

#material 1 stem "7d9a58" "8fab68"
#material 2 leaf "4a7a3a" "639a4c"
#material 3 sepal "6f9450" "86a862"
#material 4 petal "f4f5ea" "ffffff" bud "d9dfc0" "e6ead4" wilted "b9b58a" "a8a070"
#material 5 petal "5a1226" "7a1f38"

#axiom: STEM
STEM{}{step<12}{} -> OLD[STEM(,<bend+math.random(-2,2)+1.5*wilt>,<math.random(-2,2)>,,<tall/12>,<4-0.1*step>,<4-0.1*step>,)]_{E}
STEM{}{step==1||step==4||step==8}{} -> STEM[&FERN{len=84-6*step}]_{C(1+(5*step)%13)}
STEM{}{step==12}{} -> STEM[HEAD]_{E}
HEAD{}{step==13}{} -> HEAD[&BLADE{S=4; len=24; wide=1.2; thick=0.6; start=-50+64*open; bend=20; claw=0.9; paint=3}]_{C2,C3,C5,C7,C9,C11,C13}
/* Rays on the outside are longer and lean further; in bud and in fruit they close to a nest. */
HEAD{q=(step-13)/rays; shut=max(1-open,wilt)}{step<finalStep-1}{} -> BARE[HEAD(,,,,<0.14>,<4.6*sqrt(1-0.9*q)>,<4.6*sqrt(1-0.9*q)>,)]_{E}[&RAY{start=-88+(72-66*q)*(1-shut)+math.random(-4,4); long=broad*(0.5+0.5*open)*(1-0.42*q+0.12*(q>0.93))*math.random(0.94,1.04); open=open; florets=12-6*q; dark=step==finalStep-2}]_{C(1+(5*step)%13)}

#module RAY
#define start=0
#define long=30
#define open=1
#define florets=12
#define dark=0
#define RIB(8,0,0,0,long/4,0.8,0.8,1)
#define HUB(8,0,0,2.508,0.1,1.3,1.3,1)
#define DONE(8,0,0,0,0.1,1.3,1.3,1)
#define finalStep=19
#axiom: RIB(,start,,,,,,)
RIB{}{step<3}{} -> RIB[RIB(,<-start*0.02-5+math.random(-3,3)>,<math.random(-3,3)>,,,,,)]_{E}
RIB{}{step==3}{} -> RIB[HUB]_{E}
HUB{q=(step-4)/florets}{q<1}{} -> DONE[HUB(,,,,0.1,<1.3*sqrt(1-0.9*q)>,<1.3*sqrt(1-0.9*q)>,)]_{E}[&FLORET{start=-86+(64-60*q)*open+math.random(-6,6); long=(3+5*open)*(1-0.4*q); open=open; paint=4+dark*(q>0.85); big=1.7-0.6*q}]_{C(1+(3*step)%8)}

#module FLORET
#define start=0
#define long=6
#define open=1
#define paint=4
#define big=1
#define STALK(5,0,0,0,long,0.35,0.35,1)
#define CUP(5,0,0,0,0.5,0.7,0.7,3)
#define finalStep=4
#axiom: STALK(,start,,,,,,)
STALK -> STALK[CUP]_{E}
CUP -> CUP[&BLADE{S=2; len=big*(0.5+1.5*open); wide=big*(0.5+1.1*open); thick=0.25; start=-80+76*open+math.random(-12,12); bend=10; claw=0.5; blunt=0.7; paint=paint}]_{C1,C2,C3,C4,C5}

#module FERN
/* A leaf that is cut fine: ribs on a rib. */
#define len=80
#define RIB(8,0,0,0,len/9,1.2,1.1,2)
#define finalStep=10
#axiom: RIB(,<-44+math.random(-8,8)>,<math.random(-8,8)>,,,,,)
RIB{}{step<8}{} -> FAR[RIB(,<3+math.random(-3,3)>,<math.random(-3,3)>,,,,,)]_{E}
RIB{p=sin(180*((step+1)/10)^1.2)}{step>1&&step<9}{} -> RIB[&FROND{len=len*0.36*p; turn=-90}]_{C3}[&FROND{len=len*0.36*p; turn=90}]_{C7}
RIB{}{step==8}{} -> RIB[&FROND{len=len*0.2}]_{E}
#define FAR(8,0,0,0,1,1.2,1.1,2)

#module FROND
#define len=30
#define turn=0
#define R(4,0,0,0,len/4,0.9,0.7,2)
#define finalStep=5
#axiom: R(,<-28*(turn!=0)+math.random(-8,8)>,,turn,,,,)
R{}{step<3}{} -> R[R(,<math.random(-4,8)>,,,,,,)]_{E}
R{}{step<4}{} -> R[&BLADE{S=2; len=len*(0.4-0.06*step); wide=len*0.06; thick=0.5; start=-40; claw=1; blunt=0.5; paint=2}]_{C2,C4}

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}
`,
	"figure-16": `/* Figure 16
   about: A grammar in a grammar: sepals, petals, stamens and a carpel are modules of a flower of eighteen sides.
   source: Petrenko 2014, figure 16, in full; its four modules are only named there and are ours
*/
#define STEM
#define STEMS
#define BASE
#define PETAL
#define STAMEN
#define BASEC
#define CARPEL

#axiom : STEM

(p1) STEM -> STEM[STEMS(18)]E
(p2) STEMS -> STEMS[&SEPAL(4)]C1,C4,C7,C10,C13,C16
(p3) STEMS -> STEMS[BASE(18)]E
(p4) BASE -> BASE[&PETAL(4)]C2,C5,C8,C11,C14,C17
(p5) BASE -> BASE[&STAMEN(4)]C3,C6,C9,C12,C15,C18
(p6) BASE -> BASE[BASEC(18)]E
(p7) BASEC -> BASE[&CARPEL(6)]E

#define finalStep=5

#module SEPAL
#define S(4,0,0,0,1,0.8,0.2,2)
#define finalStep=6
#axiom: S
S -> S[S(,10,,,1.2,0.4+sin(26*step),0.15,)]_{E}

#module PETAL
#define P(4,0,0,0,1.5,1,0.2,3)
#define finalStep=8
#axiom: P
P -> P[P(,6-2*step,,,1.6,0.6+1.6*sin(20*step),0.12,)]_{E}

#module STAMEN
#define FILAMENT(4,0,0,0,1.5,0.2,0.2,4)
#define ANTHER(4,0,0,0,0.8,0.5,0.5,5)
#define finalStep=6
#axiom: FILAMENT
FILAMENT{ }{step<5}{ } -> FILAMENT[FILAMENT(,9,,,1.2,,,)]_{E}
FILAMENT{ }{step==5}{ } -> FILAMENT[ANTHER]_{E}

#module CARPEL
#define OVARY(6,0,0,0,1,1.5,1.5,6)
#define finalStep=8
#axiom: OVARY
OVARY -> OVARY[OVARY(,,,,0.8,0.4+0.25*(step-4)^2/4,0.4+0.25*(step-4)^2/4,)]_{E}
`,
	globeflower: `/* Globeflower
   about: Ten sepals, yellow as petals, close to a globe round nectaries and stamens; leaves of five lobes.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=290 /* 140 … 450 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1.35 /* 0.7 … 1.6, of the flower */
#define tall=length*math.random(0.83,1.17)
#define size=scale*math.random(0.92,1.08)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define STEM(10,0,0,0,20,3,3,1)
#define LOWER(10,0,0,0,3,3.2,3.2,1)
#define UPPER(10,0,0,0,3,3,3,1)
#define WHORL(10,0,0,0,1.5,5,5,4)
#define SECOND(10,0,0,12,1.3,4.7,4.7,4)
#define THIRD(10,0,0,24,1.2,4.4,4.4,4)
#define NECTAR(10,0,0,0,0.7,4.2,4.2,5)
#define RING(10,0,0,11,0.6,3.8,3.8,8)
#define HEART(10,0,0,11,0.6,3.6,3.6,8)
#define finalStep=28

#material 1 stem "6f9150" "7f9f5c"
#material 2 leaf "3f7038" "578c45" veins "6fa052" 4 0.45 feathered name "leaf, upper epidermis"
#material 12 leaf "4c7d40" "62944d" name "leaf, mesophyll"
#material 13 leaf "5e8554" "749a62" name "leaf, lower epidermis"
#material 4 petal "cfc828" "f6e41c" foot 0.35 veins "dcc414" 6 0.25 bud "8fa032" "b4b636" wilted "d8b040" "d9b566" name "sepal, upper epidermis"
#material 9 petal "c0c030" "ecd820" foot 0.35 bud "88983a" "a8b03a" wilted "cca844" "ceae64" name "sepal, mesophyll"
#material 10 petal "a8b83c" "f2e02a" foot 0.6 veins "ccc02a" 6 0.25 bud "87a03c" "a6b23e" wilted "c4aa4c" "d4b468" name "sepal, lower epidermis"
#material 5 petal "d8b81c" "f0c812" bud "8fa032" "b4b636" wilted "cfa63a" "cda456" name "nectary"
#material 6 stamen "dcc030" "e3c838"
#material 7 stamen "e0a818" "eab524"
#material 8 pistil "a8b548" "b9c455"

#axiom: STEM
STEM{}{step<14&&step!=6&&step!=9}{} -> STEM[STEM(,<bend+math.random(-1.4,1.4)+0.6*wilt>,<math.random(-1.4,1.4)>,,<tall*(0.8+0.2*open)/13>,<3.2-0.04*step>,<3.2-0.04*step>,)]_{E}
STEM{}{step==6}{} -> STEM[LOWER]_{E}
STEM{}{step==9}{} -> STEM[UPPER]_{E}
LOWER -> LOWER[STEM(,,,,<tall*(0.8+0.2*open)/13>,3,3,)]_{E}
UPPER -> UPPER[STEM(,,,,<tall*(0.8+0.2*open)/13>,2.9,2.9,)]_{E}
STEM{}{step==0}{} -> STEM[&PALMATE{stalk=math.random(110,160); len=math.random(46,58); start=-60+math.random(-10,10); sway=math.random(-12,12); teeth=0.45}]_{C1,C4,C8}
LOWER -> LOWER[&PALMATE{stalk=10; len=math.random(38,50); start=-34; teeth=0.45}]_{C3}
UPPER -> UPPER[&PALMATE{stalk=6; len=math.random(26,34); start=-40; teeth=0.45}]_{C8}
STEM{}{step==14}{} -> STEM[WHORL(,<10*open>,,,,,,)]_{E}
WHORL -> WHORL[SECOND]_{E}
WHORL -> WHORL[&PETAL{K=9; J=3; kept=1-0.97*clamp((wilt-math.random(0.5,0.75))/0.28,0,1); len=size*(14+13*open)*math.random(0.95,1.04); wide=size*(11+11*open); thick=0.6; start=-30+20*open+math.random(-4,4)+34*wilt; low=-48-4*open+18*wilt; mid=-22+16*wilt; high=-66+10*open+20*wilt+math.random(-6,6); cup=17-3*open; wave=4; peak=1.08; foot=0.9; tip=0.7; claw=0.3; upper=4; middle=9; lower=10}]_{C1,C4,C8}
SECOND -> SECOND[THIRD]_{E}
SECOND -> SECOND[&PETAL{K=9; J=3; kept=1-0.97*clamp((wilt-math.random(0.55,0.9))/0.28,0,1); len=size*(13+12*open)*math.random(0.95,1.04); wide=size*(11+10*open); thick=0.6; start=-36+18*open+math.random(-4,4)+24*wilt; low=-46-4*open+12*wilt; mid=-24+12*wilt; high=-64+14*open+14*wilt+math.random(-6,6); cup=17-2*open; wave=4; peak=1.08; foot=0.9; tip=0.7; claw=0.3; upper=4; middle=9; lower=10}]_{C2,C6,C9}
THIRD -> THIRD[NECTAR]_{E}
THIRD -> THIRD[&PETAL{K=9; J=3; kept=1-0.97*clamp((wilt-math.random(0.6,1))/0.28,0,1); len=size*(12+12*open)*math.random(0.95,1.04); wide=size*(10+10*open); thick=0.6; start=-42+16*open+math.random(-4,4)+12*wilt; low=-44-4*open+8*wilt; mid=-24+8*wilt; high=-64+8*open+10*wilt+math.random(-6,6); cup=18-2*open; wave=4; peak=1.08; foot=0.9; tip=0.7; claw=0.3; upper=4; middle=9; lower=10}]_{C1,C3,C6,C8}
NECTAR -> NECTAR[RING]_{E}
NECTAR -> NECTAR[&BLADE{len=size*(4+4*open); wide=1.6; thick=0.5; start=-60+math.random(-5,5); bend=-12; peak=1.2; round=0.6; claw=0.6; paint=5}]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10}
RING{}{step<22}{} -> RING[RING]_{E}
RING{}{step==22}{} -> RING[HEART]_{E}
RING -> RING[&STAMEN{long=(1.2+5.8*open)*math.random(0.85,1.1); lean=-62+math.random(-8,8); head=1.9}]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10}
HEART{}{step<27}{} -> HEART[HEART(,,,,0.8,<3.6-0.5*(step-22)>,<3.6-0.5*(step-22)>,)]_{E}
HEART -> HEART[&BLADE{S=2; len=2; wide=0.9; thick=0.6; start=-70; claw=0.8; blunt=0.3; paint=8}]_{C1,C3,C5,C7,C9}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 3 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define kept=1      /* how much of it is left: it withers, hangs and falls */
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,kept*len*sin(90/K)^2,kept*thick,kept*thick,middle)
#define RU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#axiom: VEIN(,start+50*(1-kept),sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<kept*len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<kept*thick*max(0.25,1-u^3)>,<kept*thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RU2[RU3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RM2[RM3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RL2[RL3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LU2[LU3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LM2[LM3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LL2[LL3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}

#module STAMEN
#define long=5
#define lean=-50
#define head=1.6
#define FILAMENT(4,0,0,0,long/4,0.3,0.3,6)
#define ANTHER(4,0,0,0,head/2,0.75*head/1.6,0.5*head/1.6,7)
#define finalStep=6
#axiom: FILAMENT(,lean,,,,,,)
FILAMENT{}{step<3}{} -> FILAMENT[FILAMENT(,<-lean*0.12-8>,,,,,,)]_{E}
FILAMENT{}{step==3}{} -> FILAMENT[ANTHER]_{E}
ANTHER{}{step<5}{} -> ANTHER[ANTHER]_{E}

#module PALMATE
/* A leaf of five lobes that spread from the end of its stalk. */
#define stalk=60
#define len=30
#define start=0
#define sway=0
#define teeth=0.4
#define PETIOLE(8,0,0,0,stalk/8,1.3,1.3,1)
#define NODE(8,0,0,0,0.6,1.3,1.3,1)
#define LAST(8,0,0,0,0.6,1.3,1.3,1)
#define finalStep=12
#axiom: PETIOLE(,start,sway,,,,,)
PETIOLE{}{step<7}{} -> PETIOLE[PETIOLE(,<4+math.random(-3,3)>,<math.random(-4,4)>,,,,,)]_{E}
PETIOLE{}{step==7}{} -> PETIOLE[NODE(,<16>,,,,,,)]_{E}
NODE -> NODE[LAST]_{E}
NODE -> NODE[&PETAL{K=12; J=2; len=len*0.72; wide=len*0.58; thick=0.5; start=6; roll=-90; low=-12; cup=5; peak=1.7; foot=1.3; tip=0.8; claw=0.1; teeth=teeth; bites=4; barb=-26; upper=2; middle=12; lower=13}]_{C3}[&PETAL{K=12; J=2; len=len*0.72; wide=len*0.58; thick=0.5; start=6; roll=90; low=-12; cup=5; peak=1.7; foot=1.3; tip=0.8; claw=0.1; teeth=teeth; bites=4; barb=-26; upper=2; middle=12; lower=13}]_{C7}
LAST -> LAST[&PETAL{K=12; J=2; len=len*0.93; wide=len*0.62; thick=0.5; start=-42; roll=-90; low=-12; cup=5; peak=1.7; foot=1.3; tip=0.8; claw=0.1; teeth=teeth; bites=4; barb=-26; upper=2; middle=12; lower=13}]_{C3}[&PETAL{K=12; J=2; len=len*0.93; wide=len*0.62; thick=0.5; start=-42; roll=90; low=-12; cup=5; peak=1.7; foot=1.3; tip=0.8; claw=0.1; teeth=teeth; bites=4; barb=-26; upper=2; middle=12; lower=13}]_{C7}[&PETAL{K=12; J=2; len=len; wide=len*0.64; thick=0.5; low=12; cup=5; peak=1.7; foot=1.3; tip=0.8; claw=0.1; teeth=teeth; bites=4; barb=-26; upper=2; middle=12; lower=13}]_{E}
`,
	grass: `/* Grass
   about: A tuft of thirteen blades that bow outwards: what stands between the flowers of a bed.
   source: own text
*/

#define length=120 /* 30 … 400 mm, of the blades */
#define bow=45 /* 0 … 120 degrees, over a blade */
#define tall=length*math.random(0.8,1.2)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

/* Five faces on of thirteen are 138.46 degrees, and each is turned back by 0.954. */
#define TUFT(13,0,0,-0.954,0.4,2.4,2.4,1)
#define GROWN(13,0,0,0,0.4,2.4,2.4,1)
#define finalStep=14

#material 1 stem "8f9a5c" "7d9a4a"
#material 2 leaf "5d7f3a" "83a04c" light 0.4 wilted "a89a5a" "c2ad6c"

#axiom: TUFT
TUFT{k=step/13}{step<13}{} -> GROWN[TUFT]_{E}[&BLADE{len=tall*(0.5+0.5*open)*math.random(0.6,1)*(0.75+0.25*k); wide=math.random(2.2,3.6); start=-58-24*k+math.random(-9,9); sway=math.random(-20,20); bend=bow*math.random(0.3,1); high=bow*math.random(0,1)+50*wilt}]_{C(1+(5*step)%13)}

#module BLADE
#define S=7
#define len=80     /* mm */
#define wide=3
#define start=-70  /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define bend=20    /* over all of it */
#define high=20    /* more of it towards the tip */
#define finalStep=12
#define B(4,0,0,0,len/S,wide*0.7,0.5,2)
#axiom: B(,start,sway,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(0.08,(1-s^3)*(0.7+0.6*s))>,,)]_{E}
`,
	lily: `/* Lily
   about: A few white trumpets, six tepals each, with golden anthers hung by their backs; narrow leaves all up the stem.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=530 /* 280 … 840 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1.98 /* 1.4 … 2.6, of the flower */
#define tall=length*math.random(0.87,1.13)
#define size=scale*math.random(0.95,1.05)
#define flowers=floor(math.random(2,4))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define STEM(8,0,0,2.508,20,7,7,1)
#define LEAFY(8,0,0,0,20,7,7,1)
#define NODE(8,0,0,2.508,20,6,6,1)
#define DONE(8,0,0,0,20,6,6,1)
#define finalStep=18+flowers

#material 1 stem "6f8f52" "83a263"
#material 2 leaf "47793d" "639550" veins "8ab472" 3 0.4 name "leaf, upper epidermis"
#material 12 leaf "58884a" "71a05c" name "leaf, mesophyll"
#material 13 leaf "658f58" "7ca568" name "leaf, lower epidermis"
#material 4 petal "ccd9a4" "eef1f4" foot 0.45 veins "cfdbb4" 4 0.5 light 0.25 bud "a9c070" "dbe3b8" wilted "e3d2a0" "c9a66c" name "tepal, upper epidermis"
#material 10 petal "a8c272" "dfe6d2" foot 0.8 light 0.25 bud "96b45e" "c4d49c" wilted "d0c48c" "c09c64" name "tepal, mesophyll"
#material 5 petal "b7cc80" "e6eae6" foot 0.75 veins "b4cc86" 1 0.7 light 0.25 bud "a2ba68" "d0dcaa" wilted "d8c490" "b8935c" name "tepal, lower epidermis"
#material 6 stamen "dfe6c0" "eef0dc"
#material 7 stamen "dd8a14" "eda21e"
#material 8 pistil "9ab66a" "dfe4b8"
#material 9 pistil "8aa858" "a8bd70"

#axiom: STEM
STEM{}{step<16}{} -> LEAFY[STEM(,<bend+math.random(-1,1)>,<math.random(-1,1)>,,<tall/16>,<7-0.12*step>,<7-0.12*step>,)]_{E}[&PETAL{K=8; J=1; len=(165-5*step)*math.random(0.9,1.1); wide=(16-0.4*step)*math.random(0.9,1.1); thick=0.9; start=-40+step+math.random(-8,8); low=14; mid=16; high=math.random(0,30); cup=9; peak=0.75; foot=0.5; tip=1.5; claw=0.5; upper=2; middle=12; lower=13}]_{C(1+(3*step)%8),C(1+(3*step+4)%8)}
STEM{}{step==16}{} -> LEAFY[NODE]_{E}
/* Flowers stand close together about the stem's end: what is beyond the last is a stub. */
NODE{k=step-17}{step<finalStep-1}{} -> DONE[NODE(,<math.random(-3,3)>,<math.random(-3,3)>,,<1.5+(24-3*k)*(k<flowers-1)>,<5-0.5*k-1.5*(k>flowers-2)>,<5-0.5*k-1.5*(k>flowers-2)>,)]_{E}[&FLOWER{open=min(1,max(0,open*1.45-0.14*k)); wilt=wilt; size=size; stalk=math.random(52,66)-3*k; start=-50+8*k+math.random(-6,6)}]_{C(1+(3*step+4)%8)}

#module FLOWER
#define open=1
#define wilt=0
#define size=1
#define stalk=36
#define start=-40
#define STALK(12,0,0,0,stalk/6,3.4,3.4,1)
#define WHORL(12,0,0,0,2.6,9,9,4)
#define INNER(12,0,0,0,2.4,8,8,4)
#define TOP(12,0,0,0,2,6.4,6.4,8)
#define finalStep=10
#axiom: STALK(,start,,,,,,)
STALK{}{step<5}{} -> STALK[STALK(,<7+3*open+math.random(-2,2)>,<math.random(-3,3)>,,,,,)]_{E}
STALK{}{step==5}{} -> STALK[WHORL]_{E}
WHORL -> WHORL[INNER]_{E}
WHORL -> WHORL[&PETAL{K=10; J=2; len=size*(48+24*open); wide=size*(9+9*open); thick=0.8; start=-80+4*open+20*wilt; low=2; mid=-14-2*open+10*wilt; high=-30+118*open+math.random(-10,10); cup=40-28*open; edge=-6*open; wave=4+8*wilt; peak=1.05; foot=0.8; tip=1.7; claw=0.36; upper=4; middle=10; lower=5}]_{C1,C5,C9}
INNER -> INNER[TOP]_{E}
INNER -> INNER[&PETAL{K=10; J=2; len=size*(48+23.5*open); wide=size*(9+10.5*open); thick=0.8; start=-82+4*open+18*wilt; low=2; mid=-14-2*open+10*wilt; high=-30+114*open+math.random(-10,10); cup=40-28*open; edge=-6*open; wave=4+8*wilt; peak=1.02; foot=0.8; tip=1.6; claw=0.36; upper=4; middle=10; lower=5}]_{C3,C7,C11}
TOP -> TOP[&STAMEN{long=size*(20+23*open); lean=-90+7*open+math.random(-3,3); open=open}]_{C1,C3,C5,C7,C9,C11}
TOP -> TOP[&PISTIL{long=size*(28+36.3*open)}]_{E}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 2 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<thick*max(0.25,1-u^3)>,<thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2

#module STAMEN
#define long=50
#define lean=-70
#define open=1
#define FILAMENT(4,0,0,0,long/8,1.6,1.6,6)
#define HINGE(4,0,0,0,0.8,0.9,0.9,6)
#define ANTHER(4,0,0,0,2,3,2.4,7)
#define finalStep=12
#axiom: FILAMENT(,lean,,,,,,)
FILAMENT{}{step<7}{} -> FILAMENT[FILAMENT(,<2*open>,,,,<1.6-0.1*step>,<1.6-0.1*step>,)]_{E}
FILAMENT{}{step==7}{} -> FILAMENT[HINGE]_{E}
HINGE -> HINGE[ANTHER(,<-84+80*open>,,,,,,)]_{C3}[ANTHER(,<-84+80*open>,,,,,,)]_{C1}
ANTHER{}{step<11}{} -> ANTHER[ANTHER(,,,,<1+1.8*open>,<(3.8-0.5*(step-8))*(0.5+0.5*open)>,<(3-0.4*(step-8))*(0.5+0.5*open)>,)]_{E}

#module PISTIL
#define long=60
#define OVARY(6,0,0,0,long/12,4.6,4.6,9)
#define STYLE(6,0,0,0,long/14,2.4,2.4,8)
#define STIGMA(6,0,0,0,3,6,6,9)
#define finalStep=13
#axiom: OVARY
OVARY{}{step<3}{} -> OVARY[OVARY]_{E}
OVARY{}{step==3}{} -> OVARY[STYLE]_{E}
STYLE{}{step<10}{} -> STYLE[STYLE]_{E}
STYLE{}{step==10}{} -> STYLE[STIGMA]_{E}
STIGMA{}{step<12}{} -> STIGMA[STIGMA(,,,,2,4,4,)]_{E}
`,
	meadow: `/* Meadow
   about: A ground of volumes, grown and glued like a petal, on whose tops seeds are sown by luck: each is a module of its own, grass or one of five flowers, in drifts of their kind.
   source: Petrenko 2014, figure 24, whose grammar is not printed; the text is ours
*/

#define across=20 /* 4 … 60 step 2, volumes of ground */
#define flowers=1 /* 0 … 3 step 0.1, how many */
#define height=1 /* 0.5 … 1.6 step 0.05, of all that grows */
#define wind=0 /* -1 … 1 step 0.05 */

#define reach=across/2
#define fall=26 /* degrees, at the margin */
#define finalStep=across+reach+2
/* Where drifts of a kind lie is luck, and the same for all seeds. */
#define here=math.random(0,360)
#define there=math.random(0,360)
#define elsewhere=math.random(0,360)
#define hill=math.random(0,360)
#define dale=math.random(0,360)

#define SPINE(4,0,0,0,38,38,12,1)
#define RIGHT(4,0,0,0,38,12,38,1)
#define LEFT(4,0,0,0,38,12,38,1)

#material 1 stem "363a1c" "3a3f1f"
#material 2 leaf "35511f" "7d9c42" foot 0.8
#material 3 leaf "3b5a24" "93ad4e" foot 0.8
#material 4 leaf "2f4a20" "6a8f45" foot 0.8
#material 5 leaf "6f6a38" "b7a866" foot 0.7
#material 6 stem "5f7f3e" "83a055"
#material 7 leaf "476b31" "6f9448"
#material 8 petal "1d0d10" "d4271b" foot 0.3 veins "9c130f" 7 0.25 bud "3a1014" "b83024" wilted "1d0d10" "8e1f22"
#material 9 pistil "7f9463" "a5b88a"
#material 10 stamen "221b2a" "3c3148"
#material 11 petal "f3f1ea" "ffffff" bud "e6e8d0" "eef0e0" wilted "d8cdb8" "b9a68c"
#material 12 stamen "c98a12" "edb91f"
#material 13 petal "d9a800" "f7d21c" foot 0.4 bud "9aa23c" "c9b62c" wilted "b8922c" "a8843a"
#material 14 petal "27348c" "4a67d8" foot 0.5 bud "39407a" "4a55a0" wilted "7a86b8" "a4a8c0"
#material 15 petal "4c2a80" "6a3fa0"
#material 16 sepal "4f6a3c" "5d7a48"
#material 17 petal "b0568e" "c96fa6" bud "8a6a7a" "a8638c" wilted "9a7468" "8a6a58"
#material 18 seed "a08d5a" "b9a070"

#axiom: SPINE(,<90-fall>,,,,,,)
/* A vein of volumes, towards the one who looks; rows to its right and left, as wide as a circle has them there. It falls off to its margin. */
SPINE{t=2*along/across-1; u=2*(along+1)/across-1}{along<across-1}{} -> SPINE[SPINE(,<fall*(u^5-t^5)+4*(sin(31*(along+1)+dale)-sin(31*along+dale))>,,,,38,<12-9*u^8>,)]_{E}
SPINE{c=along-reach+0.5; p=hill+19*along}{reach*reach-c*c>1}{} -> SPINE[RIGHT(,,<4*sin(p+24)>,,,,,)]_{C2}[LEFT(,,<-4*sin(24-p)>,,,,,)]_{C4}
SPINE -> SPINE[&SOW{x=along-reach+0.5}]_{C3}
RIGHT{c=along-reach+0.5; w=sqrt(max(0,reach*reach-c*c)); p=hill+19*along; q=(beside+1)/w}{beside+1<w+0.6*sin(103*along+dale)-0.2}{} -> RIGHT[RIGHT(,,<4*(sin(p+24*(beside+1))-sin(p+24*beside))-fall*(q^5-(q-1/w)^5)>,,,<12-9*q^4>,,)]_{E}
RIGHT -> RIGHT[&SOW{x=along-reach+0.5; y=beside}]_{C2}
LEFT{c=along-reach+0.5; w=sqrt(max(0,reach*reach-c*c)); p=hill+19*along; q=(beside+1)/w}{beside+1<w+0.6*sin(137*along+hill)-0.2}{} -> LEFT[LEFT(,,<fall*(q^5-(q-1/w)^5)-4*(sin(24*(beside+1)-p)-sin(24*beside-p))>,,,<12-9*q^4>,,)]_{E}
LEFT -> LEFT[&SOW{x=along-reach+0.5; y=-beside}]_{C4}
RIGHT : RIGHT_C1 < RIGHT_C3 -> RIGHT_C1 | RIGHT_C3
LEFT : LEFT_C1 < LEFT_C3 -> LEFT_C1 | LEFT_C3

#module SOW
/* One seed. What grows of it is luck, and where it lies: the last line that holds has the place. */
#define x=0
#define y=0
#define margin=sqrt(x*x+y*y)/reach
#define SEED(4,math.random(-26,26),math.random(-26,26),math.random(-40,40),22-16*min(1,margin)^6,12,12,1)
#define red=max(0.05,sin(17*x+23*y+here)+sin(29*x-13*y+there)-0.2)
#define white=max(0.08,sin(19*x-21*y+elsewhere)+sin(11*x+27*y+here)-0.1)
#define yellow=max(0.08,sin(24*x+14*y+there)+sin(31*y-9*x+elsewhere)-0.2)
#define blue=max(0,sin(13*x-25*y+here+there)+sin(33*x+7*y+hill)-0.4)
#define pink=max(0.06,sin(27*x+9*y+hill)+sin(15*x-29*y+dale)-0.2)
#define finalStep=1
#axiom: SEED
/* Low turf round whatever stands there. */
SEED -> SEED[&SCALE{len=math.random(34,80); wide=math.random(3,5); start=-90+math.random(10,60); sway=math.random(-30,30); bend=math.random(10,60); tip=0.3; paint=2+floor(math.random(0,3))}]_{C1,C2,C3,C4}
SEED -> SEED[&GRASS(,<-atx>,<-aty>,<math.random(0,360)>,,,,){splay=max(0,margin-0.75)*4; lush=0.85+0.15*sin(21*x+16*y+dale)+0.15*sin(26*y-12*x+hill)}]_{E}
SEED{}{math.random()<0.5*flowers*pink&&margin<0.95}{} -> SEED[&CLOVER(,<-atx>,<-aty>,<math.random(0,360)>,,,,)]_{E}
SEED{}{math.random()<0.34*flowers*yellow&&margin<0.95}{} -> SEED[&BUTTERCUP(,<-atx>,<-aty>,<math.random(0,360)>,,,,)]_{E}
SEED{}{math.random()<0.5*flowers*white&&margin<0.95}{} -> SEED[&DAISY(,<-atx>,<-aty>,<math.random(0,360)>,,,,)]_{E}
SEED{}{math.random()<0.3*flowers*blue&&margin<0.95}{} -> SEED[&CORNFLOWER(,<-atx>,<-aty>,<math.random(0,360)>,,,,)]_{E}
SEED{}{math.random()<0.3*flowers*red&&margin<0.95}{} -> SEED[&POPPY(,<-atx>,<-aty>,<math.random(0,360)>,,,,)]_{E}

#module GRASS
#define splay=0
#define lush=1
#define long=height*lush*math.random(130,230)
#define green=2+floor(math.random(0,3))
#define ROOT(8,0,0,0,3,9,9,2)
#define finalStep=1
#axiom: ROOT
ROOT -> ROOT[&BLADE{len=long*math.random(0.4,1.15); wide=math.random(2.8,4.6); start=-90+math.random(4,42)+splay*math.random(0,40); sway=math.random(-24,24); bend=math.random(10,95); paint=green}]_{C1,C2,C3,C5,C6,C7,C8}
ROOT{}{math.random()<0.35}{} -> ROOT[&BLADE{len=long*math.random(0.3,0.8); start=-90+math.random(20,60); sway=math.random(-24,24); bend=math.random(30,110); paint=5}]_{C4}

ROOT{}{math.random()<0.22}{} -> ROOT[&CULM{len=height*lush*math.random(200,330)}]_{E}

#module BLADE
#define len=100
#define wide=3.8
#define start=-60
#define sway=0
#define bend=40
#define paint=2
#define B(3,0,0,0,len/3,wide,0.3*wide,paint)
#define finalStep=2
#axiom: B(,start,sway,,,,,)
B -> B[B(,<bend/2+wind*16>,,,,<wide*(0.82-0.72*step)>,<0.3*wide*(0.82-0.72*step)>,)]_{E}

#module CULM
/* A stalk of grass in flower: spikelets about its upper third. */
#define len=300
#define STALK(4,0,0,0,len/6,1.1,1.1,6)
#define EAR(4,0,0,30,len/22,0.8,0.8,18)
#define finalStep=10
#axiom: STALK
STALK{}{along<4}{} -> STALK[STALK(,<math.random(-5,5)+wind*7>,<math.random(-5,5)>,,,,,)]_{E}
STALK{}{along==4}{} -> STALK[EAR]_{E}
EAR{}{along<9}{} -> EAR[EAR(,<math.random(-2,6)+wind*3>,,30,,,,)]_{E}
EAR -> EAR[&SCALE{len=len*0.06*(1-0.08*(along-4)); wide=2.6; start=-90+math.random(16,40); paint=18}]_{C(1+along%2),C(3+along%2)}

#module SCALE
/* A flat scale of two volumes: spikelets, anthers, florets. */
#define len=8
#define wide=3
#define start=-40
#define sway=0
#define bend=0
#define tip=0.35
#define paint=18
#define S(3,0,0,0,len/2,wide,0.35*wide,paint)
#define finalStep=1
#axiom: S(,start,sway,,,,,)
S -> S[S(,bend,,,,<wide*tip>,<0.35*wide*tip>,)]_{E}

#module RAY
/* A flat petal of three volumes, blunt at its end. */
#define len=16
#define wide=5
#define start=-20
#define sway=0
#define bend=0
#define foot=0.45
#define tip=0.7
#define paint=11
#define R(3,0,0,0,len/3,wide,0.5,paint)
#define finalStep=2
#axiom: R(,start,sway,,,<wide*(foot+1)/2>,,)
R -> R[R(,<bend/2>,,,,<wide*(1-(1-tip)*step)>,,)]_{E}

#module PETAL
/* One layer of the thesis's petal: a vein of K segments and J lobes on either side, glued. */
#define K=6
#define J=2
#define len=30
#define wide=30
#define start=0
#define sway=0
#define low=0
#define mid=0
#define high=0
#define cup=6
#define wave=0
#define waves=4
#define peak=1
#define foot=1
#define tip=1
#define claw=0
#define paint=8
#define phase=math.random(0,360)
#define VEIN(4,0,0,0,len*sin(90/K)^2,0.06*wide,0.5,paint)
#define RIGHT(4,0,0,0,1,0.4,1,paint)
#define LEFT(4,0,0,0,1,0.4,1,paint)
#define finalStep=K+J+1
#axiom: VEIN(,start,sway,,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,,,)]_{E}
VEIN{s=along/K; w=0.47*wide/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))}{}{} -> VEIN[RIGHT(,,<cup/2>,,w,,H,)]_{C2}[LEFT(,,<-cup/2>,,w,,H,)]_{C4}
RIGHT{r=wave*beside/J*sin(360*waves*along/K+phase)}{beside<J}{} -> RIGHT[RIGHT(,,<cup+r>,,H,,W,)]_{E}
LEFT{r=wave*beside/J*sin(360*waves*along/K+phase)}{beside<J}{} -> LEFT[LEFT(,,<-cup-r>,,H,,W,)]_{E}
RIGHT : RIGHT_C1 < RIGHT_C3 -> RIGHT_C1 | RIGHT_C3
LEFT : LEFT_C1 < LEFT_C3 -> LEFT_C1 | LEFT_C3

#module POPPY
#define open=min(1,max(0,age*math.random(0.3,1.9)-0.2))
#define wilt=max(0,age-1)
#define size=math.random(0.85,1.15)
#define long=height*math.random(190,290)
#define STEM(8,0,0,0,long/7,2,2,6)
#define BASE(8,0,0,0,1.2,3.4,3.4,9)
#define TOP(8,0,0,0,1.2,3.4,3.4,9)
#define WALL(8,0,0,0,2,5,5,9)
#define LID(8,0,0,0,1,7,7,10)
#define finalStep=14
#axiom: STEM(,,,,6,,,)
STEM{hang=(1-open)*max(0,along-3)}{along<7}{} -> STEM[STEM(,<math.random(-4,4)+9*hang*hang+wind*5>,<math.random(-4,4)>,,<long*(0.7+0.3*open)/7>,,,)]_{E}
STEM{}{along<1}{} -> STEM[&BLADE{len=math.random(60,110); wide=9; start=-90+math.random(20,60); bend=math.random(20,60); paint=7}]_{C1,C3,C4,C6,C8}
STEM{}{along==7}{} -> STEM[BASE]_{E}
BASE -> BASE[&PETAL{K=5; J=2; len=size*(11+21*open); wide=size*(9+41*open); start=-60+52*open+math.random(-6,6)+18*wilt; low=-16-22*open; mid=4; high=-30+46*open+math.random(-8,8); cup=14-8*open; wave=8+12*wilt; peak=1.3; tip=0.68; claw=0.24}]_{C1,C5}
BASE -> BASE[TOP]_{E}
TOP -> TOP[&PETAL{K=5; J=2; len=size*(10+19*open); wide=size*(8+36*open); start=-66+48*open+math.random(-6,6)+18*wilt; low=-14-26*open; mid=4; high=-26+38*open+math.random(-8,8); cup=16-8*open; wave=8+12*wilt; peak=1.3; tip=0.68; claw=0.24}]_{C3,C7}
TOP -> TOP[WALL(,,,,<2.4*open+0.4>,<3.4+1.6*open>,<3.4+1.6*open>,)]_{E}
WALL{}{along==10}{} -> WALL[WALL(,,,,<3.6*open+0.4>,<3.6+2.6*open>,<3.6+2.6*open>,)]_{E}[&SCALE{len=3+6*open; wide=0.8; start=-90+math.random(20,50); tip=2; paint=10}]_{C1,C2,C3,C4,C5,C6,C7,C8}
WALL{}{along==11}{} -> WALL[LID(,,,,0.8,<3.6+3.4*open>,<3.6+3.4*open>,)]_{E}[&SCALE{len=3+6*open; wide=0.8; start=-90+math.random(30,70); tip=2; paint=10}]_{C1,C2,C3,C4,C5,C6,C7,C8}

#module DAISY
#define open=min(1,max(0,age*math.random(0.9,2.2)-0.3))
#define wilt=max(0,age-1)
#define size=math.random(0.85,1.15)
#define long=height*math.random(140,240)
#define STEM(8,0,0,0,long/7,1.8,1.8,6)
#define CUP(8,0,0,0,2.4,9*size,9*size,16)
#define RIM(8,0,0,15,0.5,12*size,12*size,11)
#define DISC(8,0,0,11,1,12,12,12)
#define finalStep=15
#axiom: STEM(,,,,6,,,)
STEM{}{along<7}{} -> STEM[STEM(,<math.random(-4,4)+wind*5>,<math.random(-4,4)>,,<long*(0.7+0.3*open)/7>,,,)]_{E}
STEM{}{along<1}{} -> STEM[&BLADE{len=math.random(40,80); wide=8; start=-90+math.random(30,75); bend=math.random(10,40); paint=7}]_{C1,C2,C4,C5,C7}
STEM{}{along==3}{} -> STEM[&BLADE{len=math.random(20,40); wide=5; start=-90+math.random(20,50); bend=30; paint=7}]_{C3}
STEM{}{along==7}{} -> STEM[CUP(,<math.random(10,48)>,<math.random(-14,14)>,,,,,)]_{E}
CUP -> CUP[RIM]_{E}
RIM{}{along<10}{} -> RIM[RIM]_{E}
RIM -> RIM[&RAY{len=size*(6+11*open)*math.random(0.92,1.06); wide=size*(2+3*open); start=-80+68*open-5*(along-9)+math.random(-7,7)+40*wilt; sway=math.random(-5,5); bend=-30+38*open; paint=11}]_{C1,C2,C3,C4,C5,C6,C7,C8}
RIM{}{along==10}{} -> RIM[DISC(,,,,<1.4*size>,<11.5*size>,<11.5*size>,)]_{E}
DISC{}{along<14}{} -> DISC[DISC(,,,,<0.9*size>,<size*(11-2.6*(along-11))>,<size*(11-2.6*(along-11))>,)]_{E}
DISC{}{along<14}{} -> DISC[&SCALE{len=2.1*size; wide=2.4*size; start=-60-8*(along-11); tip=0.8; paint=12}]_{C1,C2,C3,C4,C5,C6,C7,C8}

#module BUTTERCUP
#define long=height*math.random(150,240)
#define STEM(5,0,0,0,long/6,1.7,1.7,6)
#define finalStep=8
#axiom: STEM(,,,,6,,,)
STEM{}{along<5}{} -> STEM[STEM(,<math.random(-6,6)+wind*6>,<math.random(-6,6)>,,<long/6>,<1.7-0.12*along>,<1.7-0.12*along>,)]_{E}
STEM{}{along<1}{} -> STEM[&LOBED{stalk=math.random(30,60)}]_{C1,C3}
STEM{}{along==2}{} -> STEM[&GOLD{long=long*math.random(0.35,0.5)}]_{C2}
STEM{}{along==3}{} -> STEM[&GOLD{long=long*math.random(0.3,0.45)}]_{C4}
STEM{}{along==2||along==3}{} -> STEM[&BLADE{len=math.random(24,40); wide=4; start=-90+math.random(30,60); bend=20; paint=7}]_{C5}
STEM{}{along==5}{} -> STEM[&GOLD{long=long*0.2; start=0}]_{E}

#module GOLD
/* A stalk and its flower of five petals. */
#define long=60
#define start=-58
#define open=min(1,max(0,age*math.random(0.7,2.2)-0.2))
#define wilt=max(0,age-1)
#define size=math.random(0.85,1.15)
#define S(5,0,0,0,long/3,1.1,1.1,6)
#define CUP(5,0,0,0,1.6,3.4,3.4,16)
#define KNOB(5,0,0,36,1.4,3,3,12)
#define finalStep=8
#axiom: S(,<start+math.random(-8,8)>,,,,,,)
S{}{along<3}{} -> S[S(,<math.random(2,12)*(start<0)>,<math.random(-6,6)>,,,,,)]_{E}
S{}{along==3}{} -> S[CUP(,<math.random(-10,30)>,<math.random(-16,16)>,,,,,)]_{E}
CUP -> CUP[&RAY{len=size*(5+8*open); wide=size*(3.5+7.5*open); start=-70+46*open+math.random(-6,6)+30*wilt; bend=-30; foot=0.4; tip=0.75; paint=13}]_{C1,C2,C3,C4,C5}
CUP -> CUP[KNOB]_{E}
KNOB{}{along<6}{} -> KNOB[KNOB(,,,,,2.2,2.2,)]_{E}[&SCALE{len=2+2*open; wide=1; start=-50+math.random(-12,12); tip=1.5; paint=12}]_{C1,C2,C3,C4,C5}

#module LOBED
/* A leaf of three lobes on its stalk. */
#define stalk=40
#define len=math.random(16,24)
#define S(4,0,0,0,stalk/3,1,1,6)
#define finalStep=4
#axiom: S(,<-90+math.random(20,60)>,,,,,,)
S{}{along<2}{} -> S[S(,<10+math.random(-4,6)>,,,,,,)]_{E}
S{}{along==2}{} -> S[&RAY{len=len; wide=len*0.6; start=30; foot=0.4; tip=0.5; bend=20; paint=7}]_{E}[&RAY{len=len*0.9; wide=len*0.55; start=20; sway=50; foot=0.4; tip=0.5; bend=20; paint=7}]_{C2}[&RAY{len=len*0.9; wide=len*0.55; start=20; sway=-50; foot=0.4; tip=0.5; bend=20; paint=7}]_{C4}

#module CORNFLOWER
#define open=min(1,max(0,age*math.random(0.8,2)-0.2))
#define wilt=max(0,age-1)
#define size=math.random(0.85,1.15)
#define long=height*math.random(210,310)
#define STEM(8,0,0,0,long/7,1.6,1.6,6)
#define HEAD(8,0,0,0,3,6,6,16)
#define RIM(8,0,0,22,0.8,6,6,15)
#define finalStep=14
#axiom: STEM(,,,,6,,,)
STEM{}{along<7}{} -> STEM[STEM(,<math.random(-4,4)+wind*5>,<math.random(-4,4)>,,<long/7>,,,)]_{E}
STEM{}{along<5}{} -> STEM[&BLADE{len=math.random(45,80)-6*along; wide=3.4; start=-90+math.random(20,45); bend=math.random(10,50); paint=7}]_{C(1+(3*along)%8),C(1+(3*along+4)%8)}
STEM{}{along==7}{} -> STEM[HEAD(,<math.random(-4,40)>,<math.random(-10,10)>,,,<4*size>,<4*size>,)]_{E}
HEAD{}{along<10}{} -> HEAD[HEAD(,,,,<4*size>,<size*(9-2.5*(along-8))>,<size*(9-2.5*(along-8))>,)]_{E}
HEAD{}{along==10}{} -> HEAD[RIM]_{E}
RIM{}{along<13}{} -> RIM[RIM(,,,,,<5-1.2*(along-11)>,<5-1.2*(along-11)>,)]_{E}
RIM{}{along==11}{} -> RIM[&TRUMPET{len=size*(6+10*open); start=-84+66*open+math.random(-12,12)+20*wilt; open=open}]_{C1,C2,C3,C4,C5,C6,C7,C8}
RIM{}{along==12}{} -> RIM[&SCALE{len=size*(5+6*open); wide=1.7; start=-78+20*open+math.random(-12,12); tip=0.9; paint=15}]_{C1,C2,C3,C4,C5,C6,C7,C8}
RIM{}{along==13}{} -> RIM[&SCALE{len=size*(5+5*open); wide=1.7; start=-86+math.random(-6,12); tip=0.9; paint=15}]_{C1,C2,C3,C4,C5,C6,C7,C8}

#module TRUMPET
/* A floret of the rim: a tube that widens, and its lobes. */
#define len=14
#define start=0
#define open=1
#define TUBE(4,0,0,0,len/4,1.2,1.2,14)
#define finalStep=3
#axiom: TUBE(,start,<math.random(-14,14)>,,,,,)
TUBE{}{along<1}{} -> TUBE[TUBE(,<8*open>,,,,<1.4+2*open>,<1.4+1.2*open>,)]_{E}
TUBE{}{along==1}{} -> TUBE[&SCALE{len=len*0.55; wide=1.8+1.8*open; start=6; paint=14}]_{E}[&SCALE{len=len*0.5; wide=1.7+1.7*open; start=-52+math.random(-8,8); paint=14}]_{C1,C2,C4}

#module CLOVER
#define open=min(1,max(0,age*math.random(0.8,2)-0.2))
#define wilt=max(0,age-1)
#define size=math.random(0.85,1.2)
#define long=height*math.random(90,150)
#define STEM(8,0,0,0,long/5,1.8,1.8,6)
#define HEAD(8,0,0,21,3,10,10,17)
#define finalStep=11
#axiom: STEM(,,,,6,,,)
STEM{}{along<5}{} -> STEM[STEM(,<math.random(-7,7)+wind*4>,<math.random(-7,7)>,,<long/5>,,,)]_{E}
STEM{}{along<1}{} -> STEM[&LOBED{stalk=math.random(40,80)}]_{C1,C4,C6}
STEM{}{along==4}{} -> STEM[&LOBED{stalk=12}]_{C2,C6}
STEM{}{along==5}{} -> STEM[HEAD(,,,,<2*size>,<6*size>,<6*size>,)]_{E}
HEAD{}{along<10}{} -> HEAD[HEAD(,,,,<2.6*size>,<size*(11*sin(36*(along-4.4))+1)>,<size*(11*sin(36*(along-4.4))+1)>,)]_{E}
HEAD -> HEAD[&SCALE{len=size*(4+4*open); wide=2*size; start=-20-13*(along-6)+math.random(-10,10)+40*wilt; bend=-30; tip=0.6; paint=17}]_{C1,C2,C3,C4,C5,C6,C7,C8}
`,
	panicle: `/* Panicle
   about: A raceme of racemes, shorter towards the tip: lilac, florets of four lobes, in bud above.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=135 /* 70 … 210 mm, of the panicle */
#define tall=length*math.random(0.89,1.11)
#define nodes=floor(math.random(10,13))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define WOOD(8,0,0,0,12,4.4,4.4,1)
#define PAIR(8,0,0,0,3,4.4,4.4,1)
#define AXIS(8,0,0,0,10,2.6,2.6,2)
#define DONE(8,0,0,0,10,2.6,2.6,2)
#define finalStep=9+nodes

#material 1 stem "7a6a50" "86785c"
#material 2 stem "86904e" "8a7a6a"
#material 3 leaf "4a7d3c" "639a50" veins "8ab474" 6 0.4
#material 4 petal "a878cc" "caa2e4" bud "8a4a9c" "96529f" wilted "a88a94" "9a7a74"
#material 5 petal "8d5ab6" "9a68c2" bud "7a3f8c" "844690" wilted "94787e" "86685f"
#material 6 petal "84509e" "9560b2"

#axiom: WOOD
WOOD{}{step<5&&step!=2&&step!=4}{} -> WOOD[WOOD(,<math.random(-3,3)>,<math.random(-3,3)>,,,<4.4-0.2*step>,<4.4-0.2*step>,)]_{E}
WOOD{}{step==2}{} -> WOOD[PAIR]_{E}
PAIR -> PAIR[WOOD]_{E}
PAIR -> PAIR[&LEAF{len=math.random(66,84)}]_{C3,C7}
WOOD{}{step==5}{} -> WOOD[AXIS]_{E}
/* Branches stand in pairs, each pair across the one below: every second pair on other faces. */
AXIS{k=step-6; q=k/nodes}{step<finalStep-1}{} -> DONE[AXIS(,<math.random(-3,3)>,<math.random(-3,3)>,,<tall/nodes*(1.1-0.4*q)>,<2.6-1.8*q>,<2.6-1.8*q>,)]_{E}[&BRANCH{long=(46-41*q)*math.random(0.88,1.1); start=-26-30*q+math.random(-6,6); pairs=max(0,4.2-4.6*q); open=min(1,max(0,open*1.6-0.75*q)); wilt=wilt}]_{C(1+2*(k%2)), C(5+2*(k%2))}

#module BRANCH
#define long=24
#define start=-40
#define pairs=2
#define open=1
#define wilt=0
#define TWIG(8,0,0,0,long/4,1.1,1.1,2)
#define GONE(8,0,0,0,1,1,1,2)
#define finalStep=7
#axiom: TWIG(,start,,,,,,)
TWIG{}{step<pairs}{} -> GONE[TWIG(,<math.random(-8,2)>,<math.random(-6,6)>,,,,,)]_{E}[&FLORET{start=-36+math.random(-10,10); open=max(0,open-0.08*step); wilt=wilt}]_{C(1+2*(step%2)), C(5+2*(step%2))}
TWIG{}{step>=pairs}{} -> GONE[&FLORET{start=0; open=open; wilt=wilt}]_{E}[&FLORET{start=-40+math.random(-10,10); open=open; wilt=wilt}]_{C2,C6}

#module FLORET
#define start=0
#define open=1
#define wilt=0
#define g=math.random(1.25,1.5)
#define TUBE(8,0,0,0,g*(1.6+1.2*open),1,1,5)
#define MOUTH(8,0,0,0,0.6,1.7,1.7,5)
#define finalStep=4
#axiom: TUBE(,start,,,,,,)
TUBE{}{step==0}{} -> TUBE[TUBE(,<math.random(-8,8)>,<math.random(-8,8)>,,<g*(1.4+2.4*open)>,<1.5-0.3*open>,<1.5-0.3*open>,)]_{E}
TUBE{}{step==1}{} -> TUBE[MOUTH(,,,,0.6,<1.9-0.3*open>,<1.9-0.3*open>,)]_{E}
MOUTH -> MOUTH[&BLADE{S=3; len=g*(1.2+3.6*open); wide=g*(1.2+2.1*open); thick=0.4; start=-70+72*open+math.random(-8,8); bend=-24+10*open+50*wilt; peak=1.1; round=0.7; claw=0.6; blunt=0.5; paint=4}]_{C1,C3,C5,C7}

#module LEAF
#define len=80
#define PETIOLE(8,0,0,0,len*0.1,1.6,1.6,1)
#define finalStep=4
#axiom: PETIOLE(,<-40+math.random(-8,8)>,<math.random(-8,8)>,,,,,)
PETIOLE{}{step<2}{} -> PETIOLE[PETIOLE(,8,,,,,,)]_{E}
PETIOLE{}{step==2}{} -> PETIOLE[&PETAL{K=11; J=2; len=len; wide=len*0.72; thick=0.8; start=16; low=10; mid=10; high=math.random(10,30); cup=5; peak=0.55; foot=0.45; tip=1.9; claw=0.4; fan=30; upper=3; middle=3; lower=3}]_{E}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 2 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<thick*max(0.25,1-u^3)>,<thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}
`,
	pansy: `/* Wild pansy
   about: One plane of symmetry: two upper petals, two at the sides and a lower one with a spur, each of its own shape and colour; K5 C5 A5 G(3).
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=90 /* 40 … 150 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=0.74 /* 0.5 … 1.2, of the flower */
#define tall=length*math.random(0.78,1.22)
#define size=scale*math.random(0.91,1.09)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define STEM(10,0,0,0,10,2,2,1)
#define NODEA(10,0,0,0,3,2.2,2.2,1)
#define NODEB(10,0,0,0,3,2.1,2.1,1)
#define NODEC(10,0,0,0,3,2,2,1)
#define TIP(10,0,0,0,3,1.6,1.6,1)
#define finalStep=16

#material 1 stem "6f8f52" "86a862"
#material 2 leaf "45753a" "639a50" veins "86b070" 5 0.4 feathered name "leaf, upper epidermis"
#material 12 leaf "568448" "6fa05a" name "leaf, mesophyll"
#material 13 leaf "64905a" "7aa46a" name "leaf, lower epidermis"
#material 3 sepal "6a9450" "82aa64" name "sepal, upper epidermis"
#material 14 sepal "6c9454" "84aa68" name "sepal, mesophyll"
#material 15 sepal "5a8444" "749c58" name "sepal, lower epidermis"
#material 4 petal "6a3a9e" "4b1f86" foot 0.3 veins "2c0f5c" 6 0.3 bud "5a3a86" "4a2a76" wilted "6d5472" "5d4262" name "upper petal, upper epidermis"
#material 10 petal "6a3a9e" "4b1f86" foot 0.3 wilted "665070" "5a4460" name "upper petal, mesophyll"
#material 5 petal "6a40a2" "5a3294" bud "5e4088" "52347e" wilted "705a78" "644c6a" name "upper petal, lower epidermis"
#material 6 petal "3b1440" "c9a8e6" foot 0.6 veins "4a1c5e" 5 0.55 bud "4a2450" "a98fc0" wilted "5a3a50" "9a8296" name "side petal, upper epidermis"
#material 11 petal "3b1440" "c9a8e6" foot 0.6 bud "6a4878" "a98fc0" wilted "6e5268" "9a8296" name "side petal, mesophyll"
#material 8 petal "b79ad8" "cdb2ec" wilted "94809c" "a08ea2" name "side petal, lower epidermis"
#material 7 petal "4a1a30" "f7d52e" foot 0.8 veins "3a1226" 7 0.75 margin "f9e06a" 0.1 bud "5a2a30" "d8c040" wilted "5a3030" "b89a48" name "lower petal, upper epidermis"
#material 16 petal "4a1a30" "f7d52e" foot 0.8 bud "6a4034" "d0b848" wilted "64403a" "b0944c" name "lower petal, mesophyll"
#material 17 petal "dcc65a" "f4e08a" bud "c8b458" "d8c868" wilted "b09a60" "c0a868" name "lower petal, lower epidermis"
#material 9 pistil "e8b92a" "9ab84a"

#axiom: STEM
STEM{}{step<14&&step!=3&&step!=6&&step!=9}{} -> STEM[STEM(,<bend+math.random(-4,4)>,<math.random(-4,4)>,,<tall/10>,,,)]_{E}
STEM{}{step==3}{} -> STEM[NODEA]_{E}
STEM{}{step==6}{} -> STEM[NODEB]_{E}
STEM{}{step==9}{} -> STEM[NODEC]_{E}
NODEA -> NODEA[STEM(,8,,,,,,)]_{E}
NODEB -> NODEB[STEM(,-9,,,,,,)]_{E}
NODEC -> NODEC[TIP]_{E}
NODEA -> NODEA[&LEAF{len=math.random(26,32)}]_{C6}[&LEAF{len=math.random(20,26)}]_{C2}
NODEB -> NODEB[&LEAF{len=math.random(26,32)}]_{C9}[&FLOWER{open=max(0,open-0.3); size=0.86*size; stalk=tall*0.4; start=-32}]_{C4}
NODEC -> NODEC[&LEAF{len=math.random(22,28)}]_{C4}[&LEAF{len=math.random(18,24)}]_{C8}[&FLOWER{open=open; wilt=wilt; size=size; stalk=tall*0.62; start=-48}]_{C1}

#module FLOWER
#define open=1
#define wilt=0
#define size=1
#define stalk=60
#define start=-40
#define STALK(10,0,0,0,stalk/9,1.5,1.5,1)
#define CALYX(10,0,0,0,1.2,2.8,2.8,3)
#define FACE(10,0,0,0,0.8,2.6,2.6,9)
#define HEART(10,0,0,0,1,1.3,1.3,9)
#define finalStep=13
/* The stalk bows at its end, so that the flower looks ahead: C1 is below, C6 above. */
#axiom: STALK(,start,,,,,,)
STALK{}{step<8}{} -> STALK[STALK(,<(step<5)*-(90+start)*0.16+(step>=5)*(25-4*open+10*wilt)+math.random(-2,2)>,<math.random(-2,2)>,,,,,)]_{E}
STALK{}{step==8}{} -> STALK[CALYX(,<18-6*open>,,,,,,)]_{E}
CALYX -> CALYX[FACE]_{E}
CALYX -> CALYX[&PETAL{K=7; J=1; len=size*(6+5*open); wide=size*2.8; thick=0.4; start=-64+92*open; low=-10+10*open; cup=10; peak=0.7; tip=1.7; claw=0.8; upper=3; middle=14; lower=15}]_{C2,C4,C6,C8,C10}
CALYX -> CALYX[&PETAL{K=7; J=1; len=size*(2+4*open); wide=size*2.6; thick=2*size; start=66; low=-6; cup=30; foot=0.4; tip=0.6; claw=0.9; upper=6; middle=11; lower=8}]_{C1}
FACE -> FACE[HEART]_{E}
FACE -> FACE[&PETAL{K=10; J=3; kept=1-0.4*wilt; len=size*(8+9*open); wide=size*(5+12*open); thick=0.4; start=-66+60*open+8*wilt; sway=8*open; low=-20+16*open; high=-30+50*open+math.random(-6,6); cup=13-10*open; wave=5+22*wilt; peak=1.3; foot=0.9; tip=0.62; claw=0.3; upper=4; middle=10; lower=5}]_{C5}
FACE -> FACE[&PETAL{K=10; J=3; kept=1-0.4*wilt; len=size*(8+9*open); wide=size*(5+12*open); thick=0.4; start=-66+62*open+8*wilt; sway=-8*open; low=-20+14*open; high=-30+50*open+math.random(-6,6); cup=13-10*open; wave=5+22*wilt; peak=1.3; foot=0.9; tip=0.62; claw=0.3; upper=4; middle=10; lower=5}]_{C7}
FACE -> FACE[&PETAL{K=10; J=3; kept=1-0.4*wilt; len=size*(7+8*open); wide=size*(5+8.5*open); thick=0.4; start=-70+58*open+10*wilt; sway=14*open; low=-16+8*open; high=-30+40*open+math.random(-6,6); cup=14-10*open; wave=4+22*wilt; peak=1.3; foot=0.9; tip=0.66; claw=0.26; upper=6; middle=11; lower=8}]_{C3}
FACE -> FACE[&PETAL{K=10; J=3; kept=1-0.4*wilt; len=size*(7+8*open); wide=size*(5+8.5*open); thick=0.4; start=-70+58*open+10*wilt; sway=-14*open; low=-16+8*open; high=-30+40*open+math.random(-6,6); cup=14-10*open; wave=4+22*wilt; peak=1.3; foot=0.9; tip=0.66; claw=0.26; upper=6; middle=11; lower=8}]_{C9}
FACE -> FACE[&PETAL{K=10; J=4; kept=1-0.35*wilt; len=size*(8+8.5*open); wide=size*(6+13*open); thick=0.4; start=-72+52*open+10*wilt; low=-14+4*open; high=-30+46*open+math.random(-6,6); cup=12-7*open; wave=5+22*wilt; peak=1.45; foot=0.9; tip=0.55; claw=0.26; spread=5; upper=7; middle=16; lower=17}]_{C1}
HEART{}{step<12}{} -> HEART[HEART(,,,,0.5,<1.3-0.3*(step-10)>,<1.3-0.3*(step-10)>,)]_{E}

#module LEAF
#define len=28
#define PETIOLE(8,0,0,0,len*0.16,1,1,1)
#define finalStep=5
#axiom: PETIOLE(,<-44+math.random(-8,8)>,<math.random(-10,10)>,,,,,)
PETIOLE{}{step<3}{} -> PETIOLE[PETIOLE(,8,,,,,,)]_{E}
PETIOLE{}{step==3}{} -> PETIOLE[&PETAL{K=16; J=2; len=len; wide=len*0.5; thick=0.6; low=10; mid=8; high=10; cup=6; peak=0.75; foot=0.7; tip=1.6; claw=0.1; teeth=0.28; bites=4; upper=2; middle=12; lower=13}]_{E}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 4 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define kept=1      /* how much of it is left: it withers, hangs and falls */
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,kept*len*sin(90/K)^2,kept*thick,kept*thick,middle)
#define RU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU4(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM4(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL4(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU4(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM4(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL4(4,0,0,0,1,0.3*kept*thick,1,lower)
#axiom: VEIN(,start+50*(1-kept),sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<kept*len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<kept*thick*max(0.25,1-u^3)>,<kept*thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RU2[RU3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RM2[RM3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RL2[RL3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LU2[LU3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LM2[LM3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LL2[LL3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> RU3[RU4(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> RM3[RM4(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> RL3[RL4(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> LU3[LU4(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> LM3[LM4(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> LL3[LL4(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2
RU4 : RU4_C1 < RU4_C3 -> RU4_C1 | RU4_C3
LU4 : LU4_C1 < LU4_C3 -> LU4_C1 | LU4_C3
RM4 : RM4_C1 < RM4_C3 -> RM4_C1 | RM4_C3
LM4 : LM4_C1 < LM4_C3 -> LM4_C1 | LM4_C3
RL4 : RL4_C1 < RL4_C3 -> RL4_C1 | RL4_C3
LL4 : LL4_C1 < LL4_C3 -> LL4_C1 | LL4_C3
RL4 : RL4_C2 < RM4_C4 -> RL4_C2 | RM4_C4
RM4 : RM4_C2 < RU4_C4 -> RM4_C2 | RU4_C4
LL4 : LL4_C4 < LM4_C2 -> LL4_C4 | LM4_C2
LM4 : LM4_C4 < LU4_C2 -> LM4_C4 | LU4_C2
`,
	petal: `/* Petal
   about: One petal of three layers, whose lobes grow from a vein and are glued.
   source: Petrenko 2014, figure 21 and section 2.2.3; the grammar is ours
*/
#define STEM(8,0,0,0,4,3,3,1)
#axiom: STEM
#define finalStep=1
STEM -> STEM[&PETAL]_{E}
#material 4 petal "f3c14b" "d1253f" foot 0.5 margin "f3a9a0" 0.35 veins "8d1230" 9 0.45 light 0.5 name "upper epidermis"
#material 5 petal "f6e3ae" "e9a08e" foot 0.5 light 0.5 name "mesophyll"
#material 6 petal "e9cf86" "b8485a" foot 0.5 margin "d99a90" 0.35 veins "8d1230" 9 0.3 light 0.5 name "lower epidermis"
#module PETAL
#define K=12
#define len=60
#define half=38/2
#define t=1.2
#define cup=9
#define finalStep=15
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,5)
#define RU1(4,0,0,0,1,t,1,4)
#define RU2(4,0,0,0,1,t,1,4)
#define RU3(4,0,0,0,1,t,1,4)
#define RM1(4,0,0,0,1,t,1,5)
#define RM2(4,0,0,0,1,t,1,5)
#define RM3(4,0,0,0,1,t,1,5)
#define RL1(4,0,0,0,1,t,1,6)
#define RL2(4,0,0,0,1,t,1,6)
#define RL3(4,0,0,0,1,t,1,6)
#define LU1(4,0,0,0,1,t,1,4)
#define LU2(4,0,0,0,1,t,1,4)
#define LU3(4,0,0,0,1,t,1,4)
#define LM1(4,0,0,0,1,t,1,5)
#define LM2(4,0,0,0,1,t,1,5)
#define LM3(4,0,0,0,1,t,1,5)
#define LL1(4,0,0,0,1,t,1,6)
#define LL2(4,0,0,0,1,t,1,6)
#define LL3(4,0,0,0,1,t,1,6)
#axiom: VEIN(, 0, , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<6-10*u>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,H,)]_{C6}
RL1{s=(step-1)/K}{}{} -> RL1[RL2(,0,cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
RM1{s=(step-1)/K}{}{} -> RM1[RM2(,0,cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
RU1{s=(step-1)/K}{}{} -> RU1[RU2(,0,cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
LL1{s=(step-1)/K}{}{} -> LL1[LL2(,0,-cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
LM1{s=(step-1)/K}{}{} -> LM1[LM2(,0,-cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
LU1{s=(step-1)/K}{}{} -> LU1[LU2(,0,-cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
RL2{s=(step-2)/K}{}{} -> RL2[RL3(,0,cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
RM2{s=(step-2)/K}{}{} -> RM2[RM3(,0,cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
RU2{s=(step-2)/K}{}{} -> RU2[RU3(,0,cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
LL2{s=(step-2)/K}{}{} -> LL2[LL3(,0,-cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
LM2{s=(step-2)/K}{}{} -> LM2[LM3(,0,-cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
LU2{s=(step-2)/K}{}{} -> LU2[LU3(,0,-cup,0,<max(0.02, half*(0.409-0.021*s+17.437*s^2-65.942*s^3+112.193*s^4-97.279*s^5+33.204*s^6))/3>,0.3*t,,)]_{E}
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2
`,
	poppy: `/* Poppy
   about: Four crumpled petals in two whorls, many dark stamens, and a capsule under its lid of stigmas; the bud hangs in two hairy sepals, which fall.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=235 /* 120 … 370 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1.14 /* 0.7 … 1.6, of the flower */
#define tall=length*math.random(0.87,1.13)
#define size=scale*math.random(0.975,1.03)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)
/* Petals fall within days, stamens after them; the capsule stays. */
#define shed=clamp((wilt-0.4)/0.5,0,1)

#define STEM(12,0,0,0,24,2.4,2.4,1)
#define OLD(12,0,0,0,24,2.4,2.4,1)
#define RECEPTACLE(12,0,0,0,1.2,4.4,4.4,1)
#define CALYX(12,0,0,0,1.1,4.6,4.6,1)
#define BASE(12,0,0,0,1.1,4.4,4.4,1)
#define RING(12,0,0,8,0.7,4.2,4.2,1)
#define finalStep=27

#material 1 stem "76925c" "88a56a"
#material 2 leaf "5f8550" "7a9c64" veins "8fae78" 7 0.45 feathered wilted "76905a" "949a62" name "leaf, upper epidermis"
#material 12 leaf "6c905a" "83a46c" wilted "8ea26c" "a4aa74" name "leaf, mesophyll"
#material 13 leaf "78986a" "8eac7c" wilted "84986a" "9aa474" name "leaf, lower epidermis"
#material 3 sepal "93ab76" "a4b986" name "sepal, upper epidermis"
#material 14 sepal "7d9a60" "8eaa70" name "sepal, mesophyll"
#material 15 sepal "6f8f55" "83a066" name "sepal, lower epidermis"
#material 5 petal "1d0d10" "de3323" foot 0.46 veins "a31812" 9 0.3 bud "3a1014" "b83024" wilted "1d0d10" "963028" name "petal, upper epidermis"
#material 10 petal "1d0d10" "de3323" foot 0.46 bud "3a1014" "b03024" wilted "241014" "8a2a26" name "petal, mesophyll"
#material 4 petal "4a1c1e" "d84430" foot 0.35 veins "ac241a" 9 0.3 bud "4a1c1c" "c24838" wilted "36191a" "94382e" name "petal, lower epidermis"
#material 6 stamen "2c2236" "3c3148"
#material 7 stamen "26222c" "4c4658"
#material 8 pistil "93a87a" "a5b88a"
#material 9 pistil "8f9468" "a3a87e"
#material 16 pistil "3c2230" "2c1824" name "stigma"

#axiom: STEM
STEM{hang=(1-open)^0.6*max(0,step-9)^2}{step<16}{} -> OLD[STEM(,<bend+math.random(-2.5,2.5)+1.75*hang>,<math.random(-2.5,2.5)>,,<tall*(0.75+0.25*open)/16>,<2.6-0.05*step>,<2.6-0.05*step>,)]_{E}
STEM{l=math.random(92,114)-10*step}{step<7&&step!=5}{} -> STEM[&PETAL{K=18; J=2; len=l; wide=l*0.5; thick=0.7; start=-52+math.random(-8,8)-3*step; sway=math.random(-6,6); low=20; mid=24; high=math.random(0,40); cup=-5; peak=0.95; foot=0.7; tip=1.6; claw=0.12; teeth=0.85; bites=4; barb=-24; upper=2; middle=12; lower=13}]_{C(1+(5*step)%12)}
STEM{}{step==16}{} -> STEM[CALYX(,<22*open>,,,,,,)]_{E}
CALYX -> CALYX[RECEPTACLE(,<12*open>,,,,,,)]_{E}
CALYX -> CALYX[&PETAL{K=8; len=0.3+23*max(0,1-2*open); wide=0.2+21*max(0,1-2*open); thick=0.05+0.8*max(0,1-2*open); start=-22; low=-66; mid=-6; high=-66; cup=34; claw=0.4; upper=3; middle=14; lower=15}]_{C1,C7}
RECEPTACLE -> RECEPTACLE[BASE]_{E}
RECEPTACLE -> RECEPTACLE[&PETAL{K=14; J=5; kept=1-0.985*clamp((wilt-math.random(0.28,0.6))/0.28,0,1); len=size*(11+27*open); wide=size*(9+57*open); thick=0.45; start=-60+55*open+math.random(-5,5)+18*wilt; low=-16-26*open; mid=4; high=-34+50*open+math.random(-10,10); cup=15-8*open; wave=15+math.random(0,7)+10*wilt; waves=math.random(3.5,5.5); peak=1.32; foot=1; tip=0.66; claw=0.24; spread=5; upper=5; middle=10; lower=4}]_{C1,C7}
BASE -> BASE[RING]_{E}
BASE -> BASE[&PETAL{K=14; J=5; kept=1-0.985*clamp((wilt-math.random(0.28,0.65))/0.28,0,1); len=size*(10+25*open); wide=size*(8+49*open); thick=0.45; start=-63+50*open+math.random(-5,5)+18*wilt; low=-14-30*open; mid=4; high=-30+42*open+math.random(-10,10); cup=16-8*open; wave=15+math.random(0,7)+10*wilt; waves=math.random(3.5,5.5); peak=1.3; foot=1; tip=0.68; claw=0.24; spread=5; upper=5; middle=10; lower=4}]_{C4,C10}
RING{}{step<25}{} -> RING[RING]_{E}
RING{}{step==25}{} -> RING[&CAPSULE]_{E}
RING -> RING[&STAMEN]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 5 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define kept=1      /* how much of it is left: it withers, hangs and falls */
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,kept*len*sin(90/K)^2,kept*thick,kept*thick,middle)
#define RU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU4(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU5(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM4(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM5(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL4(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL5(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU4(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU5(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM4(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM5(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL4(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL5(4,0,0,0,1,0.3*kept*thick,1,lower)
#axiom: VEIN(,start+50*(1-kept),sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<kept*len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<kept*thick*max(0.25,1-u^3)>,<kept*thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RU2[RU3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RM2[RM3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RL2[RL3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LU2[LU3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LM2[LM3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LL2[LL3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> RU3[RU4(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> RM3[RM4(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> RL3[RL4(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> LU3[LU4(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> LM3[LM4(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> LL3[LL4(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> RU4[RU5(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> RM4[RM5(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> RL4[RL5(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> LU4[LU5(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> LM4[LM5(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> LL4[LL5(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2
RU4 : RU4_C1 < RU4_C3 -> RU4_C1 | RU4_C3
LU4 : LU4_C1 < LU4_C3 -> LU4_C1 | LU4_C3
RM4 : RM4_C1 < RM4_C3 -> RM4_C1 | RM4_C3
LM4 : LM4_C1 < LM4_C3 -> LM4_C1 | LM4_C3
RL4 : RL4_C1 < RL4_C3 -> RL4_C1 | RL4_C3
LL4 : LL4_C1 < LL4_C3 -> LL4_C1 | LL4_C3
RL4 : RL4_C2 < RM4_C4 -> RL4_C2 | RM4_C4
RM4 : RM4_C2 < RU4_C4 -> RM4_C2 | RU4_C4
LL4 : LL4_C4 < LM4_C2 -> LL4_C4 | LM4_C2
LM4 : LM4_C4 < LU4_C2 -> LM4_C4 | LU4_C2
RU5 : RU5_C1 < RU5_C3 -> RU5_C1 | RU5_C3
LU5 : LU5_C1 < LU5_C3 -> LU5_C1 | LU5_C3
RM5 : RM5_C1 < RM5_C3 -> RM5_C1 | RM5_C3
LM5 : LM5_C1 < LM5_C3 -> LM5_C1 | LM5_C3
RL5 : RL5_C1 < RL5_C3 -> RL5_C1 | RL5_C3
LL5 : LL5_C1 < LL5_C3 -> LL5_C1 | LL5_C3
RL5 : RL5_C2 < RM5_C4 -> RL5_C2 | RM5_C4
RM5 : RM5_C2 < RU5_C4 -> RM5_C2 | RU5_C4
LL5 : LL5_C4 < LM5_C2 -> LL5_C4 | LM5_C2
LM5 : LM5_C4 < LU5_C2 -> LM5_C4 | LU5_C2

#module STAMEN
#define FILAMENT(4,0,0,0,1.4,0.35,0.35,6)
#define ANTHER(4,0,0,0,0.8,1.1,0.8,7)
#define finalStep=7
#define lean=math.random(-62,-18)
#axiom: FILAMENT(,<lean-24*(1-open)>,,,,,,)
FILAMENT{}{step<4}{} -> FILAMENT[FILAMENT(,<-lean*0.1-7+24*shed>,,,<(0.4+1.25*open)*(1-0.85*shed)>,<0.35-0.3*shed>,<0.35-0.3*shed>,)]_{E}
FILAMENT{}{step==4}{} -> FILAMENT[ANTHER(,,,,<0.8-0.75*shed>,<1.1-1.05*shed>,<0.8-0.75*shed>,)]_{E}
ANTHER -> ANTHER[ANTHER(,,,,<1-0.95*shed>,<1.1-1.05*shed>,<0.8-0.75*shed>,)]_{E}

#module CAPSULE
#define WALL(12,0,0,0,1.2,4,4,8)
#define LID(12,0,0,0,0.8,8.8,8.8,9)
#define RAY(4,0,0,0,0.5,0.5,2.6,16)
#define finalStep=10
#axiom: WALL
WALL{g=0.4+0.6*open+0.45*wilt}{step<7}{} -> WALL[WALL(,,,,<1.7*g>,<(4.5+3.4*sin(18*step))*g>,<(4.5+3.4*sin(18*step))*g>,)]_{E}
WALL{}{step==7}{} -> WALL[LID(,,,,<0.3+0.5*open>,<3+5.8*open+2.6*wilt>,<3+5.8*open+2.6*wilt>,)]_{E}
LID{}{step<9}{} -> LID[LID(,,,,0.6,<1+open>,<1+open>,)]_{E}
LID{}{step==9}{} -> LID[RAY]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12}
`,
	raceme: `/* Raceme
   about: Flowers on stalks along an axis, the lowest first: lily of the valley, its bells hollow as a prism that grows backwards makes them.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=150 /* 80 … 230 mm, of the stalk */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define tall=length*math.random(0.87,1.10)
#define bells=floor(math.random(8,12))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define SHEATH(12,0,0,0,5,7,7,2)
#define STEM(12,0,0,0,20,2.4,2.4,1)
#define NODE(12,0,0,0,8,2,2,1)
#define DONE(12,0,0,0,8,2,2,1)
#define finalStep=12+bells

#material 1 stem "86a862" "a3c07c"
#material 2 leaf "3f7a3a" "5c9a4c" veins "7fb068" 7 0.35 wilted "8fa04a" "b8ae5c"
#material 4 petal "f2f4e2" "fffefb" bud "c3d4a4" "dfe6c8" wilted "e0d3b0" "c9b58a"
#material 5 petal "f7f6ee" "fdfcf8"

#axiom: SHEATH(,,,55,,,,)
SHEATH{}{step<3}{} -> SHEATH[SHEATH(,,,,5,<7-1.2*step>,<7-1.2*step>,)]_{E}
SHEATH{}{step==0}{} -> SHEATH[&PETAL{K=13; J=3; len=math.random(112,132); wide=math.random(40,50); thick=0.9; start=-66+math.random(-4,4)-14*(1-open); low=6; mid=10; high=math.random(14,34); cup=13; peak=0.85; foot=0.9; tip=1.8; claw=0.2; upper=2; middle=2; lower=2}]_{C7}
SHEATH{}{step==1}{} -> SHEATH[&PETAL{K=13; J=3; len=math.random(96,116); wide=math.random(34,44); thick=0.9; start=-60+math.random(-4,4)-14*(1-open); low=6; mid=10; high=math.random(14,34); cup=13; peak=0.85; foot=0.9; tip=1.8; claw=0.2; upper=2; middle=2; lower=2}]_{C3}
SHEATH{}{step==3}{} -> SHEATH[STEM]_{E}
STEM{}{step<10}{} -> STEM[STEM(,<bend+1.5+math.random(-1,1)>,<math.random(-1,1)>,,<tall*0.5/6>,2.2,2.2,)]_{E}
STEM{}{step==10}{} -> STEM[NODE]_{E}
NODE{k=step-11; q=k/bells}{step<finalStep-1}{} -> DONE[NODE(,<4+math.random(-1,1)>,<math.random(-2,2)>,,<tall*0.5/bells*(1.25-0.5*q)>,<2-1.1*q>,<2-1.1*q>,)]_{E}[&BELL{open=min(1,max(0.12,open*1.6-0.8*q)); size=(1-0.35*q)*math.random(0.92,1.06); wilt=wilt}]_{C(3-(step%2)*4+12*(step%2))}

#module BELL
#define open=1
#define size=1
#define wilt=0
#define STALK(12,0,0,0,size*2.2,0.9,0.9,1)
#define CUP(12,0,0,0,1,1.6,1.6,4)
#define LIP(12,0,0,0,1,1.6,1.6,4)
#define INSIDE(12,0,0,0,-1,6,6,5)
#define g=1.2*size*(0.35+0.65*open)*(1-0.25*wilt)
#define finalStep=15
#axiom: STALK(,<-34+math.random(-8,8)>,<math.random(-14,14)>,,,,,)
STALK{}{step<5}{} -> STALK[STALK(,<19+math.random(-3,3)>,,,,,,)]_{E}
STALK{}{step==5}{} -> STALK[CUP(,,,,<0.7*g>,<3.4*g>,<3.4*g>,)]_{E}
CUP{}{step==6}{} -> CUP[CUP(,,,,<1.3*g>,<6.2*g>,<6.2*g>,)]_{E}
CUP{}{step==7}{} -> CUP[CUP(,,,,<2*g>,<7.4*g>,<7.4*g>,)]_{E}
CUP{}{step==8}{} -> CUP[CUP(,,,,<1.7*g>,<6.8*g>,<6.8*g>,)]_{E}
CUP{}{step==9}{} -> CUP[LIP(,,,,<0.6*g>,<(4+3.2*open)*g>,<(4+3.2*open)*g>,)]_{E}
/* What grows backwards lines the bell. */
LIP -> LIP[INSIDE(,,,,<-0.6*g>,<(2+3.6*open)*g>,<(2+3.6*open)*g>,)]_{E}
INSIDE{}{step<14}{} -> INSIDE[INSIDE(,,,,<-1.3*g>,<6*g>,<6*g>,)]_{E}
LIP -> LIP[&BLADE{S=3; len=2.4*g; wide=3.2*g; thick=0.4; start=-80+76*open; bend=50*open; peak=0.6; round=0.8; claw=0.9; paint=4}]_{C1,C3,C5,C7,C9,C11}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 3 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*thick,1,upper)
#define RU3(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*thick,1,middle)
#define RM3(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*thick,1,lower)
#define RL3(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*thick,1,upper)
#define LU3(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*thick,1,middle)
#define LM3(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*thick,1,lower)
#define LL3(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<thick*max(0.25,1-u^3)>,<thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RU2[RU3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RM2[RM3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RL2[RL3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LU2[LU3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LM2[LM3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LL2[LL3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}
`,
	rose: `/* Rose
   about: A double rose: petals in a spiral by the golden angle, rolled within and turned back without; sepals, prickles and leaves of five leaflets.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=185 /* 90 … 310 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1 /* 0.7 … 1.4, of the flower */
#define tall=length*math.random(0.81,1.19)
#define size=scale*math.random(0.93,1.08)
#define petals=floor(math.random(26,32))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define STEM(8,0,0,2.508,20,4.6,4.6,1)
#define WOOD(8,0,0,0,20,4.6,4.6,1)
#define HIP(8,0,0,0,3,6,6,1)
#define CALYX(8,0,0,0,2,9.5,9.5,1)
#define RING(8,0,0,2.508,0.5,9,9,4)
#define SET(8,0,0,0,0.5,9,9,4)
#define finalStep=17+petals

#material 1 stem "6a8048" "7f9a58"
#material 2 leaf "3c6136" "557d48" veins "7ba36a" 7 0.5 feathered name "leaf, upper epidermis"
#material 12 leaf "4c7243" "628a54" name "leaf, mesophyll"
#material 13 leaf "6a8862" "809e74" name "leaf, lower epidermis"
#material 3 sepal "96ac7a" "a4b684" name "sepal, upper epidermis"
#material 14 sepal "7f9a62" "8fa870" name "sepal, mesophyll"
#material 15 sepal "66884a" "7c9a58" name "sepal, lower epidermis"
#material 4 petal "e8a0a6" "d2486a" foot 0.35 bud "b9b070" "b93456" wilted "d9a898" "a85a62" name "petal, upper epidermis"
#material 10 petal "e6aaa6" "d65a78" foot 0.35 bud "b4ac6c" "b83e5c" wilted "d6a496" "a86064" name "petal, mesophyll"
#material 5 petal "e2bca8" "e07e96" foot 0.35 bud "a8a864" "b84a60" wilted "cf9e88" "a8685c" name "petal, lower epidermis"
#material 9 seed "8a4a3a" "7a3a30"

#axiom: STEM
STEM{}{step<13}{} -> WOOD[STEM(,<bend+math.random(-2,2)+1.2*wilt>,<math.random(-2,2)>,,<tall/13>,<4.8-0.07*step>,<4.8-0.07*step>,)]_{E}
STEM{}{step<11}{} -> STEM[&BLADE{S=3; len=math.random(4,6); wide=2.6; thick=1.1; start=18; bend=30; peak=0.5; claw=1; blunt=0.1; paint=9}]_{C(1+(3*step+5)%8)}
STEM{}{step==2||step==5||step==8}{} -> STEM[&ROSELEAF{len=math.random(44,56)}]_{C(1+(3*step)%8)}
STEM{}{step==13}{} -> STEM[HIP(,<14*open+6*wilt>,,,,,,)]_{E}
HIP -> HIP[CALYX(,<16*open+8*wilt>,,,3.4,9,9,)]_{E}
CALYX -> CALYX[RING]_{E}
CALYX -> CALYX[&PETAL{K=8; J=1; len=size*27; wide=size*7; thick=0.7; start=-66+62*open+math.random(-8,8); low=-8+30*open; high=24*open+math.random(-10,20); cup=12; peak=0.6; tip=1.8; claw=0.75; upper=3; middle=14; lower=15}]_{C1,C3,C4,C6,C7}
RING{k=step-15; q=(k/petals)}{step<finalStep-1}{} -> SET[RING(,,,,<0.34*size>,<9-6.5*q>,<9-6.5*q>,)]_{E}[&PETAL{rib=0; K=9; J=3; kept=1-0.97*clamp((wilt-0.4-1.1*q-math.random(0,0.2))/0.28,0,1); len=size*(25+19*open*(1-0.25*q))*(1-0.15*q)*math.random(0.95,1.04); wide=size*(22+28*open)*(1-0.62*q)*math.random(0.94,1.05); thick=0.5; start=-78+(62-66*q)*max(0,open*1.2-0.2*q)+math.random(-5,5)+(26-20*q)*wilt; low=-40*(1-0.6*q)*open; mid=-8-4*q; high=-30+(72*(1-q)^1.4)*open-6*q+math.random(-8,8)+20*wilt; cup=12+22*q+8*(1-open)-3*wilt; edge=-24*(1-q)^2*open; wave=5+10*wilt; waves=2; peak=1.4; foot=0.9; tip=0.55; claw=0.3; spread=4; upper=4; middle=10; lower=5}]_{C(1+(3*step)%8)}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 3 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define kept=1      /* how much of it is left: it withers, hangs and falls */
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define rib=1      /* its middle layer shows along the vein; 0: its epidermises meet over it */
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,kept*len*sin(90/K)^2,kept*thick,kept*thick,middle)
#define VU(4,0,0,0,1,1,1,upper)
#define VD(4,0,0,0,1,1,1,lower)
#define RU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#axiom: VEIN(,start+50*(1-kept),sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<kept*len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<kept*thick*max(0.25,1-u^3)>,<kept*thick*max(0.25,1-u^3)>,)]_{E}
VEIN{}{step<=K&&rib<1}{} -> VEIN[VU(,,,,<0.05*W>,<0.42*W>,H,)]_{C5}[VD(,,,,<0.05*W>,<0.42*W>,H,)]_{C1}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RU2[RU3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RM2[RM3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RL2[RL3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LU2[LU3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LM2[LM3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LL2[LL3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
VU : VU_C1 < VU_C3 -> VU_C1 | VU_C3
VD : VD_C1 < VD_C3 -> VD_C1 | VD_C3
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}

#module ROSELEAF
/* Five leaflets on a rachis. */
#define len=40
#define RACHIS(8,0,0,0,len*0.2,1.4,1.4,1)
#define SPENT(8,0,0,0,len*0.2,1.4,1.4,1)
#define finalStep=12
#axiom: RACHIS(,<-46+math.random(-8,8)>,<math.random(-8,8)>,,,,,)
RACHIS{}{step<10}{} -> SPENT[RACHIS(,<7+math.random(-2,2)>,<math.random(-2,2)>,,,<1.4-0.06*step>,<1.4-0.06*step>,)]_{E}
RACHIS{g=0.74+0.03*step}{step==4||step==8}{} -> RACHIS[&PETAL{K=24; J=1; len=len*g; wide=len*0.66*g; thick=0.6; start=-20; roll=-90; low=14; high=14; cup=4; edge=-6; peak=0.74; foot=0.8; tip=2.3; claw=0.08; teeth=0.26; bites=6; barb=-24; upper=2; middle=12; lower=13}]_{C3}[&PETAL{K=24; J=1; len=len*g; wide=len*0.66*g; thick=0.6; start=-20; roll=90; low=14; high=14; cup=4; edge=-6; peak=0.74; foot=0.8; tip=2.3; claw=0.08; teeth=0.26; bites=6; barb=-24; upper=2; middle=12; lower=13}]_{C7}
RACHIS{}{step==10}{} -> RACHIS[&PETAL{K=24; J=1; len=len*1.1; wide=len*0.74; thick=0.6; low=14; high=14; cup=4; edge=-6; peak=0.74; foot=0.8; tip=2.3; claw=0.08; teeth=0.26; bites=6; barb=-24; upper=2; middle=12; lower=13}]_{E}
`,
	spike: `/* Spike
   about: Flowers without stalks along an axis, the lowest first: gladiolus, all to one side, in bud above.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=480 /* 250 … 760 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define tall=length*math.random(0.88,1.12)
#define flowers=floor(math.random(9,12))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define STEM(12,0,0,0,20,8,8,1)
#define NODE(12,0,0,0,20,7,7,1)
#define DONE(12,0,0,0,20,7,7,1)
#define finalStep=12+flowers

#material 1 stem "6f9150" "86a862"
#material 2 leaf "4a7d45" "639a55" veins "86b474" 4 0.4
#material 3 sepal "7a9c5a" "8fae6c"
#material 4 petal "fbe3c8" "ee7f86" foot 0.35 veins "d65f70" 4 0.35 bud "b8b46c" "d9886c" wilted "c9a088" "a8685c"
#material 5 petal "f6d3b4" "e26d78" veins "c9505f" 4 0.3 bud "b0ae66" "cc7c66" wilted "c0957c" "a06054"
#material 6 stamen "f6e6d8" "f2dcc8"
#material 7 stamen "8a6aa8" "a283bf"
#material 8 petal "f4d060" "f08a86"

#axiom: STEM(,,,50,,,,)
STEM{}{step<10}{} -> STEM[STEM(,<bend+math.random(-0.8,0.8)>,<math.random(-0.8,0.8)>,0,<tall*0.05>,<8-0.2*step>,<8-0.2*step>,)]_{E}
STEM{}{step==0}{} -> STEM[&PETAL{K=13; J=1; len=math.random(300,360); wide=math.random(24,32); thick=1.6; start=-79+math.random(-3,3); low=4; mid=4; high=14; cup=20; peak=0.8; foot=0.5; tip=1.4; claw=0.8; upper=2; middle=2; lower=2}]_{C4,C10}
STEM{}{step==1}{} -> STEM[&PETAL{K=13; J=1; len=math.random(250,300); wide=math.random(22,28); thick=1.6; start=-83+math.random(-3,3); low=3; mid=4; high=10; cup=20; peak=0.8; foot=0.5; tip=1.4; claw=0.8; upper=2; middle=2; lower=2}]_{C5,C11}
STEM{}{step==10}{} -> STEM[NODE]_{E}
NODE{k=step-11; q=k/flowers; o=min(1,max(0,open*1.7-1.25*q))}{step<finalStep-1}{} -> DONE[NODE(,<1.5*(step%2)+math.random(-1,1)>,<math.random(-2,2)>,,<tall*0.5/flowers*(1.35-0.75*q)>,<6.4-4*q>,<6.4-4*q>,)]_{E}[&FLOWER{open=o; wilt=wilt*(1-q); size=(1-0.3*q)*math.random(0.94,1.05); start=-68+34*o}]_{C(12*(1-step%2)+2*(step%2))}

#module FLOWER
#define open=1
#define wilt=0
#define size=1
#define start=-50
#define TUBE(12,0,0,0,5*size,4,4,3)
#define WHORL(12,0,0,0,2,6,6,8)
#define INNER(12,0,0,0,2,5.6,5.6,8)
#define TOP(12,0,0,0,1.4,4,4,6)
#define finalStep=9
#axiom: TUBE(,start,,,,,,)
TUBE{}{step==0}{} -> TUBE[&PETAL{K=7; J=1; len=size*42; wide=size*15; thick=0.9; start=-74; low=-6; cup=30; peak=0.7; tip=1.6; claw=0.9; upper=3; middle=3; lower=3}]_{C1}[&PETAL{K=7; J=1; len=size*36; wide=size*12; thick=0.9; start=-76; low=-6; cup=30; peak=0.7; tip=1.6; claw=0.9; upper=3; middle=3; lower=3}]_{C7}
TUBE{}{step<4}{} -> TUBE[TUBE(,<3+4*open>,,,<size*(3+2*open)>,<4+step*0.4>,<4+step*0.4>,)]_{E}
TUBE{}{step==4}{} -> TUBE[WHORL]_{E}
WHORL -> WHORL[INNER]_{E}
WHORL -> WHORL[&PETAL{K=7; J=1; len=size*(12+32*open); wide=size*(7+23*open); thick=0.7; start=-82+20*open+12*wilt; low=-4+12*open; mid=-6+18*open; high=-24+(52+math.random(-10,10))*open-70*wilt; cup=34-22*open; edge=-5*open; wave=6+8*wilt; waves=3; peak=1.15; foot=0.9; tip=0.9; claw=0.3; upper=8; middle=4; lower=5}]_{C1,C5,C9}
INNER -> INNER[TOP]_{E}
INNER -> INNER[&PETAL{K=7; J=1; len=size*(12+30*open); wide=size*(7+22*open); thick=0.7; start=-84+18*open+12*wilt; low=-4+12*open; mid=-6+16*open; high=-24+(48+math.random(-10,10))*open-70*wilt; cup=34-22*open; edge=-5*open; wave=6+8*wilt; waves=3; peak=1.15; foot=0.9; tip=0.9; claw=0.3; upper=4; middle=4; lower=5}]_{C3,C7,C11}
TOP -> TOP[&STAMEN{long=size*(8+14*open); lean=-84; head=size*(5+3*open)}]_{C5,C7,C9}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 1 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<thick*max(0.25,1-u^3)>,<thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2

#module STAMEN
#define long=5
#define lean=-50
#define head=1.6
#define FILAMENT(4,0,0,0,long/4,1,1,6)
#define ANTHER(4,0,0,0,head/2,1.6,1.2,7)
#define finalStep=6
#axiom: FILAMENT(,lean,,,,,,)
FILAMENT{}{step<3}{} -> FILAMENT[FILAMENT(,<3>,,,,,,)]_{E}
FILAMENT{}{step==3}{} -> FILAMENT[ANTHER]_{E}
ANTHER{}{step<5}{} -> ANTHER[ANTHER]_{E}
`,
	sunflower: `/* Sunflower
   about: Florets in spirals by the golden angle, as faces of a prism of 13 sides give it; rays and bracts round them.
   source: Petrenko 2014, figure 39, whose grammar is not printed; the text is ours
*/

#define length=1040 /* 500 … 1600 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1 /* 0.7 … 1.4, of the flower */
#define tall=length*math.random(0.83,1.17)
#define size=scale*math.random(0.9,1.08)
#define discs=floor(math.random(200,230))
#define rays=floor(math.random(28,38))
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)
#define broad=size*(0.66+0.34*open)
#define radius=46*broad

/* A prism of 13 sides: five on is 138.46 degrees, and each is turned back by 0.954. */
#define STEM(13,0,0,0,60,15,15,1)
#define OLD(13,0,0,0,60,15,15,1)
#define CUP(13,0,0,0,12,70*broad,70*broad,2)
#define BRACTS(13,0,0,0,6,84*broad,84*broad,2)
#define RIM(13,0,0,-0.954,0.12,92*broad,92*broad,2)
#define FULL(13,0,0,0,0,92,92,6)
#define DISC(13,0,0,-0.954,0.06,92*broad,92*broad,6)
#define BARE(13,0,0,0,0,92,92,6)
#define finalStep=15+rays+discs

#material 1 stem "7a944c" "8aa458"
#material 2 sepal "67894a" "80a05c" wilted "78804e" "92905a" name "bract, upper epidermis"
#material 12 sepal "6a8a4c" "84a05e" wilted "788050" "949060" name "bract, mesophyll"
#material 13 sepal "55783a" "6f9048" wilted "6f7440" "8a8450" name "bract, lower epidermis"
#material 3 leaf "3f6a2b" "58863e" veins "86ae62" 7 0.55 feathered wilted "7d8446" "8f8a4c" name "leaf, upper epidermis"
#material 14 leaf "517c38" "68944b" wilted "8c9054" "9c965a" name "leaf, mesophyll"
#material 15 leaf "6a8c54" "82a068" wilted "888e5c" "98946a" name "leaf, lower epidermis"
#material 4 petal "f0a808" "ffe400" foot 0.3 veins "e0a008" 4 0.4 bud "b8a830" "c8b83a" wilted "a8742a" "8f6a30" name "ray, upper epidermis"
#material 10 petal "e8a40c" "f8d808" foot 0.35 bud "b0a030" "c0b038" wilted "a0702a" "8a682e" name "ray, mesophyll"
#material 5 petal "d8a01c" "f0cc34" bud "a8a034" "b4ac40" wilted "9c6c2a" "866230" name "ray, lower epidermis"
#material 6 stamen "5a3a18" "6d4a20"
#material 7 stamen "3c2410" "a8701e" bud "5a6a2c" "7a7a34" wilted "3c2814" "5a4426"
#material 8 stamen "4a4a1c" "76752e" bud "5a6a2c" "7a8838" wilted "3c2c16" "4a3820"
#material 9 stamen "43280f" "5e3a18"

#axiom: STEM
STEM{}{step<10}{} -> OLD[STEM(,<bend+0.5*step+math.random(-0.6,0.6)+2*wilt>,<math.random(-0.6,0.6)>,,<tall*(0.75+0.25*open)/10>,<16-0.3*step>,<16-0.3*step>,)]_{E}
STEM{}{step>1&&step<8}{} -> STEM[&LEAF{len=(240-18*(step-2))*math.random(0.9,1.08)}]_{C(1+(5*step)%13)}
STEM{}{step==10}{} -> STEM[CUP(,<46-10*(1-open)+26*wilt>,,,,,,)]_{E}
CUP -> CUP[BRACTS]_{E}
CUP -> CUP[&PETAL{K=7; J=1; len=size*46; wide=size*22; thick=1.2; start=-64+112*open+math.random(-6,6); low=-12; high=-30+50*open; cup=8; peak=0.75; tip=1.5; claw=0.7; upper=2; middle=12; lower=13}]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12,C13}
BRACTS -> BRACTS[RIM]_{E}
BRACTS -> BRACTS[&PETAL{K=7; J=1; len=size*40; wide=size*20; thick=1.2; start=-84+116*open+math.random(-8,8); low=-16; high=-40+64*open; cup=8; peak=0.75; tip=1.5; claw=0.7; upper=2; middle=12; lower=13}]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12,C13}
RIM{k=step-13; q=k/rays}{k<rays}{} -> FULL[RIM]_{E}[&PETAL{K=8; J=1; len=size*(46+32*open)*math.random(0.92,1.06); wide=size*(14+7*open)*math.random(0.9,1.1); thick=0.7; start=-112+(106-16*q)*open+math.random(-8,8)-60*wilt*math.random(0.6,1.2); sway=math.random(-6,6); low=-20+24*open; high=-26+26*open+math.random(-14,14); cup=12; peak=0.95; tip=1.25; claw=0.3; upper=4; middle=10; lower=5}]_{C(1+(5*step)%13)}
RIM{k=step-13}{k==rays}{} -> FULL[DISC]_{E}
/* Outer florets are open, those within a ring in bud, the middle green. */
DISC{k=step-14-rays; q=k/discs; r=sqrt(max(0.004,1-q))}{step<finalStep-1}{} -> BARE[DISC(,,,,<(0.01+0.03*q)*size>,<2*radius*r>,<2*radius*r>,)]_{E}[&BLADE{S=2; len=broad*(7+4*(q<0.4)*open); wide=broad*5; thick=broad*4.4; start=-62-26*q; claw=0.8; blunt=0.8; paint=7+(q>0.4)*2-(q>0.72)}]_{C(1+(5*step)%13)}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 3 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*thick,1,upper)
#define RU3(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*thick,1,middle)
#define RM3(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*thick,1,lower)
#define RL3(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*thick,1,upper)
#define LU3(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*thick,1,middle)
#define LM3(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*thick,1,lower)
#define LL3(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<thick*max(0.25,1-u^3)>,<thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RU2[RU3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RM2[RM3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RL2[RL3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LU2[LU3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LM2[LM3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LL2[LL3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}

#module LEAF
#define len=150
#define PETIOLE(8,0,0,0,len*0.12,6,5,1)
#define finalStep=6
#axiom: PETIOLE(,<-48+math.random(-8,8)>,<math.random(-8,8)>,,,,,)
PETIOLE{}{step<4}{} -> PETIOLE[PETIOLE(,9,,,,,,)]_{E}
PETIOLE{}{step==4}{} -> PETIOLE[&PETAL{K=12; J=3; len=len; wide=len*0.78; thick=1.4; start=20; low=14; mid=14; high=math.random(0,40); cup=3; wave=5; peak=0.62; foot=0.5; tip=2.1; claw=0.3; fan=24; teeth=0.07; bites=6; upper=3; middle=14; lower=15}]_{E}
`,
	"table-3": `/* Table 3
   about: The thesis's example of a grammar: a stem, a receptacle and four petals, each a module.
   source: Petrenko 2014, Table 3, in full; the module PTULIP is only named there and is ours
*/
@volume description@
#define STEM(21,1,0,0,0,1,1,6)
#define RECEPTACLE(21,1,0,0,0,3,1,1,6)
#define PETAL(4,1,0,0,0,0,5,0.5,1,4)

@variable and function definition@
#define rd=7

#axiom: STEM

@production rules@
p00 STEM{ } {step<4} { }->STEM[STEM(,,,,,4.1,5,1.5,)]_ {E}
p00 STEM{ } {step>=4} { }->STEM[STEM(,,,,,,)]_ {E}
p00 STEM{ } {step>=finalStep-10} { }->STEM[RECEPTACLE(,,,,,,)]_ {E}
p00 RECEPTACLE->RECEPTACLE[PETAL(4,1,0,2,0,1,1,1,4)]_ {C5}
p00 RECEPTACLE->RECEPTACLE[PETAL(4,1,0,-3,0,1,1,1,4)]_ {C9}
p00 RECEPTACLE->RECEPTACLE[PETAL( , , <math.random(0,rd)>,,,,)]_ {C13}
p00 RECEPTACLE->RECEPTACLE[PETAL( , , <math.random(0,rd)>,,,,)]_ {C17}
p00 PETAL->PETAL[&PTULIP(16,1,0,0,3,0.1,0.1,4)]_ {E}

#define finalStep=16

#module PTULIP
#define VEIN(8,0,0,0,3,0.1,0.1,4)
#define finalStep=10
#axiom: VEIN
p1 VEIN -> VEIN[VEIN(,<8-1.4*step>,,,2.5,2+sin(18*step),,)]_{E}
`,
	tulip: `/* Tulip
   about: Two whorls of three tepals, two of three stamens, three carpels grown together; two leaves.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=325 /* 160 … 530 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define scale=1 /* 0.7 … 1.4, of the flower */
#define tall=length*math.random(0.83,1.17)
#define size=scale*math.random(0.92,1.08)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)
/* Tepals fall one by one, stamens wither after them; what stays is the ovary, which swells. */
#define shed=clamp((wilt-0.55)/0.4,0,1)

#define STEM(12,0,0,0,20,6.4,6.4,1)
#define LOWER(12,0,0,0,4,7,7,1)
#define UPPER(12,0,0,0,4,6.6,6.6,1)
#define RECEPTACLE(12,0,0,0,2.4,9.5,9.5,10)
#define BASE(12,0,0,0,2.4,8.6,8.6,10)
#define TOP(12,0,0,0,1.2,6.4,6.4,10)
#define finalStep=22

#material 1 stem "7f9a55" "9ab36c"
#material 2 leaf "587f58" "6c9a64" wilted "648454" "8a9a5c" name "leaf, upper epidermis"
#material 12 leaf "65895e" "77a06a" wilted "7f9a62" "98a468" name "leaf, mesophyll"
#material 13 leaf "6b8f6c" "80a67a" wilted "72906a" "92a26c" name "leaf, lower epidermis"
#material 4 petal "e9b53a" "c21d2c" foot 0.4 veins "8e0f1e" 7 0.22 bud "7d9c50" "94a254" wilted "c9a060" "8c4238" name "tepal, lower epidermis"
#material 5 petal "d8a23a" "d4343c" foot 0.4 bud "8aa45c" "a0a45c" wilted "c9a060" "984a40" name "tepal, upper epidermis"
#material 11 petal "e9b53a" "c21d2c" foot 0.4 bud "7d9c50" "94a254" wilted "c9a060" "8c4238" name "tepal, mesophyll"
#material 6 stamen "e8dfa5" "d8c987"
#material 7 stamen "2f2633" "40313f"
#material 8 pistil "a3b873" "bccb86"
#material 9 pistil "e3dfa0" "efe9b5"
#material 10 petal "a3b45c" "bdb650" bud "8ba85c" "94ae64" wilted "8aa35a" "98ac66"

#axiom: STEM
STEM{}{step<16}{} -> STEM[STEM(,<bend+math.random(-0.8,0.8)+1.5*wilt>,<math.random(-0.8,0.8)>,,<tall*(0.8+0.2*open)/16>,<6.4-0.05*step>,<6.4-0.05*step>,)]_{E}
STEM{}{step==1}{} -> STEM[LOWER]_{E}
STEM{}{step==3}{} -> STEM[UPPER]_{E}
LOWER -> LOWER[STEM]_{E}
LOWER -> LOWER[&PETAL{K=14; J=3; len=math.random(200,250); wide=math.random(44,60); thick=1.6; start=-70+math.random(-5,5)-8*(1-open); low=10; mid=10; high=25+math.random(0,30)+40*wilt; cup=16-4*open; wave=5; peak=0.8; foot=0.5; tip=2.1; claw=0.3; upper=2; middle=12; lower=13}]_{C1}
UPPER -> UPPER[STEM]_{E}
UPPER -> UPPER[&PETAL{K=14; J=3; len=math.random(150,190); wide=math.random(26,36); thick=1.4; start=-72+math.random(-5,5)-8*(1-open); low=6; mid=8; high=14+math.random(0,20)+30*wilt; cup=17-4*open; wave=4; peak=0.8; foot=0.5; tip=2.1; claw=0.3; upper=2; middle=12; lower=13}]_{C7}
STEM{}{step==16}{} -> STEM[RECEPTACLE(,<6*open>,,,,,,)]_{E}
RECEPTACLE -> RECEPTACLE[BASE]_{E}
RECEPTACLE -> RECEPTACLE[&PETAL{kept=1-0.985*clamp((wilt-math.random(0.45,0.68))/0.28,0,1); len=size*(38+27*open); wide=size*(22+14*open); thick=1.1; start=-30+22*open+math.random(-2,2)+30*wilt; low=-70-open*8; mid=-2+wilt*20; high=-32+40*open+math.random(-4,4)+50*wilt; cup=20-7*open-6*wilt; peak=0.9; foot=0.85; tip=1.6; claw=0.22; wave=10*wilt; upper=5; middle=11}]_{C1,C5,C9}
BASE -> BASE[TOP]_{E}
BASE -> BASE[&PETAL{kept=1-0.985*clamp((wilt-math.random(0.5,0.72))/0.28,0,1); len=size*(36+25*open); wide=size*(22+13*open); thick=1; start=-38+22*open+math.random(-2,2)+22*wilt; low=-64-open*10; mid=-2+wilt*12; high=-32+36*open+math.random(-4,4)+30*wilt; cup=21-7*open-5*wilt; peak=0.92; foot=0.9; tip=1.45; claw=0.22; wave=10*wilt; upper=5; middle=11}]_{C3,C7,C11}
TOP -> TOP[&STAMEN]_{C1,C3,C5,C7,C9,C11}
TOP -> TOP[&PISTIL]_{E}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 3 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define kept=1      /* how much of it is left: it withers, hangs and falls */
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,kept*len*sin(90/K)^2,kept*thick,kept*thick,middle)
#define RU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define RL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LU3(4,0,0,0,1,0.3*kept*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LM3(4,0,0,0,1,0.3*kept*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*kept*thick,1,lower)
#define LL3(4,0,0,0,1,0.3*kept*thick,1,lower)
#axiom: VEIN(,start+50*(1-kept),sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<kept*len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<kept*thick*max(0.25,1-u^3)>,<kept*thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=kept*wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RU2[RU3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RM2[RM3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RL2[RL3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LU2[LU3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LM2[LM3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LL2[LL3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2

#module STAMEN
#define FILAMENT(6,0,0,0,2,1.7,1.7,6)
#define ANTHER(6,0,0,0,2.2,2.8,2,7)
#define finalStep=14
#axiom: FILAMENT(,<-48+math.random(-5,5)-14*(1-open)>,,,,,,)
FILAMENT{}{step<7}{} -> FILAMENT[FILAMENT(,<-5+math.random(-1,1)+9*shed>,,,<(1+open)*(1-0.85*shed)>,<1.4-1.2*shed>,<1.4-1.2*shed>,)]_{E}
FILAMENT{}{step==7}{} -> FILAMENT[ANTHER(,0,,,<1-0.9*shed>,<2.2-2*shed>,<1.6-1.4*shed>,)]_{E}
ANTHER{}{step<13}{} -> ANTHER[ANTHER(,0,,,<(1.9+0.9*open)*(1-0.97*shed)>,<(3.6-0.12*(step-9)^2)*(1-0.97*shed)>,<(2.4-0.08*(step-9)^2)*(1-0.97*shed)>,)]_{E}

#module PISTIL
#define OVARY(6,0,0,0,2,5,5,8)
#define STIGMA(6,0,0,0,1.5,6.4,6.4,9)
#define LOBE(4,0,0,0,2.5,2,2,9)
#define finalStep=14
#axiom: OVARY
OVARY{}{step<10}{} -> OVARY[OVARY(,,,,<1.4+1.2*open+0.5*wilt>,<(5.8-0.05*(step-4)^2)*(1+wilt*sin(18*step))>,<(5.8-0.05*(step-4)^2)*(1+wilt*sin(18*step))>,)]_{E}
OVARY{}{step==10}{} -> OVARY[STIGMA]_{E}
STIGMA -> STIGMA[LOBE]_{C1,C3,C5}
LOBE{}{step<13}{} -> LOBE[LOBE(,25,,,1.6,1.8,1.6,)]_{E}
`,
	umbel: `/* Umbel
   about: Flowers on stalks from one point: an ornamental onion, a ball of stars.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define length=180 /* 90 … 290 mm, of the stem */
#define bend=0 /* -5 … 5 step 0.1, degrees a step, of the stem */
#define tall=length*math.random(0.83,1.17)
#define flowers=floor(math.random(64,80))
#define ball=math.random(30,36)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define SHEATH(13,0,0,0,6,12,12,2)
#define STEM(13,0,0,0,20,5,5,1)
#define NECK(13,0,0,0,2,5,5,1)
#define HEAD(13,0,0,-0.954,0.1,7,7,1)
#define BARE(13,0,0,0,0,7,7,1)
#define finalStep=18+flowers

#material 1 stem "7f9c62" "8fa878"
#material 2 leaf "5f8a62" "7ba37a"
#material 3 sepal "8a6f96" "a588b0"
#material 4 petal "8a4fae" "b883d6" veins "6e3596" 1 0.5 bud "7d6f8a" "8f6aa8" wilted "9a8a94" "a8988c"
#material 6 stamen "a86cc8" "cda6e2"
#material 8 pistil "5f7a48" "6f8a55"

#axiom: SHEATH
SHEATH{}{step<3}{} -> SHEATH[SHEATH(,,,,6,<12-2.4*step>,<12-2.4*step>,)]_{E}
SHEATH{}{step==0}{} -> SHEATH[&PETAL{K=12; J=1; len=math.random(130,170); wide=math.random(20,28); thick=1.4; start=-52+math.random(-10,10); sway=math.random(-8,8); low=14; mid=20; high=math.random(30,80); cup=12; peak=0.8; foot=0.5; tip=1.4; claw=0.8; upper=2; middle=2; lower=2}]_{C1,C4,C6,C9,C11}
SHEATH{}{step==3}{} -> SHEATH[STEM]_{E}
STEM{}{step<14}{} -> STEM[STEM(,<bend+math.random(-0.8,0.8)>,<math.random(-0.8,0.8)>,,<tall/10>,5,5,)]_{E}
STEM{}{step==14}{} -> STEM[NECK]_{E}
NECK -> NECK[HEAD]_{E}
NECK -> NECK[&BLADE{len=14; wide=9; thick=0.5; start=-60+130*open; peak=0.8; claw=0.9; paint=3}]_{C1,C7}
HEAD{q=(step-16)/flowers; r=sqrt(max(0.02,1-(2*q-1)^2*0.96)); o=min(1,max(0,open*1.5-0.5*q))}{step<finalStep-1}{} -> BARE[HEAD(,,,,<6.6/flowers>,<7.6*r>,<7.6*r>,)]_{E}[&FLOWER{start=-90*(2*q-1)*0.97+math.random(-5,5); sway=math.random(-5,5); long=ball*(0.3+0.7*open)*math.random(0.92,1.05); open=o; wilt=wilt}]_{C(1+(5*step)%13)}

#module FLOWER
#define start=0
#define sway=0
#define long=30
#define open=1
#define wilt=0
#define STALK(6,0,0,0,long/3,0.7,0.7,1)
#define CUP(6,0,0,0,0.6,1.6,1.6,8)
#define OVARY(6,0,0,0,1.1,1.9,1.9,8)
#define finalStep=6
#axiom: STALK(,start,sway,,,,,)
STALK{}{step<2}{} -> STALK[STALK(,<math.random(-4,4)>,<math.random(-4,4)>,,,,,)]_{E}
STALK{}{step==2}{} -> STALK[CUP]_{E}
CUP -> CUP[OVARY]_{E}
CUP -> CUP[&BLADE{S=4; len=(3.4+4*open)*(1-0.3*wilt); wide=1.2+0.9*open; thick=0.35; start=-84+74*open+30*wilt; bend=-6+12*open+60*wilt; peak=0.8; round=0.9; claw=0.6; paint=4}]_{C1,C2,C3,C4,C5,C6}
OVARY -> OVARY[&BLADE{S=2; len=1.4+3.2*open; wide=0.3; thick=0.3; start=-56; claw=1; blunt=0.6; paint=6}]_{C1,C3,C5}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 1 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<thick*max(0.25,1-u^3)>,<thick*max(0.25,1-u^3)>,)]_{E}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}
`,
	"water-lily": `/* Water lily
   about: Petals in a spiral by the golden angle that pass into stamens, over a leaf that floats.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/

#define scale=1.05 /* 0.7 … 1.4, of the flower */
#define size=scale*math.random(0.92,1.08)
#define petals=floor(math.random(20,26))
#define pad=math.random(165,205)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)

#define PAD(8,0,0,0,3,12,12,1)
#define CUP(8,0,0,0,3,17,17,2)
#define RING(8,0,0,2.508,0.5,17,17,4)
#define SET(8,0,0,0,0.5,17,17,4)
#define HEART(12,0,0,11,0.7,9,9,6)
#define TOP(12,0,0,0,1.6,8,8,8)
#define finalStep=petals+10

#material 1 stem "6d7a45" "7d8a55"
#material 3 sepal "eef0dc" "f8f6ee" bud "e6ead0" "f2f2e4" wilted "e0dcc0" "d0c4a0" name "sepal, upper epidermis"
#material 7 sepal "aebd84" "c4cc9c" name "sepal, mesophyll"
#material 2 sepal "6f8a4c" "8fa468" margin "d4d8b8" 0.2 name "sepal, lower epidermis"
#material 4 petal "e9ecdc" "f3f5f8" foot 0.5 light 0.25 bud "eef0dc" "fdf6f0" wilted "e6e2cc" "e0cfc0" name "petal, upper epidermis"
#material 11 petal "e2e4d2" "eaecec" foot 0.5 light 0.25 bud "e8ead2" "f4efe6" wilted "dedabf" "d6c4b4" name "petal, mesophyll"
#material 5 petal "dde2cc" "eae9ee" foot 0.5 light 0.25 wilted "dcd6bc" "d8b8b0" name "petal, lower epidermis"
#material 6 stamen "eeb92c" "f4cf4a" wilted "b08a30" "a08038"
#material 8 pistil "e0c552" "ecd87a"
#material 9 leaf "4a7a42" "3f6b3a" veins "7aa062" 8 0.5 light 0.2 name "leaf, upper epidermis"
#material 12 leaf "6f8a58" "5f7c4c" light 0.2 name "leaf, mesophyll"
#material 10 leaf "7d5a52" "8a5f5a" light 0.2 name "leaf, lower epidermis"

#axiom: PAD
PAD -> PAD[CUP]_{E}
PAD -> PAD[&PETAL{K=14; J=5; len=pad; wide=pad*0.95; thick=1.6; start=1; low=0.5; cup=0; wave=2; waves=5; foot=0.4; tip=0.95; claw=0.62; fan=80; upper=9; middle=12; lower=10}]_{C7}
CUP -> CUP[RING]_{E}
CUP -> CUP[&PETAL{K=8; J=2; len=size*(57+5*open); wide=size*24; thick=1.4; start=-46+42*open-34*wilt; low=-44+22*open-16*wilt; mid=-2; high=-40+30*open-22*wilt; cup=18-6*open; peak=0.95; tip=1.1; claw=0.4; upper=3; middle=7; lower=2}]_{C1,C3,C5,C7}
RING{q=(step-2)/petals}{step<petals+2}{} -> SET[RING(,,,,<0.34*size>,<17-7*q>,<17-7*q>,)]_{E}[&PETAL{rib=0; K=8; J=2; len=size*(40+22*open)*(1-0.3*q)*math.random(0.97,1.03); wide=size*(25-8*q)*(0.8+0.2*open); thick=0.7; start=-56+(54-30*q)*open-6*q+math.random(-4,4)-(48-26*q)*wilt; low=-34+(10-12*q)*open-10*wilt; mid=-4; high=-34+30*open-22*wilt; cup=19-6*open; peak=0.9; tip=1.5; claw=0.4; upper=4; middle=11; lower=5}]_{C(1+(3*step)%8)}
RING{}{step==petals+2}{} -> RING[HEART]_{E}
HEART{}{step<petals+7}{} -> HEART[HEART]_{E}
HEART{}{step==petals+7}{} -> HEART[TOP]_{E}
HEART{}{step<petals+8}{} -> HEART[&BLADE{S=5; len=size*(12+4*open)*math.random(0.88,1.08)*(1-0.05*(step-petals-3)); wide=1.9-0.15*(step-petals-3); thick=0.6; start=-78+26*open-3*(step-petals-3)+math.random(-7,7); bend=-30; peak=0.7; round=0.4; claw=0.9; blunt=0.5; paint=6}]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12}

#module PETAL
/* A vein of K segments that thins towards its tip; on its right and left J lobes in three layers, glued (section 2.2.3),
   thinner from one to the next. A call says which. */
#define K=12       /* segments */
#define J=3        /* lobes to a side, at most 5 */
#define len=40     /* mm */
#define wide=20
#define thick=0.8
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define sway=0     /* to a side */
#define roll=0     /* about itself */
#define low=0      /* how far its lower, middle and upper third bend; below 0 inwards */
#define mid=0
#define high=0
#define cup=8      /* a lobe, towards the upper side */
#define edge=0     /* more of it at the margin */
#define wave=0     /* and waves along the margin, so many of them */
#define waves=3
#define peak=1     /* where it is widest: above 1 beyond the middle */
#define foot=1     /* how it ends: 1 round, 2 pointed, 0.5 blunt */
#define tip=1
#define claw=0     /* as wide at its foot, a share */
#define fan=0      /* how far lobes at the foot turn back, and those at the tip forward */
#define spread=0
#define teeth=0    /* how deep, a share, and how many; how far they point back */
#define bites=6
#define barb=0
#define rib=1      /* its middle layer shows along the vein; 0: its epidermises meet over it */
#define upper=4
#define middle=4
#define lower=4
#define phase=math.random(0,360)
#define finalStep=30
#define VEIN(8,0,0,0,len*sin(90/K)^2,thick,thick,middle)
#define VU(4,0,0,0,1,1,1,upper)
#define VD(4,0,0,0,1,1,1,lower)
#define RU1(4,0,0,0,1,0.3*thick,1,upper)
#define RU2(4,0,0,0,1,0.3*thick,1,upper)
#define RU3(4,0,0,0,1,0.3*thick,1,upper)
#define RU4(4,0,0,0,1,0.3*thick,1,upper)
#define RU5(4,0,0,0,1,0.3*thick,1,upper)
#define RM1(4,0,0,0,1,0.3*thick,1,middle)
#define RM2(4,0,0,0,1,0.3*thick,1,middle)
#define RM3(4,0,0,0,1,0.3*thick,1,middle)
#define RM4(4,0,0,0,1,0.3*thick,1,middle)
#define RM5(4,0,0,0,1,0.3*thick,1,middle)
#define RL1(4,0,0,0,1,0.3*thick,1,lower)
#define RL2(4,0,0,0,1,0.3*thick,1,lower)
#define RL3(4,0,0,0,1,0.3*thick,1,lower)
#define RL4(4,0,0,0,1,0.3*thick,1,lower)
#define RL5(4,0,0,0,1,0.3*thick,1,lower)
#define LU1(4,0,0,0,1,0.3*thick,1,upper)
#define LU2(4,0,0,0,1,0.3*thick,1,upper)
#define LU3(4,0,0,0,1,0.3*thick,1,upper)
#define LU4(4,0,0,0,1,0.3*thick,1,upper)
#define LU5(4,0,0,0,1,0.3*thick,1,upper)
#define LM1(4,0,0,0,1,0.3*thick,1,middle)
#define LM2(4,0,0,0,1,0.3*thick,1,middle)
#define LM3(4,0,0,0,1,0.3*thick,1,middle)
#define LM4(4,0,0,0,1,0.3*thick,1,middle)
#define LM5(4,0,0,0,1,0.3*thick,1,middle)
#define LL1(4,0,0,0,1,0.3*thick,1,lower)
#define LL2(4,0,0,0,1,0.3*thick,1,lower)
#define LL3(4,0,0,0,1,0.3*thick,1,lower)
#define LL4(4,0,0,0,1,0.3*thick,1,lower)
#define LL5(4,0,0,0,1,0.3*thick,1,lower)
#axiom: VEIN(,start,sway,roll,,,,)
VEIN{u=(1-cos(180*(step+1)/K))/2}{step<K}{} -> VEIN[VEIN(,<3*(low*(1-u)^2+2*mid*u*(1-u)+high*u^2)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*max(0.04,sin(180*(step+1.5)/K))>,<thick*max(0.25,1-u^3)>,<thick*max(0.25,1-u^3)>,)]_{E}
VEIN{}{step<=K&&rib<1}{} -> VEIN[VU(,,,,<0.05*W>,<0.42*W>,H,)]_{C5}[VD(,,,,<0.05*W>,<0.42*W>,H,)]_{C1}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[RU1(,f,<-45+cup/2>,,w,<0.3*W>,H,)]_{C4}[RM1(,f,<cup/2>,,w,<0.3*W>,H,)]_{C3}[RL1(,f,<45+cup/2>,,w,<0.3*W>,H,)]_{C2}
VEIN{s=step/K; w=wide/2/J*max(0.004,max(claw*max(0,1-1.6*s),sin(180*s^peak)^(foot+(tip-foot)*s)))*(1-teeth*(0.5+0.5*cos(360*bites*s))); f=barb+fan*max(0,1-4*s)-spread*max(0,4*s-3)}{step<=K}{} -> VEIN[LU1(,f,<45-cup/2>,,w,<0.3*W>,H,)]_{C6}[LM1(,f,<-cup/2>,,w,<0.3*W>,H,)]_{C7}[LL1(,f,<-45-cup/2>,,w,<0.3*W>,H,)]_{C8}
RU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RU1[RU2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RM1[RM2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> RL1[RL2(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LU1[LU2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LM1[LM2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL1{r=wave*1/J*sin(360*waves*(step-1)/K+phase)+(J==2)*edge}{J>1}{} -> LL1[LL2(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RU2[RU3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RM2[RM3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> RL2[RL3(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LU2[LU3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LM2[LM3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL2{r=wave*2/J*sin(360*waves*(step-2)/K+phase)+(J==3)*edge}{J>2}{} -> LL2[LL3(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> RU3[RU4(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> RM3[RM4(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> RL3[RL4(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> LU3[LU4(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> LM3[LM4(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL3{r=wave*3/J*sin(360*waves*(step-3)/K+phase)+(J==4)*edge}{J>3}{} -> LL3[LL4(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
RU4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> RU4[RU5(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RM4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> RM4[RM5(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
RL4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> RL4[RL5(,,<cup+r>,,H,<0.8*L>,W,)]_{E}
LU4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> LU4[LU5(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LM4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> LM4[LM5(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
LL4{r=wave*4/J*sin(360*waves*(step-4)/K+phase)+(J==5)*edge}{J>4}{} -> LL4[LL5(,,<-cup-r>,,H,<0.8*L>,W,)]_{E}
VU : VU_C1 < VU_C3 -> VU_C1 | VU_C3
VD : VD_C1 < VD_C3 -> VD_C1 | VD_C3
RU1 : RU1_C1 < RU1_C3 -> RU1_C1 | RU1_C3
LU1 : LU1_C1 < LU1_C3 -> LU1_C1 | LU1_C3
RM1 : RM1_C1 < RM1_C3 -> RM1_C1 | RM1_C3
LM1 : LM1_C1 < LM1_C3 -> LM1_C1 | LM1_C3
RL1 : RL1_C1 < RL1_C3 -> RL1_C1 | RL1_C3
LL1 : LL1_C1 < LL1_C3 -> LL1_C1 | LL1_C3
RL1 : RL1_C2 < RM1_C4 -> RL1_C2 | RM1_C4
RM1 : RM1_C2 < RU1_C4 -> RM1_C2 | RU1_C4
LL1 : LL1_C4 < LM1_C2 -> LL1_C4 | LM1_C2
LM1 : LM1_C4 < LU1_C2 -> LM1_C4 | LU1_C2
RU2 : RU2_C1 < RU2_C3 -> RU2_C1 | RU2_C3
LU2 : LU2_C1 < LU2_C3 -> LU2_C1 | LU2_C3
RM2 : RM2_C1 < RM2_C3 -> RM2_C1 | RM2_C3
LM2 : LM2_C1 < LM2_C3 -> LM2_C1 | LM2_C3
RL2 : RL2_C1 < RL2_C3 -> RL2_C1 | RL2_C3
LL2 : LL2_C1 < LL2_C3 -> LL2_C1 | LL2_C3
RL2 : RL2_C2 < RM2_C4 -> RL2_C2 | RM2_C4
RM2 : RM2_C2 < RU2_C4 -> RM2_C2 | RU2_C4
LL2 : LL2_C4 < LM2_C2 -> LL2_C4 | LM2_C2
LM2 : LM2_C4 < LU2_C2 -> LM2_C4 | LU2_C2
RU3 : RU3_C1 < RU3_C3 -> RU3_C1 | RU3_C3
LU3 : LU3_C1 < LU3_C3 -> LU3_C1 | LU3_C3
RM3 : RM3_C1 < RM3_C3 -> RM3_C1 | RM3_C3
LM3 : LM3_C1 < LM3_C3 -> LM3_C1 | LM3_C3
RL3 : RL3_C1 < RL3_C3 -> RL3_C1 | RL3_C3
LL3 : LL3_C1 < LL3_C3 -> LL3_C1 | LL3_C3
RL3 : RL3_C2 < RM3_C4 -> RL3_C2 | RM3_C4
RM3 : RM3_C2 < RU3_C4 -> RM3_C2 | RU3_C4
LL3 : LL3_C4 < LM3_C2 -> LL3_C4 | LM3_C2
LM3 : LM3_C4 < LU3_C2 -> LM3_C4 | LU3_C2
RU4 : RU4_C1 < RU4_C3 -> RU4_C1 | RU4_C3
LU4 : LU4_C1 < LU4_C3 -> LU4_C1 | LU4_C3
RM4 : RM4_C1 < RM4_C3 -> RM4_C1 | RM4_C3
LM4 : LM4_C1 < LM4_C3 -> LM4_C1 | LM4_C3
RL4 : RL4_C1 < RL4_C3 -> RL4_C1 | RL4_C3
LL4 : LL4_C1 < LL4_C3 -> LL4_C1 | LL4_C3
RL4 : RL4_C2 < RM4_C4 -> RL4_C2 | RM4_C4
RM4 : RM4_C2 < RU4_C4 -> RM4_C2 | RU4_C4
LL4 : LL4_C4 < LM4_C2 -> LL4_C4 | LM4_C2
LM4 : LM4_C4 < LU4_C2 -> LM4_C4 | LU4_C2
RU5 : RU5_C1 < RU5_C3 -> RU5_C1 | RU5_C3
LU5 : LU5_C1 < LU5_C3 -> LU5_C1 | LU5_C3
RM5 : RM5_C1 < RM5_C3 -> RM5_C1 | RM5_C3
LM5 : LM5_C1 < LM5_C3 -> LM5_C1 | LM5_C3
RL5 : RL5_C1 < RL5_C3 -> RL5_C1 | RL5_C3
LL5 : LL5_C1 < LL5_C3 -> LL5_C1 | LL5_C3
RL5 : RL5_C2 < RM5_C4 -> RL5_C2 | RM5_C4
RM5 : RM5_C2 < RU5_C4 -> RM5_C2 | RU5_C4
LL5 : LL5_C4 < LM5_C2 -> LL5_C4 | LM5_C2
LM5 : LM5_C4 < LU5_C2 -> LM5_C4 | LU5_C2

#module BLADE
/* A small petal or hair: a chain of S flat prisms. */
#define S=5
#define len=6      /* mm */
#define wide=3
#define thick=0.3
#define start=0    /* degrees: 0 stands out, -90 stands up */
#define bend=0     /* over all of it */
#define high=0     /* more of it towards the tip */
#define peak=1     /* where it is widest, and how it ends, as PETAL's */
#define round=1
#define claw=0.2
#define blunt=0.1
#define paint=4
#define finalStep=12
#define B(4,0,0,0,len/S,wide*max(claw,sin(180*(1/S)^peak)^round),thick,paint)
#axiom: B(,start,,,,,,)
B{s=(step+2)/S}{step<S-1}{} -> B[B(,<bend/S+high*(2*step+1)/S^2>,,,,<wide*max(max(claw*(1-s),blunt),sin(180*min(1,s)^peak)^round)>,,)]_{E}
`,
};
