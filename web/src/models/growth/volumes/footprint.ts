/**
 * Reads the growth volumes of a growth grammar's `footprint` from its text and writes them into it; the text owns
 * them.
 */
import { blankComments } from "../../../grammar_editor/comments";
import { type GrowthVolume, meanWidth } from "./volume";

const NUMBER = /^[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?°?$/i;
/** Matches an argument with numbers in brackets. */
const CALL = /^(\w+)\s*\(([^()]*)\)$/;

/** Returns the positions of a text's footprints, and the text in the brackets of each volume. Linear time. */
function footprintsOf(text: string): { start: number; end: number; volumes: string[] }[] {
	const bare = blankComments(text);
	const footprints: { start: number; end: number; volumes: string[] }[] = [];
	for (const head of bare.matchAll(/\bfootprint\s*(?:-->|->|→)/g)) {
		// A footprint inside the brackets of the previous one is ignored.
		if (head.index < (footprints.at(-1)?.end ?? 0)) continue;
		const volumes: string[] = [];
		let end = head.index + head[0].length;
		for (;;) {
			VOLUME.lastIndex = end;
			const opened = VOLUME.exec(bare);
			if (!opened) break;
			const contentStart = end + opened[0].length;
			const bracket = closingBracket(bare, contentStart);
			volumes.push(bare.slice(contentStart, bracket));
			end = Math.min(bare.length, bracket + 1);
		}
		footprints.push({ start: head.index, end, volumes });
	}
	return footprints;
}

const VOLUME = /\s*(?:,\s*)?GrowVol\s*\(/y;

/** Returns the position of the bracket that closes the one before `contentStart`; the text's end if none does. */
function closingBracket(text: string, contentStart: number): number {
	let depth = 1;
	for (let index = contentStart; index < text.length; index++) {
		if (text[index] === "(") depth++;
		else if (text[index] === ")" && --depth === 0) return index;
	}
	return text.length;
}

/**
 * Returns the volumes of a text whose footprint consists of plain numbers; undefined if any number is random or
 * computed.
 */
export function writtenVolumes(text: string): readonly GrowthVolume[] | undefined {
	const parsed = footprintsOf(text)
		.flatMap(({ volumes }) => volumes)
		.map(volumeOf);
	const volumes = parsed.filter((volume) => volume !== undefined);
	return parsed.length > 0 && volumes.length === parsed.length ? volumes : undefined;
}

/** Default direction of lean, degrees from one volume to the next. */
const TURN = 137.5;

/**
 * Parses `1, 1, 4, 10, 2.5, 0, towards(90), at(1, 2)`. Returns undefined if a volume behind the first has no explicit
 * place, since the core computes it.
 */
function volumeOf(content: string, index: number): GrowthVolume | undefined {
	const parts = partsOf(content).map((part) => part.trim());
	const numbers = parts.filter((part) => NUMBER.test(part)).map(Number.parseFloat);
	const calls = parts.filter((part) => !NUMBER.test(part)).map((part) => CALL.exec(part));
	if (numbers.length !== 6 || numbers[0] !== 1) return undefined;
	const [, id, base, height, top, gradient] = numbers;
	const middle = meanWidth(base, top);
	if (index > 0 && !calls.some((call) => call?.[1] === "at")) return undefined;
	let volume: GrowthVolume = { id, base, height, top, middle, gradient, towards: (TURN * index) % 360, at: [0, 0] };
	for (const call of calls) {
		const values = call?.[2].split(",").map((value) => value.trim()) ?? [];
		if (!call || !values.every((value) => NUMBER.test(value))) return undefined;
		const [first, second] = values.map(Number.parseFloat);
		if (call[1] === "towards" && values.length === 1) volume = { ...volume, towards: first };
		else if (call[1] === "wm" && values.length === 1) volume = { ...volume, middle: first };
		else if (call[1] === "at" && values.length === 2) volume = { ...volume, at: [first, second] };
		else return undefined;
	}
	return volume;
}

/** Splits at commas outside brackets. */
function partsOf(content: string): string[] {
	const parts: string[] = [];
	let [partStart, depth] = [0, 0];
	for (let at = 0; at < content.length; at++) {
		if (content[at] === "(") depth++;
		else if (content[at] === ")") depth--;
		else if (content[at] === "," && depth === 0) {
			parts.push(content.slice(partStart, at));
			partStart = at + 1;
		}
	}
	return [...parts, content.slice(partStart)];
}

/** Writes a number to hundredths: centimetres, and hundredths of a degree. */
const written = (value: number): string => String(Math.round(value * 100) / 100 + 0);

/** Writes a volume. `at` and `towards` are always included, so that it keeps its place. */
function lineOf({ id, base, height, top, middle, gradient, towards, at }: GrowthVolume): string {
	const numbers = [1, id, base, height, top, gradient].map(written).join(", ");
	const curved = middle === meanWidth(base, top) ? "" : `, wm(${written(middle)})`;
	return `GrowVol(${numbers}${curved}, towards(${written(towards)}), at(${at.map(written).join(", ")}))`;
}

/** Matches blanks and the line's end. */
const REST_OF_LINE = /[ \t]*\n?/y;

/**
 * Replaces the volumes of a text: its first footprint holds them all as numbers, and others are removed. A text
 * without a footprint gets one at its end.
 */
export function withVolumes(text: string, volumes: readonly GrowthVolume[]): string {
	const head = "footprint -> ";
	const footprint = head + volumes.map(lineOf).join(`\n${" ".repeat(head.length)}`);
	const [firstFootprint, ...otherFootprints] = footprintsOf(text);
	if (!firstFootprint) return `${text.trimEnd()}\n${footprint}\n`;
	const pieces = [text.slice(0, firstFootprint.start), footprint];
	let copiedTo = firstFootprint.end;
	for (const { start, end } of otherFootprints) {
		pieces.push(text.slice(copiedTo, start));
		REST_OF_LINE.lastIndex = end;
		copiedTo = end + (REST_OF_LINE.exec(text)?.[0].length ?? 0);
	}
	return pieces.join("") + text.slice(copiedTo);
}
