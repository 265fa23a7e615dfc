/** Organs of a flower, measured as a flora does: flattened, by the numbers of their volumes. */
import type { FlowerPlant } from "../../../../web/src/models/flower/flower_plant";

export interface Organ {
	/** What it stands on. */
	bearer: string;
	/** Millimetres, along its middle and across where it is widest. */
	length: number;
	width: number;
}

const HEIGHT = 5;
const BREADTH = 6;

/** Petals, sepals and leaves with a vein and lobes, and small ones that are a chain. */
export function organsOf({ volumes }: FlowerPlant): Organ[] {
	const { labels, label, parent, values } = volumes;
	const name = (v: number) => labels[label[v]];
	const value = (v: number, field: number) => values[9 * v + field];
	const children = new Map<number, number[]>();
	for (const [v, of] of parent.entries()) children.set(of, [...(children.get(of) ?? []), v]);
	const next = (v: number, is: RegExp) => children.get(v)?.find((child) => is.test(name(child)));
	const chain = (v: number | undefined, is: RegExp): number[] =>
		v === undefined ? [] : [v, ...chain(next(v, is), is)];
	const long = (all: readonly number[]) => all.reduce((sum, v) => sum + value(v, HEIGHT), 0);
	const organs: Organ[] = [];
	for (let v = 0; v < label.length; v++) {
		const kind = name(v);
		const begins = (kind === "VEIN" || kind === "B") && name(parent[v]) !== kind;
		if (!begins) continue;
		const axis = chain(v, new RegExp(`^${kind}$`));
		const widths = axis.map((each) =>
			kind === "B"
				? value(each, BREADTH)
				: long(chain(next(each, /^RM1$/), /^RM/)) + long(chain(next(each, /^LM1$/), /^LM/)) + value(each, BREADTH),
		);
		organs.push({ bearer: name(parent[v]), length: long(axis), width: Math.max(...widths) });
	}
	return organs;
}

/** How wide all is that is petal, millimetres: the mean along x and z. */
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
