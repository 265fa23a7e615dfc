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
 * Returns a ring for `count` organs: the first on face 1 or, if `half` is odd, midway between the first two positions.
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

/** Generates the module of a whorl, or of several whorls with the same count. */
export function whorlText({ organ, count, whorls, radius, material, call }: WhorlPlan): string {
	const rings = Array.from({ length: count === 0 ? 1 : whorls }, (_, i) => ringFor(count, HALF[organ] + i));
	const next = ORDER[ORDER.indexOf(organ) + 1];
	const sewn = rings.every(({ sides }) => sides === USUAL_SIDES);
	const lines = [`#module ${WHORLS[organ]}`];
	if (!sewn) lines.push(`#define FOOT(5,180,0,0,${SUNK},1,1,${material})`);
	rings.forEach(({ sides }, i) => {
		const across = Math.round(20 * radius * 0.9 ** i) / 10;
		const rise = i === 0 && !sewn ? RISE + SUNK : RISE;
		lines.push(`#define RING${i + 1}(${sides},0,0,0,${rise},${across},${across},${material})`);
	});
	if (sewn) lines.push(`#define finalStep=${rings.length}`, "#axiom: RING1");
	// Goes down into the parent volume and up again.
	else lines.push(`#define finalStep=${rings.length + 1}`, "#axiom: FOOT", "FOOT -> FOOT[RING1(,180,,,,,,)]_{E}");
	rings.forEach(({ sides, faces }, i) => {
		const ring = `RING${i + 1}`;
		const above = rings[i + 1] ? `RING${i + 2}` : next && `&${WHORLS[next]}`;
		if (above) lines.push(`${ring} -> ${ring}[${above}]_{E}`);
		for (const [settings, on] of alike(faces, (face) => call(i, face, sides)))
			lines.push(`${ring} -> ${ring}[&${organ.toUpperCase()}${settings}]_{${on.map((face) => `C${face}`).join(",")}}`);
	});
	return `${lines.join("\n")}\n`;
}

/** Groups faces by the settings of their call, so that a radial whorl is one line. */
function alike(faces: readonly number[], called: (face: number) => string): Map<string, number[]> {
	const found = new Map<string, number[]>();
	for (const face of faces) found.set(called(face), [...(found.get(called(face)) ?? []), face]);
	return found;
}

/** Returns whether an organ belongs to a whorl. */
export const isWhorled = (organ: Organ): organ is Whorled => Object.hasOwn(WHORLS, organ);
