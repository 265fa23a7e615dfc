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
function footprintsOf(text: string): { from: number; to: number; volumes: string[] }[] {
	const bare = blankComments(text);
	const found: { from: number; to: number; volumes: string[] }[] = [];
	for (const head of bare.matchAll(/\bfootprint\s*(?:-->|->|→)/g)) {
		// A footprint inside the brackets of the previous one is ignored.
		if (head.index < (found.at(-1)?.to ?? 0)) continue;
		const volumes: string[] = [];
		let to = head.index + head[0].length;
		for (;;) {
			VOLUME.lastIndex = to;
			const opened = VOLUME.exec(bare);
			if (!opened) break;
			const inside = to + opened[0].length;
			const end = closing(bare, inside);
			volumes.push(bare.slice(inside, end));
			to = Math.min(bare.length, end + 1);
		}
		found.push({ from: head.index, to, volumes });
	}
	return found;
}

const VOLUME = /\s*(?:,\s*)?GrowVol\s*\(/y;

/** Returns the position of the bracket that closes the one before `from`; the text's end if none does. */
function closing(text: string, from: number): number {
	let depth = 1;
	for (let at = from; at < text.length; at++) {
		if (text[at] === "(") depth++;
		else if (text[at] === ")" && --depth === 0) return at;
	}
	return text.length;
}

/**
 * Returns the volumes of a text whose footprint consists of plain numbers; undefined if any number is random or
 * computed.
 */
export function writtenVolumes(text: string): readonly GrowthVolume[] | undefined {
	const found = footprintsOf(text)
		.flatMap(({ volumes }) => volumes)
		.map(volumeOf);
	const volumes = found.filter((volume) => volume !== undefined);
	return found.length > 0 && volumes.length === found.length ? volumes : undefined;
}

/** Default direction of lean, degrees from one volume to the next. */
const TURN = 137.5;

/**
 * Parses `1, 1, 4, 10, 2.5, 0, towards(90), at(1, 2)`. Returns undefined if a volume behind the first has no explicit
 * place, since the core computes it.
 */
function volumeOf(inside: string, index: number): GrowthVolume | undefined {
	const parts = partsOf(inside).map((part) => part.trim());
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
function partsOf(inside: string): string[] {
	const parts: string[] = [];
	let [from, depth] = [0, 0];
	for (let at = 0; at < inside.length; at++) {
		if (inside[at] === "(") depth++;
		else if (inside[at] === ")") depth--;
		else if (inside[at] === "," && depth === 0) {
			parts.push(inside.slice(from, at));
			from = at + 1;
		}
	}
	return [...parts, inside.slice(from)];
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
	const [first, ...others] = footprintsOf(text);
	if (!first) return `${text.trimEnd()}\n${footprint}\n`;
	const pieces = [text.slice(0, first.from), footprint];
	let done = first.to;
	for (const { from, to } of others) {
		pieces.push(text.slice(done, from));
		REST_OF_LINE.lastIndex = to;
		done = to + (REST_OF_LINE.exec(text)?.[0].length ?? 0);
	}
	return pieces.join("") + text.slice(done);
}
