/**
 * The field of models whose plants react to their surroundings: the values that a stand computes for one of its plants.
 */

import { text } from "./messages.generated";
import type { Field } from "./model_schema";
import { type Notes, quote } from "./notes";
import { readNumbers } from "./read_values";
import type { Specimen } from "./specimen";

/** A specimen with this field. */
export interface WithSurroundings {
	/**
	 * Eight heights of the horizon in whole degrees, from +X to +Z, and eight lengths of free room in metres, to the
	 * centimetre; absent: open ground.
	 */
	surroundings?: readonly number[];
}

/** Directions around a plant. */
const SIDES = 8;
const STEEPEST = 90;
/** Least and greatest free room, metres. */
const ROOM = [0.01, 99] as const;

/** Creates the field, whose key in links is `about`. */
export function surroundingsDetail<S extends Specimen & WithSurroundings>(): Field<S> {
	return {
		keys: ["about", "surroundings"],
		settings: ["about=DEGREES × 8,METRES × 8"],
		read: (specimen, key, value, notes) => {
			const read = readSurroundings(key, value, notes);
			if (read) specimen.surroundings = read;
			else delete specimen.surroundings;
		},
		query: ({ surroundings }) => (surroundings ? [["about", surroundings.join(",")]] : []),
	};
}

/**
 * Reads SIDES angles in degrees, then SIDES distances in metres; values out of range are set to the nearest. Undefined
 * for a plant that grows alone.
 */
function readSurroundings(key: string, value: unknown, notes: Notes): number[] | undefined {
	if (value === "") return undefined;
	const numbers = readNumbers(value);
	if (numbers?.length !== 2 * SIDES) {
		notes.add(
			key,
			text.message("neighbours_unreadable", { value: quote(value), count: 2 * SIDES }),
			text("grown_alone"),
		);
		return undefined;
	}
	const within = (number: number, least: number, most: number, steps: number) =>
		Math.round(steps * Math.min(most, Math.max(least, number))) / steps;
	const read = numbers.map((number, i) => (i < SIDES ? within(number, 0, STEEPEST, 1) : within(number, ...ROOM, 100)));
	if (numbers.some((number, i) => number < (i < SIDES ? 0 : ROOM[0]) || number > (i < SIDES ? STEEPEST : ROOM[1])))
		notes.add(key, text.message("out_of_range"), text("nearest_used"));
	return read;
}
