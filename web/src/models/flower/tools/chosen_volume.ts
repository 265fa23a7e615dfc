/**
 * The volume that is chosen, by its descent: its number alone says little, for of a text that has changed another may have it.
 * Numbers, lines and sides may change, and it is still the second PETAL on the third RING of the STEM.
 */
import type { FlowerPlant, Volumes } from "../flower_plant";

/** From the first volume to the chosen one: what each is called, and which of those of that name on the one before. */
export type ChosenVolume = readonly { readonly label: string; readonly nth: number }[];

type Grown = Pick<FlowerPlant, "volumes">;

const NOBODY = 0xffffffff;

/** A volume of what has grown, to be known again; undefined where none of that number has. */
export function chosenOf(grown: Grown | undefined, volume: number | undefined): ChosenVolume | undefined {
	if (!grown || volume === undefined || !(volume >= 0 && volume < grown.volumes.order.length)) return undefined;
	const { parent, label, labels } = grown.volumes;
	const line: number[] = [];
	for (let at = volume; at !== NOBODY; at = parent[at]) line.push(at);
	line.reverse();
	const before = new Uint32Array(line.length);
	// Each stands behind what it grew from, so that one way through all of them passes the line in its order.
	for (let at = 0, next = 0; next < line.length; at++)
		if (at === line[next]) next++;
		else if (isNext(grown.volumes, at, line[next - 1] ?? NOBODY, label[line[next]])) before[next]++;
	return line.map((at, i) => ({ label: labels[label[at]], nth: before[i] }));
}

/** Its number in what has grown now; undefined where that has none of its descent. */
export function stillChosen(grown: Grown | undefined, chosen: ChosenVolume | undefined): number | undefined {
	if (!grown || !chosen) return undefined;
	const { volumes } = grown;
	const labels = volumes.labels.length;
	let [last, next, before] = [NOBODY, 0, 0];
	for (let at = 0; at < volumes.order.length && next < chosen.length; at++) {
		const { label, nth } = chosen[next];
		const own = volumes.label[at];
		if (own >= labels || volumes.labels[own] !== label || volumes.parent[at] !== last) continue;
		if (before++ < nth) continue;
		[last, next, before] = [at, next + 1, 0];
	}
	return next === chosen.length ? last : undefined;
}

const isNext = ({ parent, label }: Volumes, at: number, from: number, called: number): boolean =>
	parent[at] === from && label[at] === called;
