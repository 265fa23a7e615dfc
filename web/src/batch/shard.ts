/** A part of a series, for one of several machines. */
import { text } from "./messages.generated";
import { Unusable } from "./unusable";

/** The `index`-th of `total` parts, from 1. */
export interface Shard {
	readonly index: number;
	readonly total: number;
}

type Environment = Readonly<Record<string, string | undefined>>;

const MAX_SHARDS = 10_000;

/**
 * Reads `3/16`, or `auto` and `auto/16`: the index that a Slurm array or a Kubernetes indexed Job has set for this
 * task.
 * @throws Unusable
 */
export function readShard(written: string, environment: Environment): Shard {
	const [, place, count] = /^\s*(auto|\d+)\s*(?:\/\s*(\d+)\s*)?$/.exec(written) ?? [];
	const total = count === undefined ? undefined : Number(count);
	if (place === "auto") return checked(placeIn(environment, total));
	if (place === undefined || total === undefined) {
		throw new Unusable(text.message("shard_unreadable", { written }));
	}
	return checked({ index: Number(place), total });
}

/** Returns the seeds of a part, in order: parts follow one another, and their sizes differ by at most one. */
export function partOf<Item>(items: readonly Item[], { index, total }: Shard): Item[] {
	const start = (part: number) => Math.floor((part * items.length) / total);
	return items.slice(start(index - 1), start(index));
}

/**
 * Returns the part, if its numbers are possible.
 * @throws Unusable
 */
function checked({ index, total }: Shard): Shard {
	if (total < 1 || total > MAX_SHARDS)
		throw new Unusable(text.message("shard_parts", { total: `${total}`, max: MAX_SHARDS }));
	if (index < 1 || index > total)
		throw new Unusable(text.message("shard_part", { part: `${index}`, total: `${total}` }));
	return { index, total };
}

/**
 * Finds this machine's part by the variables that Slurm or a Kubernetes indexed job sets.
 * @param total number of parts, which Kubernetes does not set
 * @throws Unusable if there are no such variables
 */
function placeIn(environment: Environment, total: number | undefined): Shard {
	const read = (name: string) => {
		const value = environment[name]?.trim();
		return value && /^\d+$/.test(value) ? Number(value) : undefined;
	};
	const task = read("SLURM_ARRAY_TASK_ID");
	if (task !== undefined) return placeInSlurm(task, read, total);
	const completion = read("JOB_COMPLETION_INDEX");
	if (completion === undefined) {
		throw new Unusable(text.message("shard_no_task"));
	}
	if (total === undefined) throw new Unusable(text.message("shard_no_total"));
	return { index: completion + 1, total };
}

/**
 * Converts a task id of a Slurm array, which may begin at any number and have a step, to a part from 1 on.
 * @param wanted number of parts on the command line, which must be that of the array
 */
function placeInSlurm(task: number, read: (name: string) => number | undefined, wanted: number | undefined): Shard {
	const [least, step] = [read("SLURM_ARRAY_TASK_MIN") ?? 0, read("SLURM_ARRAY_TASK_STEP") ?? 1];
	const total = read("SLURM_ARRAY_TASK_COUNT");
	if (total === undefined) throw new Unusable(text.message("shard_no_count"));
	const index = (task - least) / step + 1;
	if (!Number.isInteger(index) || index < 1 || index > total) {
		throw new Unusable(text.message("shard_gaps", { task, total, first: least }));
	}
	if (wanted !== undefined && wanted !== total)
		throw new Unusable(text.message("shard_other_total", { total, wanted }));
	return { index, total };
}
