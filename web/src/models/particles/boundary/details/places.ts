/** Fields with lists of coordinates in metres: targets of particles and obstacles. */

import type { Field } from "../../../../specimen/model_schema";
import { type Notes, quote } from "../../../../specimen/notes";
import { readList, readNumbers } from "../../../../specimen/read_values";
import { onStep } from "../../../../specimen/table";
import { text } from "../../messages.generated";
import type { Bounded, BoundedSpecimen } from "../bounded";

/** Largest absolute coordinate, metres. */
export const FARTHEST = 100;

/** Most targets: more would make links too long to share. */
export const MAX_TARGETS = 60;
/** Most boxes and ellipsoids together, as in the core (wasm-core/src/models/particles/obstacles.hpp). */
export const MAX_OBSTACLES = 16;

type ListKey = "targets" | "obstacles" | "rounds";

interface Kind {
	/** Numbers of one item. */
	readonly width: number;
	readonly most: number;
	/** Message on a value that cannot be read. */
	readonly unreadable: "not_boxes" | "not_positions";
	/** Normalizes the numbers of one item. */
	readonly ordered: (row: readonly number[]) => readonly number[];
}

const BOXES: Kind = {
	width: 6,
	most: MAX_OBSTACLES,
	unreadable: "not_boxes",
	ordered: ([ax, ay, az, bx, by, bz]) => [
		...[Math.min(ax, bx), Math.min(ay, by), Math.min(az, bz)],
		...[Math.max(ax, bx), Math.max(ay, by), Math.max(az, bz)],
	],
};

const KINDS: Readonly<Record<ListKey, Kind>> = {
	targets: { width: 3, most: MAX_TARGETS, unreadable: "not_positions", ordered: (row) => row },
	obstacles: BOXES,
	rounds: BOXES,
};

/**
 * Returns the numbers of rows as a link can hold them: at most as many rows as allowed, limited to the range and
 * rounded to steps.
 */
export function fitted(field: ListKey, rows: readonly (readonly number[])[]): number[] {
	const { most, ordered } = KINDS[field];
	const near = (value: number) => onStep(Math.min(Math.max(value, -FARTHEST), FARTHEST));
	return rows.slice(0, most).flatMap((row) => ordered(row.map(near)));
}

/** Creates the field of the targets: `targets=x,y,z,…`. */
export function targetsOf<S extends BoundedSpecimen>(): Field<S> {
	return rowsField("targets", "targets=X,Y,Z,…");
}

/** Creates the field of the boxes: `obstacles=x,y,z,x,y,z,…`, two opposite corners of each box. */
export function obstaclesOf<S extends BoundedSpecimen>(): Field<S> {
	return rowsField("obstacles", "obstacles=X,Y,Z,X,Y,Z,…");
}

/**
 * Creates the field of the ellipsoids: `rounds=x,y,z,x,y,z,…`, two opposite corners of the box that each ellipsoid
 * fills.
 */
export function roundsOf<S extends BoundedSpecimen>(): Field<S> {
	return { ...rowsField<S>("rounds", "rounds=X,Y,Z,X,Y,Z,…"), agree: limitTogether };
}

/** Drops the last ellipsoids, with a note, where boxes and ellipsoids together are too many. */
function limitTogether(specimen: Bounded, notes: Notes): void {
	const { obstacles = [], rounds = [] } = specimen;
	const room = BOXES.width * MAX_OBSTACLES - obstacles.length;
	if (rounds.length <= room) return;
	const most = MAX_OBSTACLES;
	notes.add("rounds", text.message("too_many_with_boxes", { most }), text("first_used", { most }));
	if (room > 0) specimen.rounds = rounds.slice(0, room);
	else delete specimen.rounds;
}

/**
 * Creates the field of a list of rows of numbers.
 * @param setting the form of the value for help texts
 */
function rowsField<S extends BoundedSpecimen>(field: ListKey, setting: string): Field<S> {
	return {
		keys: [field],
		settings: [setting],
		read: (specimen, key, value, notes) => {
			const read = readRows(field, key, value, notes);
			if (read?.length) (specimen as Bounded)[field] = read;
			else if (read) delete specimen[field];
		},
		query: (specimen, preset) => {
			const [numbers, before] = [specimen, preset].map((each) => each[field]?.join(",") ?? "");
			return numbers === before ? [] : [[field, numbers]];
		},
	};
}

/**
 * Reads rows of coordinates; values out of range are replaced, with a note.
 * @returns an empty list where the value is empty; undefined where it cannot be read
 */
function readRows(field: ListKey, key: string, value: unknown, notes: Notes): number[] | undefined {
	const { width, most, unreadable } = KINDS[field];
	if (value === "" || (Array.isArray(value) && value.length === 0)) return [];
	const numbers = readNumbers(Array.isArray(value) ? readList(value).flat() : value);
	if (!numbers || numbers.length % width > 0) {
		notes.add(key, text.message(unreadable, { value: quote(value) }), text("preset_values_used"));
		return undefined;
	}
	const count = numbers.length / width;
	if (count > most) notes.add(key, text.message("more_than", { most }), text("first_used", { most }));
	if (numbers.some((number) => Math.abs(number) > FARTHEST)) {
		notes.add(key, text.message("too_far", { most: FARTHEST }), text("moved_in"));
	}
	return fitted(
		field,
		Array.from({ length: count }, (_, i) => numbers.slice(width * i, width * (i + 1))),
	);
}
