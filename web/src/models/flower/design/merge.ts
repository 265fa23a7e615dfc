/** Two changes of one text, line by line: one made by hand, one by a choice. */

/** What they come to. */
export interface Merged {
	readonly lines: readonly string[];
	/** Lines changed by hand in a place that the choice has changed too, so that they are not in `lines`. */
	readonly lost: readonly string[];
	/** The same with those retained instead, in place of what the choice made there. */
	readonly retained: readonly string[];
}

/**
 * @param base what both began with
 * @param mine with what was done by hand
 * @param made with what the choice makes
 */
export function merged(base: readonly string[], mine: readonly string[], made: readonly string[]): Merged {
	const found: Merging = { lines: [], lost: [], retained: [] };
	for (const stretch of stretches([base, mine, made], (line) => line)) {
		if (take(found, stretch)) continue;
		// Lines that stand side by side are different places: those of one name, and between them those that are as many.
		for (const named of stretches(stretch, nameOf))
			for (const place of inPairs(named)) if (!take(found, place)) giveWay(found, place);
	}
	return found;
}

/** What stands in one place: in what both began with, by hand, and as the choice makes it. */
type Stretch = readonly [was: readonly string[], own: readonly string[], other: readonly string[]];
type Merging = { readonly [key in keyof Merged]: string[] };

/** From one line whose key stands in all three to the next; those themselves are stretches of one line. */
function* stretches(
	[base, mine, made]: Stretch,
	keyOf: (line: string, of: number, at: number) => string,
): Iterable<Stretch> {
	const [keys, inMine, inMade] = [base, mine, made].map((lines, of) => lines.map((line, at) => keyOf(line, of, at)));
	const [toMine, toMade] = [matches(keys, inMine), matches(keys, inMade)];
	let [at, atMine, atMade] = [0, 0, 0];
	for (let next = 0; next < base.length; next++) {
		const [own, other] = [toMine[next], toMade[next]];
		if (own < 0 || other < 0) continue;
		yield [base.slice(at, next), mine.slice(atMine, own), made.slice(atMade, other)];
		yield [[base[next]], [mine[own]], [made[other]]];
		[at, atMine, atMade] = [next + 1, own + 1, other + 1];
	}
	yield [base.slice(at), mine.slice(atMine), made.slice(atMade)];
}

/** `#define length=`, `#define STEM(`, `#material 4`; of what has no name one that no other line has. */
const nameOf = (line: string, of: number, at: number): string => NAME.exec(line)?.[0] ?? `${of} ${at}`;
const NAME = /^#(?:define[ \t]+\p{L}[\p{L}\p{N}_]*[ \t]*[=(]?|material[ \t]+\d+)/u;

/** Where the choice, or else the hand, has put each line in the place of another: from one that the other of both has left to the next. */
function* inPairs(stretch: Stretch): Iterable<Stretch> {
	const [was, own, other] = stretch;
	const paired = areParallel(was, other) ? 2 : areParallel(was, own) ? 1 : undefined;
	if (paired === undefined) {
		yield stretch;
		return;
	}
	for (const each of stretches(stretch, (line, of, at) => (of === paired ? was[at] : line))) {
		if (each.some(({ length }) => length !== each[0].length)) yield each;
		else for (let i = 0; i < each[0].length; i++) yield [[each[0][i]], [each[1][i]], [each[2][i]]];
	}
}

/** Whether there are as many, and none of them stands elsewhere. */
const areParallel = (was: readonly string[], now: readonly string[]): boolean =>
	was.length === now.length && matches(was, now).every((to, at) => to < 0 || to === at);

/** Takes what one of the two has changed there, or both in one way or in words of their own; false where that is not so. */
function take({ lines, retained }: Merging, [was, own, other]: Stretch): boolean {
	const taken = same(own, was) || same(own, other) ? other : same(other, was) ? own : inWords([was, own, other]);
	if (!taken) return false;
	append(lines, taken);
	append(retained, taken);
	return true;
}

/** A line of which both have changed words, none of them the same: `#material` has a colour of the hand's, and another of the choice's. */
function inWords(all: Stretch): readonly string[] | undefined {
	if (all.some(({ length }) => length !== 1)) return undefined;
	const [was, own, other] = all.map(([line]) => line.split(/(\s+)/));
	if (was.length !== own.length || was.length !== other.length) return undefined;
	if (was.some((word, i) => own[i] !== word && other[i] !== word && own[i] !== other[i])) return undefined;
	return [was.map((word, i) => (own[i] === word ? other[i] : own[i])).join("")];
}

function giveWay({ lines, lost, retained }: Merging, [was, own, other]: Stretch): void {
	append(lines, other);
	append(retained, own);
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
