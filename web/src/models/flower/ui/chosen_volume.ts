/**
 * The volume that is chosen, by its descent: its number alone says little, for of a text that has changed another may have it.
 * Numbers, lines and sides may change, and it is still the second PETAL on the third RING of the STEM.
 */
import type { FlowerPlant, Volumes } from "../flower_plant";

/** From the first volume to the chosen one: what each is called, and which of those of that name on the one before. */
export type ChosenVolume = readonly { readonly label: string; readonly nth: number }[];

type WithVolumes = Pick<FlowerPlant, "volumes">;

const NONE = 0xffffffff;

/** A volume of what has grown, to be known again; undefined where none of that number has. */
export function chosenOf(grown: WithVolumes | undefined, volume: number | undefined): ChosenVolume | undefined {
	if (!grown || volume === undefined || !(volume >= 0 && volume < grown.volumes.order.length)) return undefined;
	const { order, parent, label, labels } = grown.volumes;
	const line: number[] = [];
	for (let at = volume; at !== NONE; at = parent[at]) if (line.push(at) > order.length) return undefined; // It would go round.
	line.reverse();
	// What a volume is split into may stand behind what grows from it: each is looked at by its parent, in whatever order.
	const behind = new Map(line.map((at, i) => [parent[at], i]));
	const before = new Uint32Array(line.length);
	for (let at = 0; at < order.length; at++) {
		const next = behind.get(parent[at]);
		if (next !== undefined && at < line[next] && label[at] === label[line[next]]) before[next]++;
	}
	return line.map((at, i) => ({ label: labels[label[at]], nth: before[i] }));
}

/** Its number in what has grown now; undefined where that has none of its descent. */
export function stillChosen(grown: WithVolumes | undefined, chosen: ChosenVolume | undefined): number | undefined {
	if (!grown || !chosen) return undefined;
	const { labels, label } = grown.volumes;
	const { first, next } = childrenOf(grown.volumes);
	let last: number | undefined;
	for (const { label: called, nth } of chosen) {
		let at = first[last ?? first.length - 1];
		for (let before = 0; at !== NONE; at = next[at]) if (labels[label[at]] === called && before++ === nth) break;
		if (at === NONE) return undefined;
		last = at;
	}
	return last;
}

/** Of each volume, and behind the last of nobody, the first that grew from it; and of each the next that grew from the same. */
function childrenOf({ order, parent }: Volumes): { first: Uint32Array; next: Uint32Array } {
	const count = order.length;
	const first = new Uint32Array(count + 1).fill(NONE);
	const next = new Uint32Array(count);
	for (let at = count - 1; at >= 0; at--) {
		const from = Math.min(parent[at], count);
		next[at] = first[from];
		first[from] = at;
	}
	return { first, next };
}
