/** A whorl: a ring that bears its organs on its sides and the next whorl on its end. The grammars of rings join an assembled flower. */
import type { Organ } from "./organs";

/** What each whorl's module is called, from the outside in. */
export const WHORLS = { sepal: "CALYX", petal: "COROLLA", stamen: "ANDROECIUM", pistil: "GYNOECIUM" } as const;
export type Whorled = keyof typeof WHORLS;
const ORDER: readonly Whorled[] = ["sepal", "petal", "stamen", "pistil"];
/** Where each begins to count, in halves of a gap: neighbours stand in each other's gaps. */
const HALF: Readonly<Record<Whorled, number>> = { sepal: 1, petal: 0, stamen: 1, pistil: 0 };

/** Of a ring, at the least: it is round. */
const FEWEST_SIDES = 10;

/** Of a ring wherever its organs are evenly apart on it: rings of one order are sewn to each other, and to a stem of as many sides. */
const USUAL_SIDES = 12;

/** So many sides, and on which of them organs stand. */
export interface Ring {
	readonly sides: number;
	/** From 1. */
	readonly faces: readonly number[];
}

/** A ring for so many organs, the first on its first face or, `half` on, in the middle between the first two. */
export function ringFor(count: number, half: number): Ring {
	if (count === 0) return { sides: USUAL_SIDES, faces: [] };
	const gap =
		USUAL_SIDES % (2 * count) === 0 ? USUAL_SIDES / count : 2 * Math.max(1, Math.ceil(FEWEST_SIDES / count / 2));
	const first = (half % 2) * (gap / 2);
	return { sides: gap * count, faces: Array.from({ length: count }, (_, i) => 1 + first + i * gap) };
}

/** How an organ is called on one face: settings of its module, as the text has them; empty where it has its own. */
export type Call = (whorl: number, face: number, sides: number) => string;

export interface WhorlPlan {
	readonly organ: Whorled;
	readonly count: number;
	readonly whorls: number;
	/** Millimetres. */
	readonly radius: number;
	/** The number of what rings are made of. */
	readonly material: number;
	readonly call: Call;
}

/** Of a ring, millimetres, and how deep one that is not sewn on is sunk into what bears it: rounded ends draw back, and would leave a gap. */
const RISE = 1.2;
const SUNK = 1;

/** The module of a whorl, or of several of one count. */
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
	// Down into what bears it, and up again.
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

/** Faces by how they are called, so that a radial whorl is one line. */
function alike(faces: readonly number[], called: (face: number) => string): Map<string, number[]> {
	const found = new Map<string, number[]>();
	for (const face of faces) found.set(called(face), [...(found.get(called(face)) ?? []), face]);
	return found;
}

/** Whether an organ stands in a whorl of the flower. */
export const isWhorled = (organ: Organ): organ is Whorled => Object.hasOwn(WHORLS, organ);
