/** Two changes of one text, line by line: one made by hand, one by a choice. */

/** What they come to. */
export interface Merged {
	readonly lines: readonly string[];
	/** Lines changed by hand in a place that the choice has changed too, so that they are not in `lines`. */
	readonly lost: readonly string[];
	/** The same with those kept instead, in place of what the choice made there. */
	readonly kept: readonly string[];
}

/**
 * @param base what both began with
 * @param mine with what was done by hand
 * @param made with what the choice makes
 */
export function merged(base: readonly string[], mine: readonly string[], made: readonly string[]): Merged {
	const [inMine, inMade] = [matches(base, mine), matches(base, made)];
	const lines: string[] = [];
	const lost: string[] = [];
	const kept: string[] = [];
	const both = (all: readonly string[]) => {
		append(lines, all);
		append(kept, all);
	};
	let [at, atMine, atMade] = [0, 0, 0];
	while (at <= base.length) {
		// As far as the next line that stands in all three.
		let next = at;
		while (next < base.length && (inMine[next] < 0 || inMade[next] < 0)) next++;
		const [toMine, toMade] = next < base.length ? [inMine[next], inMade[next]] : [mine.length, made.length];
		const [was, own, other] = [base.slice(at, next), mine.slice(atMine, toMine), made.slice(atMade, toMade)];
		if (same(own, was) || same(own, other)) both(other);
		else if (same(other, was)) both(own);
		else {
			append(lines, other);
			append(kept, own);
			const [inWas, inOwn, inOther] = [new Set(was), new Set(own), new Set(other)];
			append(
				lost,
				own.filter((line) => !inWas.has(line) && !inOther.has(line)),
			);
			// What was taken out by hand and comes again is told by what comes.
			if (own.every((line) => inWas.has(line)))
				append(
					lost,
					was.filter((line) => !inOwn.has(line)),
				);
		}
		if (next < base.length) both([base[next]]);
		[at, atMine, atMade] = [next + 1, toMine + 1, toMade + 1];
	}
	return { lines, lost, kept };
}

const same = (one: readonly string[], other: readonly string[]): boolean =>
	one.length === other.length && one.every((line, i) => line === other[i]);

/** More than a call takes arguments. */
function append(lines: string[], more: readonly string[]): void {
	for (const line of more) lines.push(line);
}

/** Pairs of lines that are compared at the most: of a section some forty thousand lines long. */
const MOST_PAIRS = 4_000_000;

/**
 * Of each line of a text where it stands in the other, −1 where it does not: beginnings and ends that are the same, and between them a
 * longest common subsequence. Where that takes too long, nothing between them is taken for the same.
 */
function matches(from: readonly string[], to: readonly string[]): number[] {
	const found = new Array<number>(from.length).fill(-1);
	let first = 0;
	while (first < from.length && first < to.length && from[first] === to[first]) found[first] = first++;
	let [end, endOf] = [from.length, to.length];
	while (end > first && endOf > first && from[end - 1] === to[endOf - 1]) found[--end] = --endOf;
	const [rows, columns] = [end - first, endOf - first];
	if (rows * columns > MOST_PAIRS) return found;
	const longest = Array.from({ length: rows + 1 }, () => new Uint32Array(columns + 1));
	for (let i = rows - 1; i >= 0; i--)
		for (let j = columns - 1; j >= 0; j--)
			longest[i][j] =
				from[first + i] === to[first + j] ? longest[i + 1][j + 1] + 1 : Math.max(longest[i + 1][j], longest[i][j + 1]);
	for (let i = 0, j = 0; i < rows && j < columns; ) {
		if (from[first + i] === to[first + j]) found[first + i++] = first + j++;
		else if (longest[i + 1][j] >= longest[i][j + 1]) i++;
		else j++;
	}
	return found;
}
