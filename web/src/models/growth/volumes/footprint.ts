/** The growth volumes that a growth grammar's `footprint` has, read from its text and written into it: the text owns them. */
import { blankComments } from "../../../grammar_editor/comments";
import { type GrowthVolume, meanWidth } from "./volume";

const NUMBER = /^[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?°?$/i;
/** What has a number of its own in brackets. */
const CALL = /^(\w+)\s*\(([^()]*)\)$/;

/** The places of a text's footprints, and the text in the brackets of each volume. Reads each character a few times at most. */
function footprintsOf(text: string): { from: number; to: number; volumes: string[] }[] {
	const bare = blankComments(text);
	const found: { from: number; to: number; volumes: string[] }[] = [];
	for (const head of bare.matchAll(/\bfootprint\s*(?:-->|->|→)/g)) {
		// Inside the brackets of the previous footprint it is not a footprint.
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

/** The place of the bracket that closes what was opened right before; the end where none does. */
function closing(text: string, from: number): number {
	let depth = 1;
	for (let at = from; at < text.length; at++) {
		if (text[at] === "(") depth++;
		else if (text[at] === ")" && --depth === 0) return at;
	}
	return text.length;
}

/** Whether a text has nothing of its volumes drawn by chance or worked out: its footprint is what it says, in numbers alone. */
export function writtenVolumes(text: string): readonly GrowthVolume[] | undefined {
	const found = footprintsOf(text)
		.flatMap(({ volumes }) => volumes)
		.map(volumeOf);
	const volumes = found.filter((volume) => volume !== undefined);
	return found.length > 0 && volumes.length === found.length ? volumes : undefined;
}

/** From one volume to the next, degrees: where each leans to if nobody says. */
const TURN = 137.5;

/** `1, 1, 4, 10, 2.5, 0, towards(90), at(1, 2)`. Where those behind the first stand is worked out, unless it is said. */
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

/** Splits at the commas outside brackets. */
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

/** Shortest to the hundredth: centimetres, and hundredths of a degree. */
const written = (value: number): string => String(Math.round(value * 100) / 100 + 0);

/** A volume as the language has it; `at` and `towards` are always said, so that it stands where it stood. */
function lineOf({ id, base, height, top, middle, gradient, towards, at }: GrowthVolume): string {
	const numbers = [1, id, base, height, top, gradient].map(written).join(", ");
	const curved = middle === meanWidth(base, top) ? "" : `, wm(${written(middle)})`;
	return `GrowVol(${numbers}${curved}, towards(${written(towards)}), at(${at.map(written).join(", ")}))`;
}

/** Blanks, and the line's end. */
const REST_OF_LINE = /[ \t]*\n?/y;

/**
 * A text with these volumes in place of those it had: its first footprint holds them all, in numbers, and any other is taken out.
 * A text without a footprint gets one at its end.
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
