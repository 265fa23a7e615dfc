/** The field `profile`: the curve that is revolved for a boundary of the shape `spline`. */

import type { Field } from "../../../../specimen/model_schema";
import { type Notes, quote } from "../../../../specimen/notes";
import { readList, readNumbers } from "../../../../specimen/read_values";
import { onStep } from "../../../../specimen/table";
import type { BoundedSpecimen, Knot } from "../bounded";

export const FEWEST_KNOTS = 3;
export const MOST_KNOTS = 24;
/** Largest radius, in half widths: a point may be dragged beyond the width. */
const WIDEST = 3;

/** A knot clamped to its bounds and rounded to the steps of links. */
export function knotAt(radius: number, height: number): Knot {
	return [onStep(Math.min(Math.max(radius, 0), WIDEST)), onStep(Math.min(Math.max(height, 0), 1))];
}

/** The field `profile`. In links `profile=radius,height,…` in shares; in files a list of pairs. */
export function profileOf<S extends BoundedSpecimen>(): Field<S> {
	return {
		keys: ["profile"],
		settings: ["profile=RADIUS,HEIGHT,…"],
		where: { shape: "spline" },
		read: (specimen, key, value, notes) => {
			const read = readProfile(key, value, notes);
			if (read) specimen.profile = read;
		},
		query: ({ profile }, preset) => {
			const [text, before] = [profile, preset.profile].map((knots) => knots?.flat().join(",") ?? "");
			return text && text !== before ? [["profile", text]] : [];
		},
	};
}

function readProfile(key: string, value: unknown, notes: Notes): Knot[] | undefined {
	const numbers = readNumbers(Array.isArray(value) ? readList(value).flat() : value);
	if (!numbers || numbers.length % 2 > 0 || numbers.length < 2 * FEWEST_KNOTS) {
		const problem = `${quote(value)} is not at least ${FEWEST_KNOTS} points like “0.5,0,1,0.4,0,1”`;
		notes.add(key, problem, "the preset's profile is used");
		return undefined;
	}
	if (numbers.length > 2 * MOST_KNOTS) {
		notes.add(key, `more than ${MOST_KNOTS} points`, `the first ${MOST_KNOTS} are used`);
	}
	const given = Array.from({ length: Math.min(MOST_KNOTS, numbers.length / 2) }, (_, i) => {
		return [numbers[2 * i], numbers[2 * i + 1]] as const;
	});
	const knots = given.map(([radius, height]) => knotAt(radius, height));
	const outside = knots.some(([radius, height], i) => {
		return Math.abs(radius - given[i][0]) > 0.006 || Math.abs(height - given[i][1]) > 0.006;
	});
	if (outside) notes.add(key, `radii lie from 0 to ${WIDEST}, heights from 0 to 1`, "points outside are brought in");
	if (knots.some(([, height], i) => i > 0 && height < knots[i - 1][1])) {
		notes.add(key, "heights must not fall", "the points are put in order");
		knots.sort(([, a], [, b]) => a - b);
	}
	return knots;
}
