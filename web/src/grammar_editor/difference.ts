/** Difference between two texts: the single stretch that was replaced. */
export interface Difference {
	readonly from: number;
	readonly to: number;
	readonly insert: string;
}

/** Returns the difference; undefined if the texts are equal. */
export function difference(before: string, after: string): Difference | undefined {
	if (before === after) return undefined;
	const shorter = Math.min(before.length, after.length);
	let from = 0;
	while (from < shorter && before[from] === after[from]) from++;
	let same = 0;
	while (same < shorter - from && before[before.length - 1 - same] === after[after.length - 1 - same]) same++;
	return { from, to: before.length - same, insert: after.slice(from, after.length - same) };
}
