/** The field `outline`: the preset's outline, edited, or traced from a picture. */

import type { Field } from "../../../specimen/model_schema";
import { type Notes, quote } from "../../../specimen/notes";
import { isRecord, readNumber } from "../../../specimen/read_values";
import { text } from "../messages.generated";
import { packOutline, unpackOutline } from "../outline/packed";
import {
	doubleArea,
	FEWEST_POINTS,
	KINDS,
	type LeafKind,
	MAX_POINTS,
	type OutlinePoint,
	placed,
} from "../outline/points";
import { enclosesBlade } from "../outline/spline";
import type { LeafSpecimen } from "../specimen";

const KEY = "outline";
const LINK = "o";

export const outlinePoints: Field<LeafSpecimen> = {
	keys: [LINK, KEY],
	fresh: () => ({ outline: [] }),
	/** Reads the outline of a link or a file; where it cannot be used, the preset's stays, with a note. */
	read(specimen, key, value, notes) {
		const given = typeof value === "string" ? unpackOutline(value) : readPoints(value);
		if (given === undefined)
			notes.add(key, text.message("not_an_outline", { value: quote(value) }), text("preset_outline_used"));
		else specimen.outline = fitted(key, given, notes) ?? specimen.outline;
	},
	/** Returns the outline's part of a link; none where it is the preset's. */
	query({ outline }, preset) {
		const packed = packOutline(outline);
		return packed === packOutline(preset.outline) ? [] : [[LINK, packed]];
	},
};

/**
 * Reads a list of points, each `{ x, y, kind }` or `[x, y, kind]`; returns undefined where an item is not a point.
 */
function readPoints(value: unknown): OutlinePoint[] | undefined {
	if (!Array.isArray(value)) return undefined;
	const points = value.slice(0, MAX_POINTS + 1).map(readPoint);
	return points.every((each) => each !== undefined) ? (points as OutlinePoint[]) : undefined;
}

/**
 * Reads a point written as `[x, y, kind]` or as an object, with the kind as a name or a number; returns undefined where
 * it is unusable.
 */
function readPoint(value: unknown): OutlinePoint | undefined {
	const { x, y, kind } = Array.isArray(value)
		? { x: value[0], y: value[1], kind: value[2] }
		: isRecord(value)
			? value
			: {};
	const [across, up] = [readNumber(x), readNumber(y)];
	const known = typeof kind === "number" ? KINDS[kind] : (kind ?? "smooth");
	if (across === undefined || up === undefined || !KINDS.includes(known as LeafKind)) return undefined;
	return { x: across, y: up, kind: known as LeafKind };
}

/**
 * Corrects an outline: moves points into the range and makes it counter-clockwise. Returns undefined, with a note,
 * where it does not enclose a blade.
 * @param key the name of the field in the note
 */
function fitted(key: string, given: readonly OutlinePoint[], notes: Notes): OutlinePoint[] | undefined {
	if (given.length < FEWEST_POINTS) {
		notes.add(key, text.message("too_few_points", { count: given.length }), text("preset_outline_used"));
		return undefined;
	}
	if (given.length > MAX_POINTS) {
		notes.add(key, text.message("more_than_points", { most: MAX_POINTS }), text("first_used", { most: MAX_POINTS }));
	}
	const points = given.slice(0, MAX_POINTS).map((each) => ({ ...placed(each), kind: each.kind }));
	if (points.some(({ x, y }, index) => Math.abs(x - given[index].x) > 0.001 || Math.abs(y - given[index].y) > 0.001)) {
		notes.add(key, text.message("points_too_far"), text("nearest_used"));
	}
	if (points[0].x !== 0 || points[0].y !== 0) {
		notes.add(key, text.message("not_at_petiole"), text("moved_to_petiole"));
		points[0] = { ...points[0], x: 0, y: 0 };
	}
	const round = doubleArea(points) > 0 ? points : [points[0], ...points.slice(1).reverse()];
	if (enclosesBlade(round)) return round;
	notes.add(key, text.message("crosses"), text("preset_outline_used"));
	return undefined;
}
