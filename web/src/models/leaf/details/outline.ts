/** The field `outline`: the preset's outline, edited, or traced from a picture. */

import type { Field } from "../../../specimen/model_schema";
import { type Notes, quote } from "../../../specimen/notes";
import { isRecord, readNumber } from "../../../specimen/read_values";
import { packOutline, unpackOutline } from "../outline/packed";
import {
	doubleArea,
	FEWEST_POINTS,
	KINDS,
	type LeafKind,
	MOST_POINTS,
	type OutlinePoint,
	placed,
} from "../outline/points";
import { enclosesBlade } from "../outline/spline";
import type { LeafSpecimen } from "../specimen";

const KEY = "outline";
const LINK = "o";
const BEFORE = "the preset's is used";

export const outlinePoints: Field<LeafSpecimen> = {
	keys: [LINK, KEY],
	fresh: () => ({ outline: [] }),
	read(specimen, key, value, notes) {
		const given = typeof value === "string" ? unpackOutline(value) : listed(value);
		if (given === undefined) notes.add(key, `${quote(value)} is not an outline`, BEFORE);
		else specimen.outline = fitted(key, given, notes) ?? specimen.outline;
	},
	query({ outline }, preset) {
		const packed = packOutline(outline);
		return packed === packOutline(preset.outline) ? [] : [[LINK, packed]];
	},
};

/** Reads a list of points, `{ x, y, kind }` or `[x, y, kind]`; undefined where an item is not a point. */
function listed(value: unknown): OutlinePoint[] | undefined {
	if (!Array.isArray(value)) return undefined;
	const points = value.slice(0, MOST_POINTS + 1).map(point);
	return points.every((each) => each !== undefined) ? (points as OutlinePoint[]) : undefined;
}

function point(value: unknown): OutlinePoint | undefined {
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

/** Corrects an outline: within range and counter-clockwise; undefined where it does not enclose a blade. */
function fitted(key: string, given: readonly OutlinePoint[], notes: Notes): OutlinePoint[] | undefined {
	if (given.length < FEWEST_POINTS) {
		const points = given.length === 1 ? "1 point encloses" : `${given.length} points enclose`;
		notes.add(key, `${points} nothing`, BEFORE);
		return undefined;
	}
	if (given.length > MOST_POINTS) {
		notes.add(key, `more than ${MOST_POINTS} points`, `the first ${MOST_POINTS} are used`);
	}
	const points = given.slice(0, MOST_POINTS).map((each) => ({ ...placed(each), kind: each.kind }));
	if (points.some(({ x, y }, index) => Math.abs(x - given[index].x) > 0.001 || Math.abs(y - given[index].y) > 0.001)) {
		notes.add(key, "some points are farther away than a leaf reaches", "the nearest places are used");
	}
	if (points[0].x !== 0 || points[0].y !== 0) {
		notes.add(key, "the first point is not at the petiole, 0, 0", "it is taken there");
		points[0] = { ...points[0], x: 0, y: 0 };
	}
	const round = doubleArea(points) > 0 ? points : [points[0], ...points.slice(1).reverse()];
	if (enclosesBlade(round)) return round;
	notes.add(key, "it encloses nothing or crosses itself", BEFORE);
	return undefined;
}
