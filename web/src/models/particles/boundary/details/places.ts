/** Lists of numbers in metres: the places that particles make for, the boxes in which nothing grows. */
import { type Notes, quote } from "../../../../specimen/notes";
import { readList, readNumbers } from "../../../../specimen/read_values";
import type { Detail } from "../../../../specimen/species";
import { onStep } from "../../../../specimen/table";
import type { Bounded, BoundedSpecimen } from "../bounded";

/** Metres from the middle of the ground, each way. */
const FARTHEST = 100;

/** As many as the core takes (wasm-core/src/models/particles/obstacles.hpp). */
export const MOST_OBSTACLES = 16;

interface Rows {
	readonly field: "targets" | "obstacles" | "rounds";
	/** Numbers of one of them. */
	readonly width: number;
	readonly most: number;
	/** As the command line's help writes it. */
	readonly setting: string;
	/** One, in words. */
	readonly one: string;
	/** Puts what was read into one form. */
	readonly fitted?: (row: number[]) => number[];
}

/** `targets=x,y,z,…`. */
export function targetsOf<S extends BoundedSpecimen>(): Detail<S> {
	return rows({ field: "targets", width: 3, most: 60, setting: "targets=X,Y,Z,…", one: "places like “0,0,0”" });
}

/** `obstacles=x,y,z,x,y,z,…`: two opposite corners of each box. */
export function obstaclesOf<S extends BoundedSpecimen>(): Detail<S> {
	return rows({ ...BOXES, field: "obstacles", setting: "obstacles=X,Y,Z,X,Y,Z,…" });
}

/** `rounds=x,y,z,x,y,z,…`: two opposite corners of the box that each ellipsoid fills. */
export function roundsOf<S extends BoundedSpecimen>(): Detail<S> {
	return rows({ ...BOXES, field: "rounds", setting: "rounds=X,Y,Z,X,Y,Z,…" });
}

const BOXES = {
	width: 6,
	most: MOST_OBSTACLES,
	one: "boxes like “1,0,-2,1.5,4,2”",
	fitted: ([ax, ay, az, bx, by, bz]: number[]) => [
		...[Math.min(ax, bx), Math.min(ay, by), Math.min(az, bz)],
		...[Math.max(ax, bx), Math.max(ay, by), Math.max(az, bz)],
	],
};

function rows<S extends BoundedSpecimen>(kind: Rows): Detail<S> {
	const { field, setting } = kind;
	return {
		keys: [field],
		settings: [setting],
		read: (specimen, key, value, notes) => {
			const read = readRows(kind, key, value, notes);
			if (read?.length) (specimen as Bounded)[field] = read;
			else if (read) delete specimen[field];
		},
		query: (specimen, preset) => {
			const [text, before] = [specimen, preset].map((each) => each[field]?.join(",") ?? "");
			return text === before ? [] : [[field, text]];
		},
	};
}

/** None where there are none; undefined where they cannot be read. */
function readRows(kind: Rows, key: string, value: unknown, notes: Notes): number[] | undefined {
	const { width, most, one, fitted = (row) => row } = kind;
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
	return Array.from({ length: Math.min(count, most) }, (_, i) => numbers.slice(width * i, width * (i + 1))).flatMap(
		(row) => fitted(row.map((number) => onStep(Math.min(Math.max(number, -FARTHEST), FARTHEST)))),
	);
}
