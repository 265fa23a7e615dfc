/** What the JSON document says of a flower besides what it says of any plant. */
import type { FlowerPlant } from "./flower_plant";

export interface VolumeRecord {
	label: string;
	order: number;
	/** The volume that it grew from; absent of the first. */
	parent?: number;
	/** N, T, atx, aty, atz, H, L, W, m. */
	values: number[];
}

const NOBODY = 0xffffffff;

export function flowerRecord({ volumes }: FlowerPlant): { volumes: VolumeRecord[] } {
	const { labels, label, order, parent, values } = volumes;
	return {
		volumes: Array.from(label, (of, i) => ({
			label: labels[of],
			order: order[i],
			...(parent[i] === NOBODY ? {} : { parent: parent[i] }),
			values: [...values.subarray(9 * i, 9 * i + 9)],
		})),
	};
}
