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
 * @param edited the lines changed by hand
 * @param generated the lines that the choice generates
 */
export function merged(base: readonly string[], edited: readonly string[], generated: readonly string[]): Merged {
	const result: Merging = { lines: [], lost: [], retained: [] };
	for (const stretch of stretches([base, edited, generated], (line) => line)) {
		if (mergeCleanly(result, stretch)) continue;
		// Adjacent changed lines may be independent: lines that define the same name, and between those, lines that
		// pair up by count.
		for (const stretchByName of stretches(stretch, nameOf))
			for (const part of splitInPairs(stretchByName)) if (!mergeCleanly(result, part)) preferGenerated(result, part);
	}
	return result;
}

/** Corresponding lines of the three versions: the base, the version edited by hand and the choice's version. */
type Stretch = readonly [base: readonly string[], edited: readonly string[], generated: readonly string[]];
type Merging = { readonly [key in keyof Merged]: string[] };

/**
 * Splits a stretch at lines whose keys match in all three versions; each matching line becomes a stretch of its own.
 * @param keyOf returns the key of a line, by its version (0 base, 1 edited, 2 generated) and its index there
 */
function* stretches(
	[base, edited, generated]: Stretch,
	keyOf: (line: string, version: number, at: number) => string,
): Iterable<Stretch> {
	const [keys, editedKeys, generatedKeys] = [base, edited, generated].map((lines, version) =>
		lines.map((line, at) => keyOf(line, version, at)),
	);
	const [toEdited, toGenerated] = [matches(keys, editedKeys), matches(keys, generatedKeys)];
	let [at, atEdited, atGenerated] = [0, 0, 0];
	for (let next = 0; next < base.length; next++) {
		const [nextEdited, nextGenerated] = [toEdited[next], toGenerated[next]];
		if (nextEdited < 0 || nextGenerated < 0) continue;
		yield [base.slice(at, next), edited.slice(atEdited, nextEdited), generated.slice(atGenerated, nextGenerated)];
		yield [[base[next]], [edited[nextEdited]], [generated[nextGenerated]]];
		[at, atEdited, atGenerated] = [next + 1, nextEdited + 1, nextGenerated + 1];
	}
	yield [base.slice(at), edited.slice(atEdited), generated.slice(atGenerated)];
}

/**
 * Returns the name that a line defines (`#define length=`, `#define STEM(`, `#material 4`), or a unique key for a line
 * that defines none.
 */
const nameOf = (line: string, version: number, at: number): string => NAME.exec(line)?.[0] ?? `${version} ${at}`;
const NAME = /^#(?:define[ \t]+\p{L}[\p{L}\p{N}_]*[ \t]*[=(]?|material[ \t]+\d+)/u;

/**
 * Splits a stretch at lines that one version left unchanged, where the other version has as many lines as the base, so
 * that lines pair up by position. Yields the stretch itself where they do not.
 */
function* splitInPairs(stretch: Stretch): Iterable<Stretch> {
	const [base, edited, generated] = stretch;
	const paired = areParallel(base, generated) ? 2 : areParallel(base, edited) ? 1 : undefined;
	if (paired === undefined) {
		yield stretch;
		return;
	}
	for (const each of stretches(stretch, (line, version, at) => (version === paired ? base[at] : line))) {
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
function mergeCleanly({ lines, retained }: Merging, [base, edited, generated]: Stretch): boolean {
	const clean =
		equalLines(edited, base) || equalLines(edited, generated)
			? generated
			: equalLines(generated, base)
				? edited
				: mergeWords([base, edited, generated]);
	if (!clean) return false;
	append(lines, clean);
	append(retained, clean);
	return true;
}

/**
 * Merges a line word by word where the two versions changed different words, as of a `#material` with one colour
 * changed by hand and another by the choice. Undefined where the versions are not one line each, or changed the same
 * word.
 */
function mergeWords(stretch: Stretch): readonly string[] | undefined {
	if (stretch.some(({ length }) => length !== 1)) return undefined;
	const [base, edited, generated] = stretch.map(([line]) => line.split(/(\s+)/));
	if (base.length !== edited.length || base.length !== generated.length) return undefined;
	if (base.some((word, i) => edited[i] !== word && generated[i] !== word && edited[i] !== generated[i]))
		return undefined;
	return [base.map((word, i) => (edited[i] === word ? generated[i] : edited[i])).join("")];
}

/**
 * Resolves a stretch of lines that both versions changed: the generated lines win, and the edited lines that are lost
 * are listed. `retained` receives the edited lines.
 */
function preferGenerated({ lines, lost, retained }: Merging, [base, edited, generated]: Stretch): void {
	append(lines, generated);
	append(retained, edited);
	const [inBase, inEdited, inGenerated] = [new Set(base), new Set(edited), new Set(generated)];
	append(
		lost,
		edited.filter((line) => !inBase.has(line) && !inGenerated.has(line)),
	);
	// Where lines deleted by hand come back, the loss is those deleted lines.
	if (edited.every((line) => inBase.has(line)))
		append(
			lost,
			base.filter((line) => !inEdited.has(line)),
		);
}

/** Returns whether two lists have the same lines. */
const equalLines = (one: readonly string[], other: readonly string[]): boolean =>
	one.length === other.length && one.every((line, i) => line === other[i]);

/** Appends lines one by one: a spread call would exceed the engine's limit of arguments. */
function append(lines: string[], more: readonly string[]): void {
	for (const line of more) lines.push(line);
}

/** Limit of pairs of lines that are compared. */
const MAX_PAIRS = 4_000_000;

/**
 * Returns for each line of `from` the index of its match in `to`, or −1: equal lines at the start and end, and a
 * longest common subsequence of the lines between. Past `MAX_PAIRS` pairs the lines between are treated as unmatched.
 */
function matches(from: readonly string[], to: readonly string[]): number[] {
	const match = new Array<number>(from.length).fill(-1);
	let first = 0;
	while (first < from.length && first < to.length && from[first] === to[first]) match[first] = first++;
	let [endFrom, endTo] = [from.length, to.length];
	while (endFrom > first && endTo > first && from[endFrom - 1] === to[endTo - 1]) match[--endFrom] = --endTo;
	const [rows, columns] = [endFrom - first, endTo - first];
	if (rows * columns > MAX_PAIRS) return match;
	const longest = Array.from({ length: rows + 1 }, () => new Uint32Array(columns + 1));
	for (let i = rows - 1; i >= 0; i--)
		for (let j = columns - 1; j >= 0; j--)
			longest[i][j] =
				from[first + i] === to[first + j] ? longest[i + 1][j + 1] + 1 : Math.max(longest[i + 1][j], longest[i][j + 1]);
	for (let i = 0, j = 0; i < rows && j < columns; ) {
		if (from[first + i] === to[first + j]) match[first + i++] = first + j++;
		else if (longest[i + 1][j] >= longest[i][j + 1]) i++;
		else j++;
	}
	return match;
}
