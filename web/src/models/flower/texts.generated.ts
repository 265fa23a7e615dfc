// Made from wasm-core/grammars/flower by wasm-core/tools/generate.mjs; edit the texts, not this.

/** The texts of presets by their names: loaded when the first is grown. */
export const TEXTS: Readonly<Record<string, string>> = {
	bluebell: `/* Bluebell
   about: A one-sided raceme of nodding bells, each of six tepals that roll back.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/
#define length=260
#define STEM(12,0,0,0,20,3.4,3.4,1)
#define NODE(12,0,0,0,5,2.8,2.8,1)
#define REACH(12,0,2,0,9,2.4,2.4,1)
#define finalStep=27

#material 1 stem "6c8450" "5f6f78"
#material 2 leaf "3f7038" "4f8044"
#material 4 petal "5a5fc0" "6a72d6"
#material 5 petal "4a50ae" "7a86e2"
#material 6 stamen "d9d6ea" "e6e0c0"

#axiom: STEM
STEM{}{step==0}{} -> STEM[STEM]_{E}
STEM{}{step==0}{} -> STEM[&LEAF]_{C1,C5,C9}
STEM{}{step>0&&step<12}{} -> STEM[STEM(,,1,,16,3.2,3.2,)]_{E}
STEM{}{step==12}{} -> STEM[NODE]_{E}
NODE{}{step<25}{} -> NODE[REACH]_{E}
REACH{n=step-13}{step<25}{} -> REACH[NODE(,,<1+0.6*n>,<-12+math.random(-20,20)>,<14-0.5*n>,<2.8-0.12*n>,<2.8-0.12*n>,)]_{E}
NODE -> NODE[&BELL]_{C4}

#module BELL
#define STALK(12,0,0,0,2,1,1,1)
#define RECEPTACLE(12,0,0,0,1.4,3.2,3.2,4)
#define finalStep=7
#define size=math.random(0.9,1.05)
#axiom: STALK(,<math.random(5,20)>,,,,,,)
STALK{}{step<4}{} -> STALK[STALK(,15,,,2.4,,,)]_{E}
STALK{}{step==4}{} -> STALK[RECEPTACLE]_{E}
RECEPTACLE -> RECEPTACLE[&TEPAL]_{C1,C3,C5,C7,C9,C11}

#module TEPAL
#define K=9
#define len=18
#define half=6/2
#define t=0.5
#define cup=12
#define finalStep=11
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,4)
#define RU1(4,0,0,0,1,t,1,4)
#define RU2(4,0,0,0,1,t,1,4)
#define RM1(4,0,0,0,1,t,1,4)
#define RM2(4,0,0,0,1,t,1,4)
#define RL1(4,0,0,0,1,t,1,5)
#define RL2(4,0,0,0,1,t,1,5)
#define LU1(4,0,0,0,1,t,1,4)
#define LU2(4,0,0,0,1,t,1,4)
#define LM1(4,0,0,0,1,t,1,4)
#define LM2(4,0,0,0,1,t,1,4)
#define LL1(4,0,0,0,1,t,1,5)
#define LL2(4,0,0,0,1,t,1,5)
#axiom: VEIN(, -60+math.random(-4,4), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(-50+640*max(0,u-0.6))*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,H,)]_{C6}
RL1{s=(step-1)/K}{}{} -> RL1[RL2(,0,cup,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,,)]_{E}
RM1{s=(step-1)/K}{}{} -> RM1[RM2(,0,cup,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,,)]_{E}
RU1{s=(step-1)/K}{}{} -> RU1[RU2(,0,cup,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,,)]_{E}
LL1{s=(step-1)/K}{}{} -> LL1[LL2(,0,-cup,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,,)]_{E}
LM1{s=(step-1)/K}{}{} -> LM1[LM2(,0,-cup,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,,)]_{E}
LU1{s=(step-1)/K}{}{} -> LU1[LU2(,0,-cup,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/2>,0.3*t,,)]_{E}
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

#module LEAF
#define K=12
#define len=210
#define half=11/2
#define t=0.9
#define cup=10
#define finalStep=13
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,2)
#define RU1(4,0,0,0,1,t,1,2)
#define RM1(4,0,0,0,1,t,1,2)
#define RL1(4,0,0,0,1,t,1,2)
#define LU1(4,0,0,0,1,t,1,2)
#define LM1(4,0,0,0,1,t,1,2)
#define LL1(4,0,0,0,1,t,1,2)
#axiom: VEIN(, -62+math.random(-10,10), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(2-20*u+60*u^2)*0.6>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C6}
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
`,
	daisy: `/* Daisy
   about: A head of white rays round a dome of yellow florets in spirals by the golden angle.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/
#define length=48
#define discs=72
#define radius=4.2
#define STEM(12,0,0,0,24,1.4,1.4,1)
#define CUP(21,0,0,0,1.2,7.2,7.2,2)
#define RIM(21,0,0,0,0.5,8.4,8.4,2)
#define DISC(21,0,0,0.365,0.05,8.4,8.4,6)
#define BARE(21,0,0,0,0,8.4,8.4,6)
#define finalStep=86

#material 1 stem "6f8f4a" "87a65c"
#material 2 sepal "5f8444" "7a9c56"
#material 4 petal "fbfaf4" "ffffff"
#material 5 petal "f6f0ee" "eec9d2"
#material 6 stamen "d9a922" "e8bd2f"

#axiom: STEM
STEM{}{step<8}{} -> STEM[STEM(,<math.random(-2,2)>,<math.random(-2,2)>,,<length/8>,,,)]_{E}
STEM{}{step==8}{} -> STEM[CUP]_{E}
CUP -> CUP[RIM]_{E}
CUP -> CUP[&BRACT]_{C1,C3,C5,C7,C9,C11,C13,C15,C17,C19,C21}
RIM -> RIM[DISC]_{E}
RIM -> RIM[&RAY]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12,C13,C14,C15,C16,C17,C18,C19,C20,C21}
DISC{k=step-11;r=sqrt(max(0.02,1-k/discs))}{step<finalStep-1}{} -> BARE[DISC(,,,,<0.03+0.08*k/discs>,<2*radius*r>,<2*radius*r>,)]_{E}[&FLORET(,<-40-50*k/discs>,,,,,,)]_{C(1+8*k%21)}

#module RAY
#define K=6
#define len=9
#define half=2.6/2
#define t=0.25
#define cup=8
#define finalStep=7
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,4)
#define RU1(4,0,0,0,1,t,1,4)
#define RM1(4,0,0,0,1,t,1,4)
#define RL1(4,0,0,0,1,t,1,5)
#define LU1(4,0,0,0,1,t,1,4)
#define LM1(4,0,0,0,1,t,1,4)
#define LL1(4,0,0,0,1,t,1,5)
#axiom: VEIN(, -14+math.random(-9,9), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(-20+30*u)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/1>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/1>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/1>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/1>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/1>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(0.001+3.993*s+8.85*s^2-76.644*s^3+165.715*s^4-152.872*s^5+50.957*s^6))/1>,0.3*t,H,)]_{C6}
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

#module BRACT
#define K=5
#define len=4.5
#define half=1.8/2
#define t=0.3
#define cup=6
#define finalStep=6
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,2)
#define RU1(4,0,0,0,1,t,1,2)
#define RM1(4,0,0,0,1,t,1,2)
#define RL1(4,0,0,0,1,t,1,2)
#define LU1(4,0,0,0,1,t,1,2)
#define LM1(4,0,0,0,1,t,1,2)
#define LL1(4,0,0,0,1,t,1,2)
#axiom: VEIN(, -40, , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<-6>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/1>,0.3*t,H,)]_{C6}
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

#module FLORET
#define TUBE(4,0,0,0,0.5,0.35,0.35,6)
#define finalStep=3
#axiom: TUBE
TUBE{}{step<2}{} -> TUBE[TUBE(,,,,0.45,<0.55-0.1*step>,<0.55-0.1*step>,)]_{E}
`,
	"designed-buttercup": `/* Buttercup by choices
   about: Five sepals, five obovate petals, many stamens, and carpels each for itself.
   source: own text, assembled; the method is Petrenko 2014, section 3.3
*/
@organ stem section=round growth=arching length=160 thickness=2.2 base=6f9150 tip=86a862@
#define sides=12
#define thick=2.2
#define length=160 /* 10 … 900 mm, of the stem */
#define bend=3 /* -5 … 5 degrees, of the stem from piece to piece */
#define piece=length/17*math.random(0.92,1.08)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)
#define STEM(sides,0,0,0,piece,thick,thick*1,1)
#define COLLAR(sides,0,0,0,1,thick,thick*1,1)
#define finalStep=18
#material 1 stem "6f9150" "86a862"
#axiom: STEM
STEM{}{step<16}{} -> STEM[STEM(,<bend*step/8+math.random(-0.8,0.8)+1.5*wilt>,<math.random(-0.8,0.8)>,,,,,)]_{E}
STEM{}{step==16}{} -> STEM[COLLAR]_{E}
COLLAR -> COLLAR[&CALYX]_{E}

@organ leaf count=4 arrangement=alternate outline=oblanceolate section=wavy length=62 width=16 thickness=0.7 angle=34 bend=30 curl=20 base=47793a tip=5f9449@
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
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,2)
#define RU1(4,0,0,0,1,0.3*thick,1,2)
#define RU2(4,0,0,0,1,0.3*thick,1,2)
#define RM1(4,0,0,0,1,0.3*thick,1,2)
#define RM2(4,0,0,0,1,0.3*thick,1,2)
#define RL1(4,0,0,0,1,0.3*thick,1,2)
#define RL2(4,0,0,0,1,0.3*thick,1,2)
#define LU1(4,0,0,0,1,0.3*thick,1,2)
#define LU2(4,0,0,0,1,0.3*thick,1,2)
#define LM1(4,0,0,0,1,0.3*thick,1,2)
#define LM2(4,0,0,0,1,0.3*thick,1,2)
#define LL1(4,0,0,0,1,0.3*thick,1,2)
#define LL2(4,0,0,0,1,0.3*thick,1,2)
#material 2 leaf "47793a" "5f9449"
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
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,3)
#define RU1(4,0,0,0,1,0.3*thick,1,3)
#define RU2(4,0,0,0,1,0.3*thick,1,3)
#define RU3(4,0,0,0,1,0.3*thick,1,3)
#define RM1(4,0,0,0,1,0.3*thick,1,3)
#define RM2(4,0,0,0,1,0.3*thick,1,3)
#define RM3(4,0,0,0,1,0.3*thick,1,3)
#define RL1(4,0,0,0,1,0.3*thick,1,3)
#define RL2(4,0,0,0,1,0.3*thick,1,3)
#define RL3(4,0,0,0,1,0.3*thick,1,3)
#define LU1(4,0,0,0,1,0.3*thick,1,3)
#define LU2(4,0,0,0,1,0.3*thick,1,3)
#define LU3(4,0,0,0,1,0.3*thick,1,3)
#define LM1(4,0,0,0,1,0.3*thick,1,3)
#define LM2(4,0,0,0,1,0.3*thick,1,3)
#define LM3(4,0,0,0,1,0.3*thick,1,3)
#define LL1(4,0,0,0,1,0.3*thick,1,3)
#define LL2(4,0,0,0,1,0.3*thick,1,3)
#define LL3(4,0,0,0,1,0.3*thick,1,3)
#material 3 sepal "b7bd55" "c9c95e"
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

@organ petal count=5 whorls=1 symmetry=radial lip=35 outline=obovate section=cupped length=15 width=14 thickness=0.5 angle=22 bend=-38 curl=6 radius=2 base=e6b70c tip=f8d414@
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
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,4)
#define RU1(4,0,0,0,1,0.3*thick,1,4)
#define RU2(4,0,0,0,1,0.3*thick,1,4)
#define RU3(4,0,0,0,1,0.3*thick,1,4)
#define RM1(4,0,0,0,1,0.3*thick,1,4)
#define RM2(4,0,0,0,1,0.3*thick,1,4)
#define RM3(4,0,0,0,1,0.3*thick,1,4)
#define RL1(4,0,0,0,1,0.3*thick,1,4)
#define RL2(4,0,0,0,1,0.3*thick,1,4)
#define RL3(4,0,0,0,1,0.3*thick,1,4)
#define LU1(4,0,0,0,1,0.3*thick,1,4)
#define LU2(4,0,0,0,1,0.3*thick,1,4)
#define LU3(4,0,0,0,1,0.3*thick,1,4)
#define LM1(4,0,0,0,1,0.3*thick,1,4)
#define LM2(4,0,0,0,1,0.3*thick,1,4)
#define LM3(4,0,0,0,1,0.3*thick,1,4)
#define LL1(4,0,0,0,1,0.3*thick,1,4)
#define LL2(4,0,0,0,1,0.3*thick,1,4)
#define LL3(4,0,0,0,1,0.3*thick,1,4)
#material 4 petal "e6b70c" "f8d414"
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
#define sides=12
#define thick=6
#define length=420 /* 10 … 900 mm, of the stem */
#define bend=3 /* -5 … 5 degrees, of the stem from piece to piece */
#define piece=length/17*math.random(0.92,1.08)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)
#define STEM(sides,0,0,0,piece,thick,thick*1,1)
#define COLLAR(sides,0,0,0,1,thick,thick*1,1)
#define finalStep=18
#material 1 stem "6d8f4e" "8aa862"
#axiom: STEM
STEM{}{step<16}{} -> STEM[STEM(,<bend*step/8+math.random(-0.8,0.8)+1.5*wilt>,<math.random(-0.8,0.8)>,,,,,)]_{E}
STEM{}{step==16}{} -> STEM[COLLAR]_{E}
COLLAR -> COLLAR[&CALYX]_{E}

@organ leaf count=8 arrangement=alternate outline=lanceolate section=channelled length=110 width=17 thickness=1 angle=24 bend=22 curl=20 base=3f6f3a tip=4f8446@
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
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,2)
#define RU1(4,0,0,0,1,0.3*thick,1,2)
#define RU2(4,0,0,0,1,0.3*thick,1,2)
#define RM1(4,0,0,0,1,0.3*thick,1,2)
#define RM2(4,0,0,0,1,0.3*thick,1,2)
#define RL1(4,0,0,0,1,0.3*thick,1,2)
#define RL2(4,0,0,0,1,0.3*thick,1,2)
#define LU1(4,0,0,0,1,0.3*thick,1,2)
#define LU2(4,0,0,0,1,0.3*thick,1,2)
#define LM1(4,0,0,0,1,0.3*thick,1,2)
#define LM2(4,0,0,0,1,0.3*thick,1,2)
#define LL1(4,0,0,0,1,0.3*thick,1,2)
#define LL2(4,0,0,0,1,0.3*thick,1,2)
#material 2 leaf "3f6f3a" "4f8446"
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

@organ petal count=3 whorls=2 symmetry=radial lip=35 outline=lanceolate section=channelled length=105 width=34 thickness=1.2 angle=62 bend=40 curl=85 radius=3.8 base=f6e9c4 tip=f4f1ee@
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
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,4)
#define RU1(4,0,0,0,1,0.3*thick,1,4)
#define RU2(4,0,0,0,1,0.3*thick,1,4)
#define RU3(4,0,0,0,1,0.3*thick,1,4)
#define RM1(4,0,0,0,1,0.3*thick,1,4)
#define RM2(4,0,0,0,1,0.3*thick,1,4)
#define RM3(4,0,0,0,1,0.3*thick,1,4)
#define RL1(4,0,0,0,1,0.3*thick,1,4)
#define RL2(4,0,0,0,1,0.3*thick,1,4)
#define RL3(4,0,0,0,1,0.3*thick,1,4)
#define LU1(4,0,0,0,1,0.3*thick,1,4)
#define LU2(4,0,0,0,1,0.3*thick,1,4)
#define LU3(4,0,0,0,1,0.3*thick,1,4)
#define LM1(4,0,0,0,1,0.3*thick,1,4)
#define LM2(4,0,0,0,1,0.3*thick,1,4)
#define LM3(4,0,0,0,1,0.3*thick,1,4)
#define LL1(4,0,0,0,1,0.3*thick,1,4)
#define LL2(4,0,0,0,1,0.3*thick,1,4)
#define LL3(4,0,0,0,1,0.3*thick,1,4)
#material 4 petal "f6e9c4" "f4f1ee"
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
#define sides=12
#define thick=6.4
#define length=300 /* 10 … 900 mm, of the stem */
#define bend=0 /* -5 … 5 degrees, of the stem from piece to piece */
#define piece=length/17*math.random(0.92,1.08)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)
#define STEM(sides,0,0,0,piece,thick,thick*1,1)
#define COLLAR(sides,0,0,0,1,thick,thick*1,1)
#define finalStep=18
#material 1 stem "7f9a55" "9ab36c"
#axiom: STEM
STEM{}{step<16}{} -> STEM[STEM(,<bend*step/8+math.random(-0.8,0.8)+1.5*wilt>,<math.random(-0.8,0.8)>,,,,,)]_{E}
STEM{}{step==16}{} -> STEM[COLLAR]_{E}
COLLAR -> COLLAR[&CALYX]_{E}

@organ leaf count=2 arrangement=alternate outline=apical section=channelled length=210 width=48 thickness=1.6 angle=72 bend=18 curl=22 base=587f58 tip=6c9a64@
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
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,2)
#define RU1(4,0,0,0,1,0.3*thick,1,2)
#define RU2(4,0,0,0,1,0.3*thick,1,2)
#define RM1(4,0,0,0,1,0.3*thick,1,2)
#define RM2(4,0,0,0,1,0.3*thick,1,2)
#define RL1(4,0,0,0,1,0.3*thick,1,2)
#define RL2(4,0,0,0,1,0.3*thick,1,2)
#define LU1(4,0,0,0,1,0.3*thick,1,2)
#define LU2(4,0,0,0,1,0.3*thick,1,2)
#define LM1(4,0,0,0,1,0.3*thick,1,2)
#define LM2(4,0,0,0,1,0.3*thick,1,2)
#define LL1(4,0,0,0,1,0.3*thick,1,2)
#define LL2(4,0,0,0,1,0.3*thick,1,2)
#material 2 leaf "587f58" "6c9a64"
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

@organ petal count=3 whorls=2 symmetry=radial lip=35 outline=tulip section=cupped length=60 width=40 thickness=1.1 angle=12 bend=-84 curl=4 radius=5.5 base=d8a23a tip=c21d2c@
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
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,4)
#define RU1(4,0,0,0,1,0.3*thick,1,4)
#define RU2(4,0,0,0,1,0.3*thick,1,4)
#define RU3(4,0,0,0,1,0.3*thick,1,4)
#define RM1(4,0,0,0,1,0.3*thick,1,4)
#define RM2(4,0,0,0,1,0.3*thick,1,4)
#define RM3(4,0,0,0,1,0.3*thick,1,4)
#define RL1(4,0,0,0,1,0.3*thick,1,4)
#define RL2(4,0,0,0,1,0.3*thick,1,4)
#define RL3(4,0,0,0,1,0.3*thick,1,4)
#define LU1(4,0,0,0,1,0.3*thick,1,4)
#define LU2(4,0,0,0,1,0.3*thick,1,4)
#define LU3(4,0,0,0,1,0.3*thick,1,4)
#define LM1(4,0,0,0,1,0.3*thick,1,4)
#define LM2(4,0,0,0,1,0.3*thick,1,4)
#define LM3(4,0,0,0,1,0.3*thick,1,4)
#define LL1(4,0,0,0,1,0.3*thick,1,4)
#define LL2(4,0,0,0,1,0.3*thick,1,4)
#define LL3(4,0,0,0,1,0.3*thick,1,4)
#material 4 petal "d8a23a" "c21d2c"
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
#define sides=4
#define thick=1.8
#define length=90 /* 10 … 900 mm, of the stem */
#define bend=7 /* -5 … 5 degrees, of the stem from piece to piece */
#define piece=length/17*math.random(0.92,1.08)
#define open=sin(90*min(age,1))
#define wilt=max(0,age-1)
#define STEM(sides,0,0,0,piece,thick,thick*1,1)
#define COLLAR(sides,0,0,0,1,thick,thick*1,1)
#define finalStep=18
#material 1 stem "6f8d4c" "8c8f58"
#axiom: STEM
STEM{}{step<16}{} -> STEM[STEM(,<bend*step/8+math.random(-0.8,0.8)+1.5*wilt>,<math.random(-0.8,0.8)>,,,,,)]_{E}
STEM{}{step==16}{} -> STEM[COLLAR]_{E}
COLLAR -> COLLAR[&CALYX]_{E}

@organ leaf count=5 arrangement=basal outline=cordate section=cupped length=42 width=34 thickness=0.7 angle=30 bend=10 curl=25 base=3c6a33 tip=558a45@
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
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,2)
#define RU1(4,0,0,0,1,0.3*thick,1,2)
#define RU2(4,0,0,0,1,0.3*thick,1,2)
#define RU3(4,0,0,0,1,0.3*thick,1,2)
#define RM1(4,0,0,0,1,0.3*thick,1,2)
#define RM2(4,0,0,0,1,0.3*thick,1,2)
#define RM3(4,0,0,0,1,0.3*thick,1,2)
#define RL1(4,0,0,0,1,0.3*thick,1,2)
#define RL2(4,0,0,0,1,0.3*thick,1,2)
#define RL3(4,0,0,0,1,0.3*thick,1,2)
#define LU1(4,0,0,0,1,0.3*thick,1,2)
#define LU2(4,0,0,0,1,0.3*thick,1,2)
#define LU3(4,0,0,0,1,0.3*thick,1,2)
#define LM1(4,0,0,0,1,0.3*thick,1,2)
#define LM2(4,0,0,0,1,0.3*thick,1,2)
#define LM3(4,0,0,0,1,0.3*thick,1,2)
#define LL1(4,0,0,0,1,0.3*thick,1,2)
#define LL2(4,0,0,0,1,0.3*thick,1,2)
#define LL3(4,0,0,0,1,0.3*thick,1,2)
#material 2 leaf "3c6a33" "558a45"
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
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,3)
#define RU1(4,0,0,0,1,0.3*thick,1,3)
#define RU2(4,0,0,0,1,0.3*thick,1,3)
#define RU3(4,0,0,0,1,0.3*thick,1,3)
#define RM1(4,0,0,0,1,0.3*thick,1,3)
#define RM2(4,0,0,0,1,0.3*thick,1,3)
#define RM3(4,0,0,0,1,0.3*thick,1,3)
#define RL1(4,0,0,0,1,0.3*thick,1,3)
#define RL2(4,0,0,0,1,0.3*thick,1,3)
#define RL3(4,0,0,0,1,0.3*thick,1,3)
#define LU1(4,0,0,0,1,0.3*thick,1,3)
#define LU2(4,0,0,0,1,0.3*thick,1,3)
#define LU3(4,0,0,0,1,0.3*thick,1,3)
#define LM1(4,0,0,0,1,0.3*thick,1,3)
#define LM2(4,0,0,0,1,0.3*thick,1,3)
#define LM3(4,0,0,0,1,0.3*thick,1,3)
#define LL1(4,0,0,0,1,0.3*thick,1,3)
#define LL2(4,0,0,0,1,0.3*thick,1,3)
#define LL3(4,0,0,0,1,0.3*thick,1,3)
#material 3 sepal "708a4a" "86a05c"
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

@organ petal count=5 whorls=1 symmetry=irregular lip=32 outline=obovate section=wavy length=15 width=11 thickness=0.5 angle=30 bend=10 curl=25 radius=1.9 base=efe3a0 tip=6a4fb0@
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
#define VEIN(8,0,0,0,len*((1-even)*sin(90/K)^2+even/K),thick,thick,4)
#define RU1(4,0,0,0,1,0.3*thick,1,4)
#define RU2(4,0,0,0,1,0.3*thick,1,4)
#define RU3(4,0,0,0,1,0.3*thick,1,4)
#define RM1(4,0,0,0,1,0.3*thick,1,4)
#define RM2(4,0,0,0,1,0.3*thick,1,4)
#define RM3(4,0,0,0,1,0.3*thick,1,4)
#define RL1(4,0,0,0,1,0.3*thick,1,4)
#define RL2(4,0,0,0,1,0.3*thick,1,4)
#define RL3(4,0,0,0,1,0.3*thick,1,4)
#define LU1(4,0,0,0,1,0.3*thick,1,4)
#define LU2(4,0,0,0,1,0.3*thick,1,4)
#define LU3(4,0,0,0,1,0.3*thick,1,4)
#define LM1(4,0,0,0,1,0.3*thick,1,4)
#define LM2(4,0,0,0,1,0.3*thick,1,4)
#define LM3(4,0,0,0,1,0.3*thick,1,4)
#define LL1(4,0,0,0,1,0.3*thick,1,4)
#define LL2(4,0,0,0,1,0.3*thick,1,4)
#define LL3(4,0,0,0,1,0.3*thick,1,4)
#material 4 petal "efe3a0" "6a4fb0"
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
	petal: `/* Petal
   about: One petal of three layers, whose lobes grow from a vein and are glued.
   source: Petrenko 2014, figure 21 and section 2.2.3; the grammar is ours
*/
#define STEM(8,0,0,0,4,3,3,1)
#axiom: STEM
#define finalStep=1
STEM -> STEM[&PETAL]_{E}
#material 4 petal "f3c14b" "d1253f"
#module PETAL
#define K=12
#define len=60
#define half=38/2
#define t=1.2
#define cup=9
#define finalStep=15
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,4)
#define RU1(4,0,0,0,1,t,1,4)
#define RU2(4,0,0,0,1,t,1,4)
#define RU3(4,0,0,0,1,t,1,4)
#define RM1(4,0,0,0,1,t,1,4)
#define RM2(4,0,0,0,1,t,1,4)
#define RM3(4,0,0,0,1,t,1,4)
#define RL1(4,0,0,0,1,t,1,4)
#define RL2(4,0,0,0,1,t,1,4)
#define RL3(4,0,0,0,1,t,1,4)
#define LU1(4,0,0,0,1,t,1,4)
#define LU2(4,0,0,0,1,t,1,4)
#define LU3(4,0,0,0,1,t,1,4)
#define LM1(4,0,0,0,1,t,1,4)
#define LM2(4,0,0,0,1,t,1,4)
#define LM3(4,0,0,0,1,t,1,4)
#define LL1(4,0,0,0,1,t,1,4)
#define LL2(4,0,0,0,1,t,1,4)
#define LL3(4,0,0,0,1,t,1,4)
#axiom: VEIN(, 0, , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<6-10*u>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
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
   about: Four crumpled petals in two whorls, many dark stamens, and a capsule under its lid of stigmas.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/
