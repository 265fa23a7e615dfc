/** Fields with lists of coordinates in metres: targets of particles and obstacles. */

import type { Field } from "../../../../specimen/model_schema";
import { type Notes, quote } from "../../../../specimen/notes";
import { readList, readNumbers } from "../../../../specimen/read_values";
import { onStep } from "../../../../specimen/table";
import type { Bounded, BoundedSpecimen } from "../bounded";

/** Largest absolute coordinate, metres. */
export const FARTHEST = 100;

/** Most targets: more would make links too long to share. */
export const MOST_TARGETS = 60;
/** Most boxes and ellipsoids together, as in the core (wasm-core/src/models/particles/obstacles.hpp). */
export const MOST_OBSTACLES = 16;

type ListKey = "targets" | "obstacles" | "rounds";

interface Kind {
	/** Numbers of one item. */
	readonly width: number;
	readonly most: number;
	/** Items as a message names them. */
	readonly one: string;
	/** Normalizes the numbers of one item. */
	readonly ordered: (row: readonly number[]) => readonly number[];
}

const BOXES: Kind = {
	width: 6,
	most: MOST_OBSTACLES,
	one: "boxes like “1,0,-2,1.5,4,2”",
	ordered: ([ax, ay, az, bx, by, bz]) => [
		...[Math.min(ax, bx), Math.min(ay, by), Math.min(az, bz)],
		...[Math.max(ax, bx), Math.max(ay, by), Math.max(az, bz)],
	],
};

const KINDS: Readonly<Record<ListKey, Kind>> = {
	targets: { width: 3, most: MOST_TARGETS, one: "places like “0,0,0”", ordered: (row) => row },
	obstacles: BOXES,
	rounds: BOXES,
};

/** Rows that a link can hold: at most as many as allowed, clamped to the range and rounded to steps. */
export function fitted(field: ListKey, rows: readonly (readonly number[])[]): number[] {
	const { most, ordered } = KINDS[field];
	const near = (value: number) => onStep(Math.min(Math.max(value, -FARTHEST), FARTHEST));
	return rows.slice(0, most).flatMap((row) => ordered(row.map(near)));
}

/** `targets=x,y,z,…`. */
export function targetsOf<S extends BoundedSpecimen>(): Field<S> {
	return list("targets", "targets=X,Y,Z,…");
}

/** `obstacles=x,y,z,x,y,z,…`: two opposite corners of each box. */
export function obstaclesOf<S extends BoundedSpecimen>(): Field<S> {
	return list("obstacles", "obstacles=X,Y,Z,X,Y,Z,…");
}

/** `rounds=x,y,z,x,y,z,…`: two opposite corners of the box that each ellipsoid fills. */
export function roundsOf<S extends BoundedSpecimen>(): Field<S> {
	return { ...list<S>("rounds", "rounds=X,Y,Z,X,Y,Z,…"), agree: withObstacles };
}

/** Drops the last ellipsoids where boxes and ellipsoids together are too many. */
function withObstacles(specimen: Bounded, notes: Notes): void {
	const { obstacles = [], rounds = [] } = specimen;
	const room = BOXES.width * MOST_OBSTACLES - obstacles.length;
	if (rounds.length <= room) return;
	const most = `the first ${MOST_OBSTACLES} are used`;
	notes.add("rounds", `with the boxes of “obstacles” more than ${MOST_OBSTACLES}`, most);
	if (room > 0) specimen.rounds = rounds.slice(0, room);
	else delete specimen.rounds;
}

function list<S extends BoundedSpecimen>(field: ListKey, setting: string): Field<S> {
	return {
		keys: [field],
		settings: [setting],
		read: (specimen, key, value, notes) => {
			const read = readRows(field, key, value, notes);
			if (read?.length) (specimen as Bounded)[field] = read;
			else if (read) delete specimen[field];
		},
		query: (specimen, preset) => {
			const [text, before] = [specimen, preset].map((each) => each[field]?.join(",") ?? "");
			return text === before ? [] : [[field, text]];
		},
	};
}

/** @returns an empty list where the value is empty; undefined where it cannot be read */
function readRows(field: ListKey, key: string, value: unknown, notes: Notes): number[] | undefined {
	const { width, most, one } = KINDS[field];
	if (value === "" || (Array.isArray(value) && value.length === 0)) return [];
	const numbers = readNumbers(Array.isArray(value) ? readList(value).flat() : value);
	if (!numbers || numbers.length % width > 0) {
		notes.add(key, `${quote(value)} is not ${one}`, "the preset's are used");
		return undefined;
	}
	const count = numbers.length / width;
	if (count > most) notes.add(key, `more than ${most}`, `the first ${most} are used`);
	if (numbers.some((number) => Math.abs(number) > FARTHEST)) {
		notes.add(key, `farther than ${FARTHEST} m from the middle`, "they are brought in");
	}
	return fitted(
		field,
		Array.from({ length: count }, (_, i) => numbers.slice(width * i, width * (i + 1))),
	);
}
