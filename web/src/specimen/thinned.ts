/** Berries taken off by hand, as links and files list them. */
import { BERRY_IDS, MOST_THINNED } from "./limits";
import { type Notes, quote } from "./notes";
import { readList, readNumber } from "./read_values";

/** Ids in base 36: at most six letters or digits each. */
const BASE = 36;
const ID = /^[0-9a-z]{1,6}$/i;

/** `a1.b2.c3`, in the order in which they were taken off. */
export function writeThinned(ids: readonly number[]): string {
	return ids.map((id) => id.toString(BASE)).join(".");
}

/**
 * Reads such a list, in which commas do as well as points. One that is named twice counts once.
 * @param key `thin`, whose text is in base 36, or `thinned`, the numbers themselves as a specimen holds them
 */
export function readThinned(key: "thin" | "thinned", value: unknown, notes: Notes): number[] {
	const ids = new Set<number>();
	for (const part of partsOf(value)) {
		const id = readId(part, key === "thin" ? BASE : 10);
		if (id === undefined) notes.add(key, `${quote(part)} is not the id of a berry`, "left out");
		else if (ids.size < MOST_THINNED || ids.has(id)) ids.add(id);
		else {
			notes.add(key, `more than ${MOST_THINNED} berries`, `the first ${MOST_THINNED} are taken off`);
			break;
		}
	}
	return [...ids];
}

function partsOf(value: unknown): readonly unknown[] {
	if (typeof value !== "string") return readList(value);
	return value.trim() === "" ? [] : value.split(/[.,]/);
}

function readId(part: unknown, base: number): number | undefined {
	const id = typeof part === "string" && base === BASE ? fromBase36(part.trim()) : readNumber(part);
	return id !== undefined && Number.isInteger(id) && id >= 0 && id < BERRY_IDS ? id + 0 : undefined;
}

function fromBase36(text: string): number | undefined {
	return ID.test(text) ? Number.parseInt(text, BASE) : undefined;
}