#define length=180
#define STEM(12,0,0,0,24,2.4,2.4,1)
#define RECEPTACLE(12,0,0,0,1.2,4.5,4.5,1)
#define BASE(12,0,0,0,1.2,4.5,4.5,1)
#define RING(12,0,0,8,0.7,4.2,4.2,1)
#define finalStep=25

#material 1 stem "7d9a5e" "8ba868"
#material 4 petal "2a1216" "d8281f"
#material 5 petal "2a1216" "e2382a"
#material 6 stamen "3a2f45" "4a3f55"
#material 7 stamen "2f2a33" "5a5560"
#material 8 pistil "9fb083" "aabb8c"
#material 9 pistil "6d5a58" "5c4a4c"

#axiom: STEM
STEM{}{step<16}{} -> STEM[STEM(,<math.random(-2.5,2.5)>,<math.random(-2.5,2.5)>,,<length/16>,,,)]_{E}
STEM{}{step==16}{} -> STEM[RECEPTACLE]_{E}
RECEPTACLE -> RECEPTACLE[BASE]_{E}
RECEPTACLE -> RECEPTACLE[&OUTER]_{C1,C7}
BASE -> BASE[RING]_{E}
BASE -> BASE[&INNER]_{C4,C10}
RING{}{step<23}{} -> RING[RING]_{E}
RING{}{step==23}{} -> RING[&CAPSULE]_{E}
RING -> RING[&STAMEN]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12}

