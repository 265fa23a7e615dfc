/** Document field of berries removed by hand. */

import type { Field } from "../../../specimen/model_schema";
import { type Notes, quote } from "../../../specimen/notes";
import { readList, readNumber } from "../../../specimen/read_values";
import { text } from "../messages.generated";
import type { BunchSpecimen } from "../specimen";

/** Upper bound of berry ids (exports/panicle.h). */
export const BERRY_IDS = 2 ** 30;
/** Most berries that can be removed by hand: a link of as many still fits an address bar. */
export const MAX_THINNED = 500;

export const thinnedBerries: Field<BunchSpecimen> = {
	keys: ["thin", "thinned"],
	settings: ["thin=ID.ID.…"],
	fresh: () => ({ thinned: [] }),
	read: (specimen, key, value, notes) => {
		specimen.thinned = readThinned(key as "thin" | "thinned", value, notes);
	},
	query: ({ thinned }) => (thinned.length > 0 ? [["thin", writeThinned(thinned)]] : []),
};

/** Removes a berry; returns the same specimen if it is removed already or the limit is reached. */
export function thin(specimen: BunchSpecimen, id: number): BunchSpecimen {
	const { thinned } = specimen;
	if (thinned.includes(id) || thinned.length >= MAX_THINNED) return specimen;
	return { ...specimen, thinned: [...thinned, id] };
}

/** Restores a removed berry. */
export function unthin(specimen: BunchSpecimen, id: number): BunchSpecimen {
	if (!specimen.thinned.includes(id)) return specimen;
	return { ...specimen, thinned: specimen.thinned.filter((each) => each !== id) };
}

/** Restores all removed berries. */
export function unthinAll(specimen: BunchSpecimen): BunchSpecimen {
	return specimen.thinned.length === 0 ? specimen : { ...specimen, thinned: [] };
}

/** Ids in links: base 36, at most six letters or digits each. */
const BASE = 36;
const ID = /^[0-9a-z]{1,6}$/i;

/** Writes ids as `a1.b2.c3`, in order of removal. */
function writeThinned(ids: readonly number[]): string {
	return ids.map((id) => id.toString(BASE)).join(".");
}

/**
 * Parses a list of ids separated by dots or commas, without duplicates.
 * @param key `thin`, whose text is in base 36, or `thinned`, the numbers themselves as a specimen holds them
 */
function readThinned(key: "thin" | "thinned", value: unknown, notes: Notes): number[] {
	const ids = new Set<number>();
	for (const part of splitIds(value)) {
		const id = readId(part, key === "thin" ? BASE : 10);
		if (id === undefined) notes.add(key, text.message("not_a_berry", { value: quote(part) }), text("left_out"));
		else if (ids.size < MAX_THINNED || ids.has(id)) ids.add(id);
		else {
			notes.add(
				key,
				text.message("too_many_removed", { most: MAX_THINNED }),
				text("first_removed", { most: MAX_THINNED }),
			);
			break;
		}
	}
	return [...ids];
}

/** Splits a text at dots and commas; a list is returned as it is. */
function splitIds(value: unknown): readonly unknown[] {
	if (typeof value !== "string") return readList(value);
	return value.trim() === "" ? [] : value.split(/[.,]/);
}

/** Reads an id of a berry in a base; undefined for text that is not an id, and for ids out of range. */
function readId(part: unknown, base: number): number | undefined {
	const id = typeof part === "string" && base === BASE ? fromBase36(part.trim()) : readNumber(part);
	return id !== undefined && Number.isInteger(id) && id >= 0 && id < BERRY_IDS ? id + 0 : undefined;
}

/** Reads a number in base 36; undefined for text that is not an id. */
function fromBase36(text: string): number | undefined {
	return ID.test(text) ? Number.parseInt(text, BASE) : undefined;
}
