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
	const both = (...all: readonly string[]) => {
		lines.push(...all);
		kept.push(...all);
	};
	let [at, atMine, atMade] = [0, 0, 0];
	while (at <= base.length) {
		// As far as the next line that stands in all three.
		let next = at;
		while (next < base.length && (inMine[next] < 0 || inMade[next] < 0)) next++;
		const [toMine, toMade] = next < base.length ? [inMine[next], inMade[next]] : [mine.length, made.length];
		const [was, own, other] = [base.slice(at, next), mine.slice(atMine, toMine), made.slice(atMade, toMade)];
		if (same(own, was) || same(own, other)) both(...other);
		else if (same(other, was)) both(...own);
		else {
			lines.push(...other);
			kept.push(...own);
			lost.push(...own.filter((line) => !was.includes(line) && !other.includes(line)));
			// What was taken out by hand and comes again is told by what comes.
			if (own.every((line) => was.includes(line))) lost.push(...was.filter((line) => !own.includes(line)));
		}
		if (next < base.length) both(base[next]);
		[at, atMine, atMade] = [next + 1, toMine + 1, toMade + 1];
	}
	return { lines, lost, kept };
}

const same = (one: readonly string[], other: readonly string[]): boolean =>
	one.length === other.length && one.every((line, i) => line === other[i]);

/** Of each line of a text where it stands in the other, by a longest common subsequence; −1 where it does not. */
function matches(from: readonly string[], to: readonly string[]): number[] {
	const longest = Array.from({ length: from.length + 1 }, () => new Uint32Array(to.length + 1));
	for (let i = from.length - 1; i >= 0; i--)
		for (let j = to.length - 1; j >= 0; j--)
			longest[i][j] = from[i] === to[j] ? longest[i + 1][j + 1] + 1 : Math.max(longest[i + 1][j], longest[i][j + 1]);
	const found = new Array<number>(from.length).fill(-1);
	for (let i = 0, j = 0; i < from.length && j < to.length; ) {
		if (from[i] === to[j]) found[i++] = j++;
		else if (longest[i + 1][j] >= longest[i][j + 1]) i++;
		else j++;
	}
	return found;
}
