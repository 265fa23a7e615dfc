/** Merges two changes of one text, line by line: one made by hand, one made by a choice (a three-way merge). */

/** The result of a merge. */
export interface Merged {
	readonly lines: readonly string[];
	/** Lines changed by hand that conflict with the choice, so that `lines` does not contain them. */
	readonly lost: readonly string[];
	/** The merged lines with `lost` retained in place of the choice's lines. */
	readonly retained: readonly string[];
}

/**
 * Merges two changes of `base`.
 * @param base the lines before both changes
 * @param mine the lines changed by hand
 * @param made the lines that the choice generates
 */
export function merged(base: readonly string[], mine: readonly string[], made: readonly string[]): Merged {
	const found: Merging = { lines: [], lost: [], retained: [] };
	for (const stretch of stretches([base, mine, made], (line) => line)) {
		if (take(found, stretch)) continue;
		// Adjacent changed lines may be independent: lines that define the same name, and between those, lines that
		// pair up by count.
		for (const named of stretches(stretch, nameOf))
			for (const place of inPairs(named)) if (!take(found, place)) giveWay(found, place);
	}
	return found;
}

/** Corresponding lines of the three versions: the base, the version edited by hand and the choice's version. */
type Stretch = readonly [was: readonly string[], own: readonly string[], other: readonly string[]];
type Merging = { readonly [key in keyof Merged]: string[] };

/**
 * Splits a stretch at lines whose keys match in all three versions; each matching line becomes a stretch of its own.
 */
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

/**
 * Returns the name that a line defines (`#define length=`, `#define STEM(`, `#material 4`), or a unique key for a line
 * that defines none.
 */
const nameOf = (line: string, of: number, at: number): string => NAME.exec(line)?.[0] ?? `${of} ${at}`;
const NAME = /^#(?:define[ \t]+\p{L}[\p{L}\p{N}_]*[ \t]*[=(]?|material[ \t]+\d+)/u;

/**
 * Pairs lines of one version with the base by position, if that version has as many lines as the base, and splits the
 * stretch at lines that the third version left unchanged.
 */
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

/** Returns whether both versions have as many lines and no unchanged line has moved. */
const areParallel = (was: readonly string[], now: readonly string[]): boolean =>
	was.length === now.length && matches(was, now).every((to, at) => to < 0 || to === at);

/**
 * Appends a stretch that merges without conflict: only one version changed it, both made the same change, or both
 * changed different words of one line. Returns false for a conflict.
 */
function take({ lines, retained }: Merging, [was, own, other]: Stretch): boolean {
	const taken = same(own, was) || same(own, other) ? other : same(other, was) ? own : inWords([was, own, other]);
	if (!taken) return false;
	append(lines, taken);
	append(retained, taken);
	return true;
}

/**
 * Merges a line word by word where the two versions changed different words, as of a `#material` with one colour
 * changed by hand and another by the choice.
 */
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
	// Where lines deleted by hand come back, the loss is those deleted lines.
	if (own.every((line) => inWas.has(line)))
		append(
			lost,
			was.filter((line) => !inOwn.has(line)),
		);
}

const same = (one: readonly string[], other: readonly string[]): boolean =>
	one.length === other.length && one.every((line, i) => line === other[i]);

/** Appends lines one by one: a spread call would exceed the engine's limit of arguments. */
function append(lines: string[], more: readonly string[]): void {
	for (const line of more) lines.push(line);
}

/** Limit of pairs of lines that are compared. */
const MOST_PAIRS = 4_000_000;

/**
 * Returns for each line of `from` the index of its match in `to`, or −1: equal lines at the start and end, and a
 * longest common subsequence of the lines between. Past `MOST_PAIRS` pairs the lines between are treated as unmatched.
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
