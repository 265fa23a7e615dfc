/**
 * The *growth* form: a plant's life as an animation that every reader of glTF plays. Its ages stand one in another's place, each a light
 * plant by itself; nodes' scales, which step from 0 to 1 and back, show one at a time. So colours, flowers and all that comes and
 * goes are those of that age. Morphing one mesh could not say them: stems and berries come and go, and few readers morph colours.
 */
import type { Part } from "../plant/part";
import type { About } from "./about";
import type { Moment } from "./animation";
import { exportGlb } from "./glb";
import { lightParts } from "./light";
import { paletted } from "./palette";

/** A plant at other ages. */
export interface Aged {
	/** From the youngest to the oldest, as the plant counts them. */
	readonly ages: readonly number[];
	at(age: number): Promise<Iterable<Part>>;
}

/** Of each age, at the most. */
const AGE_TRIANGLES = 5000;
/** How long the whole takes, and how long it rests at the end. */
const SECONDS = 10;
const REST = 2;
const PIXELS = 128;

/** The file: plain glTF; readers that play nothing show the oldest. Ages of which nothing stands yet are left out. */
export async function growthGlb({ ages, at }: Aged, about: About): Promise<Uint8Array<ArrayBuffer>> {
	const parts: Part[] = [];
	const moments = new Map<string, Moment>();
	for (const [i, age] of ages.entries()) {
		const children = paletted(await lightParts(await at(age), { triangles: AGE_TRIANGLES, pixels: PIXELS }));
		if (children.length === 0) continue;
		const name = `Age ${age}`;
		const time = (k: number) => (SECONDS * k) / (ages.length - 1);
		parts.push({ name, children });
		moments.set(name, { from: time(i), ...(i < ages.length - 1 ? { until: time(i + 1) } : { rest: SECONDS + REST }) });
	}
	return exportGlb(parts, about, { moments });
}
