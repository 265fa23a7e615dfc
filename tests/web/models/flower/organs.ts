/** Organs of a flower, measured as a flora does: flattened, by the numbers of their volumes. */
import type { FlowerPlant } from "../../../../web/src/models/flower/flower_plant";

export interface Organ {
	/** Label of the volume that it grows on. */
	parentLabel: string;
	/** Millimetres, along its middle and across where it is widest. */
	length: number;
	width: number;
}

const HEIGHT = 5;
const BREADTH = 6;

/** Returns helpers for a plant's volumes: labels, sizes, and chains. */
function chainsOf({ volumes }: FlowerPlant) {
	const { labels, label, parent, values } = volumes;
	const name = (v: number) => labels[label[v]];
	const value = (v: number, field: number) => values[9 * v + field];
	const children = new Map<number, number[]>();
	for (const [v, of] of parent.entries()) children.set(of, [...(children.get(of) ?? []), v]);
	const next = (v: number, is: RegExp) => children.get(v)?.find((child) => is.test(name(child)));
	const chain = (v: number | undefined, is: RegExp): number[] =>
		v === undefined ? [] : [v, ...chain(next(v, is), is)];
	const long = (all: readonly number[]) => all.reduce((sum, v) => sum + value(v, HEIGHT), 0);
	/** Returns the volumes with a label whose parent has another label. */
	const begin = (kinds: readonly string[]) =>
		[...label.keys()].filter((v) => kinds.includes(name(v)) && name(parent[v]) !== name(v));
	return { name, value, parent, next, chain, long, begin };
}

/** Petals, sepals and leaves with a vein and lobes, and small ones that are a chain. */
export function organsOf(plant: FlowerPlant): Organ[] {
	const { name, value, parent, next, chain, long, begin } = chainsOf(plant);
	return begin(["VEIN", "B"]).map((v) => {
		const axis = chain(v, new RegExp(`^${name(v)}$`));
		const widths = axis.map((each) =>
			name(v) === "B"
				? value(each, BREADTH)
				: long(chain(next(each, /^RM1$/), /^RM/)) + long(chain(next(each, /^LM1$/), /^LM/)) + value(each, BREADTH),
		);
		return { parentLabel: name(parent[v]), length: long(axis), width: Math.max(...widths) };
	});
}

/** Measures filaments, styles and achenes: chains of prisms labelled `kind`, as thick as their thickest. */
export function rodsOf(plant: FlowerPlant, kind: string): Organ[] {
	const { name, value, parent, chain, long, begin } = chainsOf(plant);
	return begin([kind]).map((v) => {
		const axis = chain(v, new RegExp(`^${kind}$`));
		return {
			parentLabel: name(parent[v]),
			length: long(axis),
			width: Math.max(...axis.map((each) => value(each, BREADTH))),
		};
	});
}

/** Returns the width of all petals, millimetres: the mean along x and z. */
export function bloomWidth({ meshes }: FlowerPlant): number {
	const low = [Infinity, Infinity, Infinity];
	const high = [-Infinity, -Infinity, -Infinity];
	for (const { material, positions } of meshes) {
		if (material !== "petal") continue;
		for (let i = 0; i < positions.length; i++) {
			low[i % 3] = Math.min(low[i % 3], positions[i]);
			high[i % 3] = Math.max(high[i % 3], positions[i]);
		}
	}
	return 500 * (high[0] - low[0] + high[2] - low[2]);
}