#module OUTER
#define K=12
#define len=40
#define half=58/2
#define t=0.5
#define cup=9+math.random(-2,2)
#define finalStep=17
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,4)
#define RU1(4,0,0,0,1,t,1,5)
#define RU2(4,0,0,0,1,t,1,5)
#define RU3(4,0,0,0,1,t,1,5)
#define RU4(4,0,0,0,1,t,1,5)
#define RU5(4,0,0,0,1,t,1,5)
#define RM1(4,0,0,0,1,t,1,4)
#define RM2(4,0,0,0,1,t,1,4)
#define RM3(4,0,0,0,1,t,1,4)
#define RM4(4,0,0,0,1,t,1,4)
#define RM5(4,0,0,0,1,t,1,4)
#define RL1(4,0,0,0,1,t,1,4)
#define RL2(4,0,0,0,1,t,1,4)
#define RL3(4,0,0,0,1,t,1,4)
#define RL4(4,0,0,0,1,t,1,4)
#define RL5(4,0,0,0,1,t,1,4)
#define LU1(4,0,0,0,1,t,1,5)
#define LU2(4,0,0,0,1,t,1,5)
#define LU3(4,0,0,0,1,t,1,5)
#define LU4(4,0,0,0,1,t,1,5)
#define LU5(4,0,0,0,1,t,1,5)
#define LM1(4,0,0,0,1,t,1,4)
#define LM2(4,0,0,0,1,t,1,4)
#define LM3(4,0,0,0,1,t,1,4)
#define LM4(4,0,0,0,1,t,1,4)
#define LM5(4,0,0,0,1,t,1,4)
#define LL1(4,0,0,0,1,t,1,4)
#define LL2(4,0,0,0,1,t,1,4)
#define LL3(4,0,0,0,1,t,1,4)
#define LL4(4,0,0,0,1,t,1,4)
#define LL5(4,0,0,0,1,t,1,4)
#axiom: VEIN(, -22+math.random(-5,5), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(-35-40*u+60*u^2)*sin(90/K)*sin(180*(step+1)/K)+math.random(-5,5)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C6}
RL1{s=(step-1)/K}{}{} -> RL1[RL2(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM1{s=(step-1)/K}{}{} -> RM1[RM2(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU1{s=(step-1)/K}{}{} -> RU1[RU2(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL1{s=(step-1)/K}{}{} -> LL1[LL2(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM1{s=(step-1)/K}{}{} -> LM1[LM2(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU1{s=(step-1)/K}{}{} -> LU1[LU2(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RL2{s=(step-2)/K}{}{} -> RL2[RL3(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM2{s=(step-2)/K}{}{} -> RM2[RM3(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU2{s=(step-2)/K}{}{} -> RU2[RU3(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL2{s=(step-2)/K}{}{} -> LL2[LL3(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM2{s=(step-2)/K}{}{} -> LM2[LM3(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU2{s=(step-2)/K}{}{} -> LU2[LU3(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RL3{s=(step-3)/K}{}{} -> RL3[RL4(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM3{s=(step-3)/K}{}{} -> RM3[RM4(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU3{s=(step-3)/K}{}{} -> RU3[RU4(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL3{s=(step-3)/K}{}{} -> LL3[LL4(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM3{s=(step-3)/K}{}{} -> LM3[LM4(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU3{s=(step-3)/K}{}{} -> LU3[LU4(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RL4{s=(step-4)/K}{}{} -> RL4[RL5(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM4{s=(step-4)/K}{}{} -> RM4[RM5(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU4{s=(step-4)/K}{}{} -> RU4[RU5(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL4{s=(step-4)/K}{}{} -> LL4[LL5(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM4{s=(step-4)/K}{}{} -> LM4[LM5(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU4{s=(step-4)/K}{}{} -> LU4[LU5(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
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
RL4 : RL4_C1 < RL4_C3 -> RL4_C1 | RL4_C3
RM4 : RM4_C1 < RM4_C3 -> RM4_C1 | RM4_C3
RU4 : RU4_C1 < RU4_C3 -> RU4_C1 | RU4_C3
RL4 : RL4_C2 < RM4_C4 -> RL4_C2 | RM4_C4
RM4 : RM4_C2 < RU4_C4 -> RM4_C2 | RU4_C4
LL4 : LL4_C1 < LL4_C3 -> LL4_C1 | LL4_C3
LM4 : LM4_C1 < LM4_C3 -> LM4_C1 | LM4_C3
LU4 : LU4_C1 < LU4_C3 -> LU4_C1 | LU4_C3
LL4 : LL4_C4 < LM4_C2 -> LL4_C4 | LM4_C2
LM4 : LM4_C4 < LU4_C2 -> LM4_C4 | LU4_C2
RL5 : RL5_C1 < RL5_C3 -> RL5_C1 | RL5_C3
RM5 : RM5_C1 < RM5_C3 -> RM5_C1 | RM5_C3
RU5 : RU5_C1 < RU5_C3 -> RU5_C1 | RU5_C3
RL5 : RL5_C2 < RM5_C4 -> RL5_C2 | RM5_C4
RM5 : RM5_C2 < RU5_C4 -> RM5_C2 | RU5_C4
LL5 : LL5_C1 < LL5_C3 -> LL5_C1 | LL5_C3
LM5 : LM5_C1 < LM5_C3 -> LM5_C1 | LM5_C3
LU5 : LU5_C1 < LU5_C3 -> LU5_C1 | LU5_C3
LL5 : LL5_C4 < LM5_C2 -> LL5_C4 | LM5_C2
LM5 : LM5_C4 < LU5_C2 -> LM5_C4 | LU5_C2

#module INNER
#define K=12
#define len=37
#define half=50/2
#define t=0.5
#define cup=10+math.random(-2,2)
#define finalStep=17
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,4)
#define RU1(4,0,0,0,1,t,1,5)
#define RU2(4,0,0,0,1,t,1,5)
#define RU3(4,0,0,0,1,t,1,5)
#define RU4(4,0,0,0,1,t,1,5)
#define RU5(4,0,0,0,1,t,1,5)
#define RM1(4,0,0,0,1,t,1,4)
#define RM2(4,0,0,0,1,t,1,4)
#define RM3(4,0,0,0,1,t,1,4)
#define RM4(4,0,0,0,1,t,1,4)
#define RM5(4,0,0,0,1,t,1,4)
#define RL1(4,0,0,0,1,t,1,4)
#define RL2(4,0,0,0,1,t,1,4)
#define RL3(4,0,0,0,1,t,1,4)
#define RL4(4,0,0,0,1,t,1,4)
#define RL5(4,0,0,0,1,t,1,4)
#define LU1(4,0,0,0,1,t,1,5)
#define LU2(4,0,0,0,1,t,1,5)
#define LU3(4,0,0,0,1,t,1,5)
#define LU4(4,0,0,0,1,t,1,5)
#define LU5(4,0,0,0,1,t,1,5)
#define LM1(4,0,0,0,1,t,1,4)
#define LM2(4,0,0,0,1,t,1,4)
#define LM3(4,0,0,0,1,t,1,4)
#define LM4(4,0,0,0,1,t,1,4)
#define LM5(4,0,0,0,1,t,1,4)
#define LL1(4,0,0,0,1,t,1,4)
#define LL2(4,0,0,0,1,t,1,4)
#define LL3(4,0,0,0,1,t,1,4)
#define LL4(4,0,0,0,1,t,1,4)
#define LL5(4,0,0,0,1,t,1,4)
#axiom: VEIN(, -32+math.random(-5,5), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(-45-40*u+60*u^2)*sin(90/K)*sin(180*(step+1)/K)+math.random(-5,5)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C6}
RL1{s=(step-1)/K}{}{} -> RL1[RL2(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM1{s=(step-1)/K}{}{} -> RM1[RM2(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU1{s=(step-1)/K}{}{} -> RU1[RU2(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL1{s=(step-1)/K}{}{} -> LL1[LL2(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM1{s=(step-1)/K}{}{} -> LM1[LM2(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU1{s=(step-1)/K}{}{} -> LU1[LU2(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RL2{s=(step-2)/K}{}{} -> RL2[RL3(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM2{s=(step-2)/K}{}{} -> RM2[RM3(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU2{s=(step-2)/K}{}{} -> RU2[RU3(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL2{s=(step-2)/K}{}{} -> LL2[LL3(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM2{s=(step-2)/K}{}{} -> LM2[LM3(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU2{s=(step-2)/K}{}{} -> LU2[LU3(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RL3{s=(step-3)/K}{}{} -> RL3[RL4(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM3{s=(step-3)/K}{}{} -> RM3[RM4(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU3{s=(step-3)/K}{}{} -> RU3[RU4(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL3{s=(step-3)/K}{}{} -> LL3[LL4(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM3{s=(step-3)/K}{}{} -> LM3[LM4(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU3{s=(step-3)/K}{}{} -> LU3[LU4(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RL4{s=(step-4)/K}{}{} -> RL4[RL5(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM4{s=(step-4)/K}{}{} -> RM4[RM5(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU4{s=(step-4)/K}{}{} -> RU4[RU5(,0,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL4{s=(step-4)/K}{}{} -> LL4[LL5(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM4{s=(step-4)/K}{}{} -> LM4[LM5(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU4{s=(step-4)/K}{}{} -> LU4[LU5(,0,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
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
RL4 : RL4_C1 < RL4_C3 -> RL4_C1 | RL4_C3
RM4 : RM4_C1 < RM4_C3 -> RM4_C1 | RM4_C3
RU4 : RU4_C1 < RU4_C3 -> RU4_C1 | RU4_C3
RL4 : RL4_C2 < RM4_C4 -> RL4_C2 | RM4_C4
RM4 : RM4_C2 < RU4_C4 -> RM4_C2 | RU4_C4
LL4 : LL4_C1 < LL4_C3 -> LL4_C1 | LL4_C3
LM4 : LM4_C1 < LM4_C3 -> LM4_C1 | LM4_C3
LU4 : LU4_C1 < LU4_C3 -> LU4_C1 | LU4_C3
LL4 : LL4_C4 < LM4_C2 -> LL4_C4 | LM4_C2
LM4 : LM4_C4 < LU4_C2 -> LM4_C4 | LU4_C2
RL5 : RL5_C1 < RL5_C3 -> RL5_C1 | RL5_C3
RM5 : RM5_C1 < RM5_C3 -> RM5_C1 | RM5_C3
RU5 : RU5_C1 < RU5_C3 -> RU5_C1 | RU5_C3
RL5 : RL5_C2 < RM5_C4 -> RL5_C2 | RM5_C4
RM5 : RM5_C2 < RU5_C4 -> RM5_C2 | RU5_C4
LL5 : LL5_C1 < LL5_C3 -> LL5_C1 | LL5_C3
LM5 : LM5_C1 < LM5_C3 -> LM5_C1 | LM5_C3
LU5 : LU5_C1 < LU5_C3 -> LU5_C1 | LU5_C3
LL5 : LL5_C4 < LM5_C2 -> LL5_C4 | LM5_C2
LM5 : LM5_C4 < LU5_C2 -> LM5_C4 | LU5_C2

#module STAMEN
#define FILAMENT(4,0,0,0,1.6,0.35,0.35,6)
#define ANTHER(4,0,0,0,0.8,1.1,0.8,7)
#define finalStep=7
#define lean=math.random(-70,-25)
#axiom: FILAMENT(,lean,,,,,,)
FILAMENT{}{step<5}{} -> FILAMENT[FILAMENT(,<-lean*0.1-6>,,,1.7,,,)]_{E}
FILAMENT{}{step==5}{} -> FILAMENT[ANTHER]_{E}
ANTHER -> ANTHER[ANTHER(,,,,1,,,)]_{E}

#module CAPSULE
#define WALL(12,0,0,0,1.2,4,4,8)
#define LID(12,0,0,0,0.8,8.6,8.6,9)
#define finalStep=10
#axiom: WALL
WALL{}{step<7}{} -> WALL[WALL(,,,,1.7,<4.5+3.4*sin(18*step)>,<4.5+3.4*sin(18*step)>,)]_{E}
WALL{}{step==7}{} -> WALL[LID]_{E}
LID -> LID[LID(,,,,0.6,3,3,)]_{E}
`,
	sunflower: `/* Sunflower
   about: Florets in spirals by the golden angle, as faces of a prism of 21 sides give it; rays and bracts round them.
   source: Petrenko 2014, figure 39, whose grammar is not printed; the text is ours
*/
#define length=700
#define discs=320
#define radius=52
#define STEM(12,0,0,0,60,17,17,1)
#define NODE(12,0,0,0,16,18,18,1)
#define CUP(21,0,0,0,12,86,86,2)
#define RIM(21,0,0,0,6,104,104,2)
#define SECOND(21,0,0,8.57,3,104,104,6)
#define DISC(21,0,0,0.365,0.06,104,104,6)
#define BARE(21,0,0,0,0,104,104,6)
#define finalStep=340

#material 1 stem "7a944c" "8aa458"
#material 2 sepal "5f8040" "7a984e"
#material 3 leaf "47702f" "5a8440"
#material 4 petal "e89a14" "f7c31e"
#material 6 stamen "5a3a18" "6d4a20"
#material 7 stamen "4a2c14" "b8862c"

#axiom: STEM
STEM{}{step<10&&step!=4}{} -> STEM[STEM(,<0.6*step>,,,60,<17-0.3*step>,<17-0.3*step>,)]_{E}
STEM{}{step==4}{} -> STEM[NODE]_{E}
NODE -> NODE[STEM]_{E}
NODE -> NODE[&LEAF]_{C1,C7}
STEM{}{step==10}{} -> STEM[CUP(,38,,,,,,)]_{E}
CUP -> CUP[RIM]_{E}
CUP -> CUP[&BRACT]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12,C13,C14,C15,C16,C17,C18,C19,C20,C21}
RIM -> RIM[SECOND]_{E}
RIM -> RIM[&RAY]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12,C13,C14,C15,C16,C17,C18,C19,C20,C21}
SECOND -> SECOND[DISC]_{E}
SECOND -> SECOND[&RAY]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12,C13,C14,C15,C16,C17,C18,C19,C20,C21}
DISC{k=step-14;r=sqrt(max(0.002,1-k/discs))}{step<finalStep-1}{} -> BARE[DISC(,,,,<0.02+0.04*k/discs>,<2*radius*r>,<2*radius*r>,)]_{E}[&FLORET(,<-62-26*k/discs>,,,,,,)]_{C(1+8*k%21)}

#module RAY
#define K=9
#define len=78
#define half=22/2
#define t=0.8
#define cup=8
#define finalStep=11
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,4)
#define RU1(4,0,0,0,1,t,1,4)
#define RU2(4,0,0,0,1,t,1,4)
#define RM1(4,0,0,0,1,t,1,4)
#define RM2(4,0,0,0,1,t,1,4)
#define RL1(4,0,0,0,1,t,1,4)
#define RL2(4,0,0,0,1,t,1,4)
#define LU1(4,0,0,0,1,t,1,4)
#define LU2(4,0,0,0,1,t,1,4)
#define LM1(4,0,0,0,1,t,1,4)
#define LM2(4,0,0,0,1,t,1,4)
#define LL1(4,0,0,0,1,t,1,4)
#define LL2(4,0,0,0,1,t,1,4)
#axiom: VEIN(, -14+math.random(-12,12), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(-20+26*u)*sin(90/K)*sin(180*(step+1)/K)+math.random(-3,3)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C6}
RL1{s=(step-1)/K}{}{} -> RL1[RL2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
RM1{s=(step-1)/K}{}{} -> RM1[RM2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
RU1{s=(step-1)/K}{}{} -> RU1[RU2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LL1{s=(step-1)/K}{}{} -> LL1[LL2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LM1{s=(step-1)/K}{}{} -> LM1[LM2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LU1{s=(step-1)/K}{}{} -> LU1[LU2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
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

#module BRACT
#define K=7
#define len=34
#define half=15/2
#define t=1
#define cup=8
#define finalStep=8
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,2)
#define RU1(4,0,0,0,1,t,1,2)
#define RM1(4,0,0,0,1,t,1,2)
#define RL1(4,0,0,0,1,t,1,2)
#define LU1(4,0,0,0,1,t,1,2)
#define LM1(4,0,0,0,1,t,1,2)
#define LL1(4,0,0,0,1,t,1,2)
#axiom: VEIN(, -10+math.random(-8,8), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(-30+30*u)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/1>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/1>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/1>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/1>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/1>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/1>,0.3*t,H,)]_{C6}
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

#module LEAF
#define K=12
#define len=210
#define half=150/2
#define t=1.6
#define cup=6
#define finalStep=16
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,3)
#define RU1(4,0,0,0,1,t,1,3)
#define RU2(4,0,0,0,1,t,1,3)
#define RU3(4,0,0,0,1,t,1,3)
#define RU4(4,0,0,0,1,t,1,3)
#define RM1(4,0,0,0,1,t,1,3)
#define RM2(4,0,0,0,1,t,1,3)
#define RM3(4,0,0,0,1,t,1,3)
#define RM4(4,0,0,0,1,t,1,3)
#define RL1(4,0,0,0,1,t,1,3)
#define RL2(4,0,0,0,1,t,1,3)
#define RL3(4,0,0,0,1,t,1,3)
#define RL4(4,0,0,0,1,t,1,3)
#define LU1(4,0,0,0,1,t,1,3)
#define LU2(4,0,0,0,1,t,1,3)
#define LU3(4,0,0,0,1,t,1,3)
#define LU4(4,0,0,0,1,t,1,3)
#define LM1(4,0,0,0,1,t,1,3)
#define LM2(4,0,0,0,1,t,1,3)
#define LM3(4,0,0,0,1,t,1,3)
#define LM4(4,0,0,0,1,t,1,3)
#define LL1(4,0,0,0,1,t,1,3)
#define LL2(4,0,0,0,1,t,1,3)
#define LL3(4,0,0,0,1,t,1,3)
#define LL4(4,0,0,0,1,t,1,3)
#axiom: VEIN(, -35+math.random(-8,8), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(20+90*u)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,<18*max(0,1-4*s)>,<45+cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,<18*max(0,1-4*s)>,<cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,<18*max(0,1-4*s)>,<-45+cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,<18*max(0,1-4*s)>,<-45-cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,<18*max(0,1-4*s)>,<-cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,<18*max(0,1-4*s)>,<45-cup/2>,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,H,)]_{C6}
RL1{s=(step-1)/K}{}{} -> RL1[RL2(,<18*max(0,1-4*s)>,cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
RM1{s=(step-1)/K}{}{} -> RM1[RM2(,<18*max(0,1-4*s)>,cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
RU1{s=(step-1)/K}{}{} -> RU1[RU2(,<18*max(0,1-4*s)>,cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
LL1{s=(step-1)/K}{}{} -> LL1[LL2(,<18*max(0,1-4*s)>,-cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
LM1{s=(step-1)/K}{}{} -> LM1[LM2(,<18*max(0,1-4*s)>,-cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
LU1{s=(step-1)/K}{}{} -> LU1[LU2(,<18*max(0,1-4*s)>,-cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
RL2{s=(step-2)/K}{}{} -> RL2[RL3(,<18*max(0,1-4*s)>,cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
RM2{s=(step-2)/K}{}{} -> RM2[RM3(,<18*max(0,1-4*s)>,cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
RU2{s=(step-2)/K}{}{} -> RU2[RU3(,<18*max(0,1-4*s)>,cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
LL2{s=(step-2)/K}{}{} -> LL2[LL3(,<18*max(0,1-4*s)>,-cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
LM2{s=(step-2)/K}{}{} -> LM2[LM3(,<18*max(0,1-4*s)>,-cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
LU2{s=(step-2)/K}{}{} -> LU2[LU3(,<18*max(0,1-4*s)>,-cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
RL3{s=(step-3)/K}{}{} -> RL3[RL4(,<18*max(0,1-4*s)>,cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
RM3{s=(step-3)/K}{}{} -> RM3[RM4(,<18*max(0,1-4*s)>,cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
RU3{s=(step-3)/K}{}{} -> RU3[RU4(,<18*max(0,1-4*s)>,cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
LL3{s=(step-3)/K}{}{} -> LL3[LL4(,<18*max(0,1-4*s)>,-cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
LM3{s=(step-3)/K}{}{} -> LM3[LM4(,<18*max(0,1-4*s)>,-cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
LU3{s=(step-3)/K}{}{} -> LU3[LU4(,<18*max(0,1-4*s)>,-cup,0,<max(0.02, half*(0.001+4.952*s-6.276*s^2+3.891*s^3-16.233*s^4+21.362*s^5-7.697*s^6))/4>,0.3*t,,)]_{E}
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
RL4 : RL4_C1 < RL4_C3 -> RL4_C1 | RL4_C3
RM4 : RM4_C1 < RM4_C3 -> RM4_C1 | RM4_C3
RU4 : RU4_C1 < RU4_C3 -> RU4_C1 | RU4_C3
RL4 : RL4_C2 < RM4_C4 -> RL4_C2 | RM4_C4
RM4 : RM4_C2 < RU4_C4 -> RM4_C2 | RU4_C4
LL4 : LL4_C1 < LL4_C3 -> LL4_C1 | LL4_C3
LM4 : LM4_C1 < LM4_C3 -> LM4_C1 | LM4_C3
LU4 : LU4_C1 < LU4_C3 -> LU4_C1 | LU4_C3
LL4 : LL4_C4 < LM4_C2 -> LL4_C4 | LM4_C2
LM4 : LM4_C4 < LU4_C2 -> LM4_C4 | LU4_C2

#module FLORET
#define TUBE(4,0,0,0,2.4,2.6,2.6,6)
#define finalStep=4
#axiom: TUBE
TUBE{}{step<3}{} -> TUBE[TUBE(,,,,2.6,<3-0.8*step>,<3-0.8*step>,7)]_{E}
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
#define length=320
#define STEM(12,0,0,0,20,7,7,1)
#define LOWER(12,0,0,0,4,7.4,7.4,1)
#define UPPER(12,0,0,0,4,7.4,7.4,1)
#define RECEPTACLE(12,0,0,0,3,8,8,1)
#define BASE(12,0,0,0,3,8,8,1)
#define TOP(12,0,0,0,1,6,6,1)
#define finalStep=22

#material 1 stem "7f9a55" "8fae62"
#material 2 leaf "5d8250" "6f965c"
#material 4 petal "f0c348" "c8203a"
#material 5 petal "f0c348" "d93a48"
#material 6 stamen "e8dfa5" "d8c987"
#material 7 stamen "3a2f3a" "4a3c3f"
#material 8 pistil "a8bd78" "c4cf8e"
#material 9 pistil "e3dfa0" "efe9b5"

#axiom: STEM
STEM{}{step<16}{} -> STEM[STEM(,<math.random(-0.8,0.8)>,<math.random(-0.8,0.8)>,,<length/16>,7,7,)]_{E}
STEM{}{step==1}{} -> STEM[LOWER]_{E}
STEM{}{step==3}{} -> STEM[UPPER]_{E}
LOWER -> LOWER[STEM]_{E}
LOWER -> LOWER[&LEAF]_{C1}
UPPER -> UPPER[STEM]_{E}
UPPER -> UPPER[&LEAF]_{C7}
STEM{}{step==16}{} -> STEM[RECEPTACLE]_{E}
RECEPTACLE -> RECEPTACLE[BASE]_{E}
RECEPTACLE -> RECEPTACLE[&OUTER]_{C1,C5,C9}
BASE -> BASE[TOP]_{E}
BASE -> BASE[&INNER]_{C3,C7,C11}
TOP -> TOP[&STAMEN]_{C1,C3,C5,C7,C9,C11}
TOP -> TOP[&PISTIL]_{E}

#module OUTER
#define K=12
#define len=66
#define half=40/2
#define t=1.1
#define cup=6+math.random(-1,1)
#define finalStep=15
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,4)
#define RU1(4,0,0,0,1,t,1,5)
#define RU2(4,0,0,0,1,t,1,5)
#define RU3(4,0,0,0,1,t,1,5)
#define RM1(4,0,0,0,1,t,1,4)
#define RM2(4,0,0,0,1,t,1,4)
#define RM3(4,0,0,0,1,t,1,4)
#define RL1(4,0,0,0,1,t,1,4)
#define RL2(4,0,0,0,1,t,1,4)
#define RL3(4,0,0,0,1,t,1,4)
#define LU1(4,0,0,0,1,t,1,5)
#define LU2(4,0,0,0,1,t,1,5)
#define LU3(4,0,0,0,1,t,1,5)
#define LM1(4,0,0,0,1,t,1,4)
#define LM2(4,0,0,0,1,t,1,4)
#define LM3(4,0,0,0,1,t,1,4)
#define LL1(4,0,0,0,1,t,1,4)
#define LL2(4,0,0,0,1,t,1,4)
#define LL3(4,0,0,0,1,t,1,4)
#axiom: VEIN(, -6+math.random(-3,3), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(-230-180.6*u+3966.8*u^2-7107.8*u^3+3611.6*u^4)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
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

#module INNER
#define K=12
#define len=60
#define half=36/2
#define t=1.0
#define cup=8+math.random(-1,1)
#define finalStep=15
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,4)
#define RU1(4,0,0,0,1,t,1,5)
#define RU2(4,0,0,0,1,t,1,5)
#define RU3(4,0,0,0,1,t,1,5)
#define RM1(4,0,0,0,1,t,1,4)
#define RM2(4,0,0,0,1,t,1,4)
#define RM3(4,0,0,0,1,t,1,4)
#define RL1(4,0,0,0,1,t,1,4)
#define RL2(4,0,0,0,1,t,1,4)
#define RL3(4,0,0,0,1,t,1,4)
#define LU1(4,0,0,0,1,t,1,5)
#define LU2(4,0,0,0,1,t,1,5)
#define LU3(4,0,0,0,1,t,1,5)
#define LM1(4,0,0,0,1,t,1,4)
#define LM2(4,0,0,0,1,t,1,4)
#define LM3(4,0,0,0,1,t,1,4)
#define LL1(4,0,0,0,1,t,1,4)
#define LL2(4,0,0,0,1,t,1,4)
#define LL3(4,0,0,0,1,t,1,4)
#axiom: VEIN(, -24+math.random(-3,3), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(-230-180.6*u+3966.8*u^2-7107.8*u^3+3611.6*u^4)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
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

#module LEAF
#define K=14
#define len=230
#define half=55/2
#define t=1.5
#define cup=9
#define finalStep=16
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,2)
#define RU1(4,0,0,0,1,t,1,2)
#define RU2(4,0,0,0,1,t,1,2)
#define RM1(4,0,0,0,1,t,1,2)
#define RM2(4,0,0,0,1,t,1,2)
#define RL1(4,0,0,0,1,t,1,2)
#define RL2(4,0,0,0,1,t,1,2)
#define LU1(4,0,0,0,1,t,1,2)
#define LU2(4,0,0,0,1,t,1,2)
#define LM1(4,0,0,0,1,t,1,2)
#define LM2(4,0,0,0,1,t,1,2)
#define LL1(4,0,0,0,1,t,1,2)
#define LL2(4,0,0,0,1,t,1,2)
#axiom: VEIN(, -62+math.random(-6,6), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<0+(8-60*u+70*u^2)*0.5>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,H,)]_{C6}
RL1{s=(step-1)/K}{}{} -> RL1[RL2(,0,cup,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,,)]_{E}
RM1{s=(step-1)/K}{}{} -> RM1[RM2(,0,cup,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,,)]_{E}
RU1{s=(step-1)/K}{}{} -> RU1[RU2(,0,cup,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,,)]_{E}
LL1{s=(step-1)/K}{}{} -> LL1[LL2(,0,-cup,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,,)]_{E}
LM1{s=(step-1)/K}{}{} -> LM1[LM2(,0,-cup,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,,)]_{E}
LU1{s=(step-1)/K}{}{} -> LU1[LU2(,0,-cup,0,<max(0.02, half*(3.246*s+6.326*s^2-29.191*s^3+21.064*s^4+3.897*s^5-5.342*s^6))/2>,0.3*t,,)]_{E}
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

#module STAMEN
#define FILAMENT(6,0,0,0,2,1.6,1.6,6)
#define ANTHER(6,0,0,0,2.2,2.6,1.8,7)
#define finalStep=14
#axiom: FILAMENT(,<-58+math.random(-5,5)>,,,,,,)
FILAMENT{}{step<7}{} -> FILAMENT[FILAMENT(,<-4>,,,2.4,1.4,1.4,)]_{E}
FILAMENT{}{step==7}{} -> FILAMENT[ANTHER(,0,,,1,2.2,1.6,)]_{E}
ANTHER{}{step<13}{} -> ANTHER[ANTHER(,0,,,2.6,<3.2-0.12*(step-9)^2>,<2.2-0.08*(step-9)^2>,)]_{E}

#module PISTIL
#define OVARY(6,0,0,0,2,5,5,8)
#define STIGMA(6,0,0,0,1.5,6,6,9)
#define LOBE(4,0,0,0,2.5,1.5,1.5,9)
#define finalStep=14
#axiom: OVARY
OVARY{}{step<10}{} -> OVARY[OVARY(,,,,2.6,<5.6-0.05*(step-4)^2>,<5.6-0.05*(step-4)^2>,)]_{E}
OVARY{}{step==10}{} -> OVARY[STIGMA]_{E}
STIGMA -> STIGMA[LOBE]_{C1,C3,C5}
LOBE{}{step<13}{} -> LOBE[LOBE(,25,,,1.6,1.4,1.2,)]_{E}
`,
	"water-lily": `/* Water lily
   about: Petals in spirals that pass into stamens, over a leaf that floats.
   source: own text; the method is Petrenko 2014, section 2.2.3
*/
#define PAD(12,0,0,0,3,12,12,1)
#define CUP(12,0,0,0,2,16,16,2)
#define RING(12,0,0,15,1.5,15,15,4)
#define HEART(12,0,0,15,0.9,9,9,6)
#define TOP(12,0,0,0,1.4,8,8,8)
#define finalStep=14

#material 1 stem "6d7a45" "7d8a55"
#material 2 sepal "6f8a4c" "8fa468"
#material 4 petal "fdfcf6" "fff4f6"
#material 5 petal "fbf6ec" "f6d6e0"
#material 6 stamen "e6b52a" "f2cf4a"
#material 8 pistil "e0c552" "ecd87a"
#material 9 leaf "3f6b3a" "4f7f46"

#axiom: PAD
PAD -> PAD[CUP]_{E}
PAD -> PAD[&LEAF]_{C10}
CUP -> CUP[RING]_{E}
CUP -> CUP[&SEPAL]_{C1,C4,C7,C10}
RING{}{step<5}{} -> RING[RING(,,,,,<15-step>,<15-step>,)]_{E}
RING{}{step==5}{} -> RING[HEART]_{E}
RING{}{step==2}{} -> RING[&PETAL]_{C1,C3,C5,C7,C9,C11}
RING{}{step==3}{} -> RING[&PETAL]_{C2,C4,C6,C8,C10,C12}
RING{}{step==4}{} -> RING[&INNER]_{C1,C3,C5,C7,C9,C11}
RING{}{step==5}{} -> RING[&INNER]_{C2,C4,C6,C8,C10,C12}
HEART{}{step<10}{} -> HEART[HEART]_{E}
HEART{}{step==10}{} -> HEART[TOP]_{E}
HEART -> HEART[&STAMEN]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12}

#module SEPAL
#define K=10
#define len=62
#define half=24/2
#define t=1.4
#define cup=12
#define finalStep=12
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,2)
#define RU1(4,0,0,0,1,t,1,4)
#define RU2(4,0,0,0,1,t,1,4)
#define RM1(4,0,0,0,1,t,1,2)
#define RM2(4,0,0,0,1,t,1,2)
#define RL1(4,0,0,0,1,t,1,2)
#define RL2(4,0,0,0,1,t,1,2)
#define LU1(4,0,0,0,1,t,1,4)
#define LU2(4,0,0,0,1,t,1,4)
#define LM1(4,0,0,0,1,t,1,2)
#define LM2(4,0,0,0,1,t,1,2)
#define LL1(4,0,0,0,1,t,1,2)
#define LL2(4,0,0,0,1,t,1,2)
#axiom: VEIN(, -8, , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(-60+50*u)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C6}
RL1{s=(step-1)/K}{}{} -> RL1[RL2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
RM1{s=(step-1)/K}{}{} -> RM1[RM2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
RU1{s=(step-1)/K}{}{} -> RU1[RU2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LL1{s=(step-1)/K}{}{} -> LL1[LL2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LM1{s=(step-1)/K}{}{} -> LM1[LM2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LU1{s=(step-1)/K}{}{} -> LU1[LU2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
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

#module PETAL
#define K=10
#define len=64
#define half=22/2
#define t=1.2
#define cup=13
#define finalStep=12
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,4)
#define RU1(4,0,0,0,1,t,1,4)
#define RU2(4,0,0,0,1,t,1,4)
#define RM1(4,0,0,0,1,t,1,4)
#define RM2(4,0,0,0,1,t,1,4)
#define RL1(4,0,0,0,1,t,1,5)
#define RL2(4,0,0,0,1,t,1,5)
#define LU1(4,0,0,0,1,t,1,4)
#define LU2(4,0,0,0,1,t,1,4)
#define LM1(4,0,0,0,1,t,1,4)
#define LM2(4,0,0,0,1,t,1,4)
#define LL1(4,0,0,0,1,t,1,5)
#define LL2(4,0,0,0,1,t,1,5)
#axiom: VEIN(, -22+math.random(-6,6), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(-70+40*u)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C6}
RL1{s=(step-1)/K}{}{} -> RL1[RL2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
RM1{s=(step-1)/K}{}{} -> RM1[RM2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
RU1{s=(step-1)/K}{}{} -> RU1[RU2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LL1{s=(step-1)/K}{}{} -> LL1[LL2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LM1{s=(step-1)/K}{}{} -> LM1[LM2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LU1{s=(step-1)/K}{}{} -> LU1[LU2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
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

#module INNER
#define K=10
#define len=54
#define half=17/2
#define t=1.1
#define cup=14
#define finalStep=12
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,4)
#define RU1(4,0,0,0,1,t,1,4)
#define RU2(4,0,0,0,1,t,1,4)
#define RM1(4,0,0,0,1,t,1,4)
#define RM2(4,0,0,0,1,t,1,4)
#define RL1(4,0,0,0,1,t,1,5)
#define RL2(4,0,0,0,1,t,1,5)
#define LU1(4,0,0,0,1,t,1,4)
#define LU2(4,0,0,0,1,t,1,4)
#define LM1(4,0,0,0,1,t,1,4)
#define LM2(4,0,0,0,1,t,1,4)
#define LL1(4,0,0,0,1,t,1,5)
#define LL2(4,0,0,0,1,t,1,5)
#axiom: VEIN(, -42+math.random(-6,6), , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<(-80+40*u)*sin(90/K)*sin(180*(step+1)/K)>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,0,<45+cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,0,<cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,0,<-45+cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,0,<-45-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,0,<-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,0,<45-cup/2>,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,H,)]_{C6}
RL1{s=(step-1)/K}{}{} -> RL1[RL2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
RM1{s=(step-1)/K}{}{} -> RM1[RM2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
RU1{s=(step-1)/K}{}{} -> RU1[RU2(,0,cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LL1{s=(step-1)/K}{}{} -> LL1[LL2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LM1{s=(step-1)/K}{}{} -> LM1[LM2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
LU1{s=(step-1)/K}{}{} -> LU1[LU2(,0,-cup,0,<max(0.02, half*(1.865*s+7.944*s^2-24.725*s^3+25.132*s^4-15.324*s^5+5.108*s^6))/2>,0.3*t,,)]_{E}
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

#module STAMEN
#define FILAMENT(4,0,0,0,3,1.8,0.7,6)
#define finalStep=6
#define lean=math.random(-72,-38)
#axiom: FILAMENT(,lean,,,,,,)
FILAMENT -> FILAMENT[FILAMENT(,<-9>,,,3.4,<1.9-0.2*step>,0.6,)]_{E}

#module LEAF
#define K=14
#define len=190
#define half=170/2
#define t=1.6
#define cup=0
#define finalStep=19
#define VEIN(8,0,0,0,len*sin(90/K)*sin(90/K),t,t,9)
#define RU1(4,0,0,0,1,t,1,9)
#define RU2(4,0,0,0,1,t,1,9)
#define RU3(4,0,0,0,1,t,1,9)
#define RU4(4,0,0,0,1,t,1,9)
#define RU5(4,0,0,0,1,t,1,9)
#define RM1(4,0,0,0,1,t,1,9)
#define RM2(4,0,0,0,1,t,1,9)
#define RM3(4,0,0,0,1,t,1,9)
#define RM4(4,0,0,0,1,t,1,9)
#define RM5(4,0,0,0,1,t,1,9)
#define RL1(4,0,0,0,1,t,1,9)
#define RL2(4,0,0,0,1,t,1,9)
#define RL3(4,0,0,0,1,t,1,9)
#define RL4(4,0,0,0,1,t,1,9)
#define RL5(4,0,0,0,1,t,1,9)
#define LU1(4,0,0,0,1,t,1,9)
#define LU2(4,0,0,0,1,t,1,9)
#define LU3(4,0,0,0,1,t,1,9)
#define LU4(4,0,0,0,1,t,1,9)
#define LU5(4,0,0,0,1,t,1,9)
#define LM1(4,0,0,0,1,t,1,9)
#define LM2(4,0,0,0,1,t,1,9)
#define LM3(4,0,0,0,1,t,1,9)
#define LM4(4,0,0,0,1,t,1,9)
#define LM5(4,0,0,0,1,t,1,9)
#define LL1(4,0,0,0,1,t,1,9)
#define LL2(4,0,0,0,1,t,1,9)
#define LL3(4,0,0,0,1,t,1,9)
#define LL4(4,0,0,0,1,t,1,9)
#define LL5(4,0,0,0,1,t,1,9)
#axiom: VEIN(, 0, , , , , , )
VEIN{u=step/K}{step<K}{} -> VEIN[VEIN(,<0>,0,0,<len*sin(90/K)*sin(180*(step+1.5)/K)>,,,)]_{E}
VEIN{s=step/K}{}{} -> VEIN[RL1(,<24*max(0,1-4*s)>,<45+cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C2}
VEIN{s=step/K}{}{} -> VEIN[RM1(,<24*max(0,1-4*s)>,<cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C3}
VEIN{s=step/K}{}{} -> VEIN[RU1(,<24*max(0,1-4*s)>,<-45+cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C4}
VEIN{s=step/K}{}{} -> VEIN[LL1(,<24*max(0,1-4*s)>,<-45-cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C8}
VEIN{s=step/K}{}{} -> VEIN[LM1(,<24*max(0,1-4*s)>,<-cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C7}
VEIN{s=step/K}{}{} -> VEIN[LU1(,<24*max(0,1-4*s)>,<45-cup/2>,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,H,)]_{C6}
RL1{s=(step-1)/K}{}{} -> RL1[RL2(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM1{s=(step-1)/K}{}{} -> RM1[RM2(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU1{s=(step-1)/K}{}{} -> RU1[RU2(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL1{s=(step-1)/K}{}{} -> LL1[LL2(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM1{s=(step-1)/K}{}{} -> LM1[LM2(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU1{s=(step-1)/K}{}{} -> LU1[LU2(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RL2{s=(step-2)/K}{}{} -> RL2[RL3(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM2{s=(step-2)/K}{}{} -> RM2[RM3(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU2{s=(step-2)/K}{}{} -> RU2[RU3(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL2{s=(step-2)/K}{}{} -> LL2[LL3(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM2{s=(step-2)/K}{}{} -> LM2[LM3(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU2{s=(step-2)/K}{}{} -> LU2[LU3(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RL3{s=(step-3)/K}{}{} -> RL3[RL4(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM3{s=(step-3)/K}{}{} -> RM3[RM4(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU3{s=(step-3)/K}{}{} -> RU3[RU4(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL3{s=(step-3)/K}{}{} -> LL3[LL4(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM3{s=(step-3)/K}{}{} -> LM3[LM4(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU3{s=(step-3)/K}{}{} -> LU3[LU4(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RL4{s=(step-4)/K}{}{} -> RL4[RL5(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RM4{s=(step-4)/K}{}{} -> RM4[RM5(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
RU4{s=(step-4)/K}{}{} -> RU4[RU5(,<24*max(0,1-4*s)>,cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LL4{s=(step-4)/K}{}{} -> LL4[LL5(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LM4{s=(step-4)/K}{}{} -> LM4[LM5(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
LU4{s=(step-4)/K}{}{} -> LU4[LU5(,<24*max(0,1-4*s)>,-cup,0,<max(0.02, half*(3.142*s-0.018*s^2-5.027*s^3-0.543*s^4+3.667*s^5-1.222*s^6))/5>,0.3*t,,)]_{E}
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
RL4 : RL4_C1 < RL4_C3 -> RL4_C1 | RL4_C3
RM4 : RM4_C1 < RM4_C3 -> RM4_C1 | RM4_C3
RU4 : RU4_C1 < RU4_C3 -> RU4_C1 | RU4_C3
RL4 : RL4_C2 < RM4_C4 -> RL4_C2 | RM4_C4
RM4 : RM4_C2 < RU4_C4 -> RM4_C2 | RU4_C4
LL4 : LL4_C1 < LL4_C3 -> LL4_C1 | LL4_C3
LM4 : LM4_C1 < LM4_C3 -> LM4_C1 | LM4_C3
LU4 : LU4_C1 < LU4_C3 -> LU4_C1 | LU4_C3
LL4 : LL4_C4 < LM4_C2 -> LL4_C4 | LM4_C2
LM4 : LM4_C4 < LU4_C2 -> LM4_C4 | LU4_C2
RL5 : RL5_C1 < RL5_C3 -> RL5_C1 | RL5_C3
RM5 : RM5_C1 < RM5_C3 -> RM5_C1 | RM5_C3
RU5 : RU5_C1 < RU5_C3 -> RU5_C1 | RU5_C3
RL5 : RL5_C2 < RM5_C4 -> RL5_C2 | RM5_C4
RM5 : RM5_C2 < RU5_C4 -> RM5_C2 | RU5_C4
LL5 : LL5_C1 < LL5_C3 -> LL5_C1 | LL5_C3
LM5 : LM5_C1 < LM5_C3 -> LM5_C1 | LM5_C3
LU5 : LU5_C1 < LU5_C3 -> LU5_C1 | LU5_C3
LL5 : LL5_C4 < LM5_C2 -> LL5_C4 | LM5_C2
LM5 : LM5_C4 < LU5_C2 -> LM5_C4 | LU5_C2
`,
};
