/** Berries taken off by hand. */

import type { Field } from "../../../specimen/model_schema";
import { type Notes, quote } from "../../../specimen/notes";
import { readList, readNumber } from "../../../specimen/read_values";
import type { BunchSpecimen } from "../specimen";

/** Ids of berries are below this (exports/panicle.h). */
export const BERRY_IDS = 2 ** 30;
/** Berries that can be taken off by hand: a link of as many still fits an address bar. */
export const MOST_THINNED = 500;

export const thinnedBerries: Field<BunchSpecimen> = {
	keys: ["thin", "thinned"],
	settings: ["thin=ID.ID.…"],
	fresh: () => ({ thinned: [] }),
	read: (specimen, key, value, notes) => {
		specimen.thinned = readThinned(key as "thin" | "thinned", value, notes);
	},
	query: ({ thinned }) => (thinned.length > 0 ? [["thin", writeThinned(thinned)]] : []),
};

/** Takes a berry off; the same specimen where it is off already or `MOST_THINNED` are. */
export function thin(specimen: BunchSpecimen, id: number): BunchSpecimen {
	const { thinned } = specimen;
	if (thinned.includes(id) || thinned.length >= MOST_THINNED) return specimen;
	return { ...specimen, thinned: [...thinned, id] };
}

/** Puts a berry back that was taken off. */
export function unthin(specimen: BunchSpecimen, id: number): BunchSpecimen {
	if (!specimen.thinned.includes(id)) return specimen;
	return { ...specimen, thinned: specimen.thinned.filter((each) => each !== id) };
}

/** Puts all of them back. */
export function unthinAll(specimen: BunchSpecimen): BunchSpecimen {
	return specimen.thinned.length === 0 ? specimen : { ...specimen, thinned: [] };
}

/** Ids in base 36: at most six letters or digits each. */
const BASE = 36;
const ID = /^[0-9a-z]{1,6}$/i;

/** `a1.b2.c3`, in the order in which they were taken off. */
function writeThinned(ids: readonly number[]): string {
	return ids.map((id) => id.toString(BASE)).join(".");
}

/**
 * Reads such a list, in which commas do as well as points. One that is named twice counts once.
 * @param key `thin`, whose text is in base 36, or `thinned`, the numbers themselves as a specimen holds them
 */
function readThinned(key: "thin" | "thinned", value: unknown, notes: Notes): number[] {
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
