/** A part of a series, for one of several machines. */
import { Unusable } from "./unusable";

/** The `index`-th of `total` parts, from 1. */
export interface Shard {
	readonly index: number;
	readonly total: number;
}

type Environment = Readonly<Record<string, string | undefined>>;

const MOST_SHARDS = 10_000;

/**
 * Reads `3/16`, or `auto` and `auto/16`: the index that a Slurm array or a Kubernetes indexed Job has set for this
 * task.
 * @throws Unusable
 */
export function readShard(text: string, environment: Environment): Shard {
	const [, place, count] = /^\s*(auto|\d+)\s*(?:\/\s*(\d+)\s*)?$/.exec(text) ?? [];
	const total = count === undefined ? undefined : Number(count);
	if (place === "auto") return checked(placeIn(environment, total));
	if (place === undefined || total === undefined) {
		throw new Unusable(
			`“${text}”: write PART/PARTS, as in 3/16, or auto in a Slurm array, auto/16 in a Kubernetes Job`,
		);
	}
	return checked({ index: Number(place), total });
}

/** The seeds of a part, in order: parts follow one another, and their sizes differ by at most one. */
export function partOf<Item>(items: readonly Item[], { index, total }: Shard): Item[] {
	const start = (part: number) => Math.floor((part * items.length) / total);
	return items.slice(start(index - 1), start(index));
}

function checked({ index, total }: Shard): Shard {
	if (total < 1 || total > MOST_SHARDS) throw new Unusable(`${total} parts; there may be 1 to ${MOST_SHARDS}`);
	if (index < 1 || index > total) throw new Unusable(`part ${index} of ${total}; parts count from 1 to ${total}`);
	return { index, total };
}

function placeIn(environment: Environment, total: number | undefined): Shard {
	const read = (name: string) => {
		const text = environment[name]?.trim();
		return text && /^\d+$/.test(text) ? Number(text) : undefined;
	};
	const task = read("SLURM_ARRAY_TASK_ID");
	if (task !== undefined) return placeInSlurm(task, read, total);
	const completion = read("JOB_COMPLETION_INDEX");
	if (completion === undefined) {
		throw new Unusable(
			"auto: neither SLURM_ARRAY_TASK_ID nor JOB_COMPLETION_INDEX is set; write PART/PARTS, as in 3/16",
		);
	}
	if (total === undefined)
		throw new Unusable("auto: a Kubernetes Job does not say how many parts there are; write auto/16");
	return { index: completion + 1, total };
}

function placeInSlurm(task: number, read: (name: string) => number | undefined, wanted: number | undefined): Shard {
	const [least, step] = [read("SLURM_ARRAY_TASK_MIN") ?? 0, read("SLURM_ARRAY_TASK_STEP") ?? 1];
	const total = read("SLURM_ARRAY_TASK_COUNT");
	if (total === undefined) throw new Unusable("auto: SLURM_ARRAY_TASK_COUNT is not set; write PART/PARTS, as in 3/16");
	const index = (task - least) / step + 1;
	if (!Number.isInteger(index) || index < 1 || index > total) {
		throw new Unusable(
			`auto: task ${task} of ${total} from ${least} has no place; number the array without gaps, as in 1-16`,
		);
	}
	if (wanted !== undefined && wanted !== total)
		throw new Unusable(`auto/${wanted}: the Slurm array has ${total} tasks`);
	return { index, total };
}
