/**
 * Generates whorls: rings with organs on their sides and the next whorl on their end. The rings' grammars join the
 * organs of an assembled flower.
 */
import type { Organ } from "./organs";

/** Module names of the whorls, from the outside in. */
export const WHORLS = { sepal: "CALYX", petal: "COROLLA", stamen: "ANDROECIUM", pistil: "GYNOECIUM" } as const;
export type Whorled = keyof typeof WHORLS;
const ORDER: readonly Whorled[] = ["sepal", "petal", "stamen", "pistil"];
/** Offset of each whorl's first organ, in half gaps, so that adjacent whorls alternate. */
const HALF: Readonly<Record<Whorled, number>> = { sepal: 1, petal: 0, stamen: 1, pistil: 0 };

/** Least number of a ring's sides, so that it looks round. */
const FEWEST_SIDES = 10;

/**
 * Sides of a ring whose organs can be spaced evenly on it. Rings with equal numbers of sides are sewn to each other
 * and to a stem with as many sides.
 */
const USUAL_SIDES = 12;

/** A ring: its number of sides and the faces with organs. */
export interface Ring {
	readonly sides: number;
	/** Faces with organs, counted from 1. */
	readonly faces: readonly number[];
}

/**
 * Returns a ring on which `count` organs are spaced evenly: with USUAL_SIDES where that is possible, else with as many
 * sides as give an even number of faces from organ to organ.
 * @param half where odd, the first organ is halfway between the first two positions instead of on face 1
 */
export function ringFor(count: number, half: number): Ring {
	if (count === 0) return { sides: USUAL_SIDES, faces: [] };
	const gap =
		USUAL_SIDES % (2 * count) === 0 ? USUAL_SIDES / count : 2 * Math.max(1, Math.ceil(FEWEST_SIDES / count / 2));
	const first = (half % 2) * (gap / 2);
	return { sides: gap * count, faces: Array.from({ length: count }, (_, i) => 1 + first + i * gap) };
}

/**
 * Returns the settings in the call of an organ's module on one face, as text; empty if the organ keeps its own values.
 */
export type Call = (whorl: number, face: number, sides: number) => string;

export interface WhorlPlan {
	readonly organ: Whorled;
	readonly count: number;
	readonly whorls: number;
	/** Radius, millimetres. */
	readonly radius: number;
	/** Number of the rings' material. */
	readonly material: number;
	readonly call: Call;
}

/**
 * Height of a ring, and depth to which an unsewn ring is sunk into its parent, since rounded ends would leave a gap;
 * millimetres.
 */
const RISE = 1.2;
const SUNK = 1;
/** Factor on the radius from one ring to the next. */
const SHRINK = 0.9;

/**
 * Generates the module of a whorl, or of several whorls with the same count: its volumes, its axiom and its
 * productions. A volume is written `#define NAME(N, atx, aty, atz, H, L, W, m)`: sides, rotations about x, y and z
 * (degrees), height, length, width (millimetres), number of the material.
 */
export function whorlText({ organ, count, whorls, radius, material, call }: WhorlPlan): string {
	const rings = Array.from({ length: count === 0 ? 1 : whorls }, (_, i) => ringFor(count, HALF[organ] + i));
	const next = ORDER[ORDER.indexOf(organ) + 1];
	const sewn = rings.every(({ sides }) => sides === USUAL_SIDES);
	const definitions = rings.map(({ sides }, i) => {
		const diameter = Math.round(20 * radius * SHRINK ** i) / 10; // in tenths
		const height = i === 0 && !sewn ? RISE + SUNK : RISE;
		return `#define ${ringName(i)}(${sides},0,0,0,${height},${diameter},${diameter},${material})`;
	});
	const productions = rings.flatMap((ring, i) => {
		const above = rings[i + 1] ? ringName(i + 1) : next && `&${WHORLS[next]}`;
		return ringProductions(ringName(i), above, organ, ring, (face) => call(i, face, ring.sides));
	});
	const lines = sewn
		? [...definitions, `#define finalStep=${rings.length}`, "#axiom: RING1"]
		: [
				// The foot goes SUNK down into the parent volume, and the first ring from its end up again.
				`#define FOOT(5,180,0,0,${SUNK},1,1,${material})`,
				...definitions,
				`#define finalStep=${rings.length + 1}`,
				"#axiom: FOOT",
				"FOOT -> FOOT[RING1(,180,,,,,,)]_{E}",
			];
	return `${[`#module ${WHORLS[organ]}`, ...lines, ...productions].join("\n")}\n`;
}

/** Returns the name of the volume of a ring, counted from 0. */
const ringName = (index: number): string => `RING${index + 1}`;

/**
 * Returns the productions that put the next volume or whorl on a ring's end, and organs on its sides.
 * @param above what grows on the ring's end; undefined for nothing
 * @param settingsAt the settings in the call of the organ on a face
 */
function ringProductions(
	name: string,
	above: string | undefined,
	organ: Whorled,
	{ faces }: Ring,
	settingsAt: (face: number) => string,
): string[] {
	const organs = Array.from(groupBySettings(faces, settingsAt), ([settings, group]) => {
		const sides = group.map((face) => `C${face}`).join(",");
		return `${name} -> ${name}[&${organ.toUpperCase()}${settings}]_{${sides}}`;
	});
	return above ? [`${name} -> ${name}[${above}]_{E}`, ...organs] : organs;
}

/** Groups faces by the settings of their call, so that a radial whorl is one line. */
function groupBySettings(faces: readonly number[], settingsAt: (face: number) => string): Map<string, number[]> {
	const groups = new Map<string, number[]>();
	for (const face of faces) groups.set(settingsAt(face), [...(groups.get(settingsAt(face)) ?? []), face]);
	return groups;
}

/** Returns whether an organ belongs to a whorl. */
export const isWhorled = (organ: Organ): organ is Whorled => Object.hasOwn(WHORLS, organ);
