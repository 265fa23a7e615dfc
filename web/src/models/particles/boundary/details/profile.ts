/** The field `profile`: the curve that is revolved for a boundary of the shape `spline`. */

import type { Field } from "../../../../specimen/model_schema";
import { type Notes, quote } from "../../../../specimen/notes";
import { readList, readNumbers } from "../../../../specimen/read_values";
import { onStep } from "../../../../specimen/table";
import { text } from "../../messages.generated";
import type { BoundedSpecimen, Knot } from "../bounded";

export const FEWEST_KNOTS = 3;
export const MAX_KNOTS = 24;
/** Largest radius, in half widths: a point may be dragged beyond the width. */
const WIDEST = 3;

/**
 * Returns a knot limited to its bounds and rounded to the steps of links.
 * @param radius in half widths
 * @param height as a share of the boundary's height
 */
export function knotAt(radius: number, height: number): Knot {
	return [onStep(Math.min(Math.max(radius, 0), WIDEST)), onStep(Math.min(Math.max(height, 0), 1))];
}

/** Creates the field `profile`. In links `profile=radius,height,…` in shares; in files a list of pairs. */
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
			const [points, before] = [profile, preset.profile].map((knots) => knots?.flat().join(",") ?? "");
			return points && points !== before ? [["profile", points]] : [];
		},
	};
}

/**
 * Reads a profile: pairs of radius and height from the lowest point up. Returns undefined, with a note, where it cannot
 * be read; notes values that are not used as given.
 */
function readProfile(key: string, value: unknown, notes: Notes): Knot[] | undefined {
	const numbers = readNumbers(Array.isArray(value) ? readList(value).flat() : value);
	if (!numbers || numbers.length % 2 > 0 || numbers.length < 2 * FEWEST_KNOTS) {
		const problem = text.message("not_a_profile", { value: quote(value), least: FEWEST_KNOTS });
		notes.add(key, problem, text("preset_profile_used"));
		return undefined;
	}
	if (numbers.length > 2 * MAX_KNOTS) {
		notes.add(key, text.message("more_than_points", { most: MAX_KNOTS }), text("first_used", { most: MAX_KNOTS }));
	}
	const given = Array.from({ length: Math.min(MAX_KNOTS, numbers.length / 2) }, (_, i) => {
		return [numbers[2 * i], numbers[2 * i + 1]] as const;
	});
	const knots = given.map(([radius, height]) => knotAt(radius, height));
	const outside = knots.some(([radius, height], i) => {
		return Math.abs(radius - given[i][0]) > 0.006 || Math.abs(height - given[i][1]) > 0.006;
	});
	if (outside) notes.add(key, text.message("profile_range", { most: WIDEST }), text("points_moved_in"));
	if (knots.some(([, height], i) => i > 0 && height < knots[i - 1][1])) {
		notes.add(key, text.message("heights_fall"), text("points_sorted"));
		knots.sort(([, a], [, b]) => a - b);
	}
	return knots;
}
