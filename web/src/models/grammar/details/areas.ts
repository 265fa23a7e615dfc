/** Document fields of growth areas, which a text uses by bound() and reach(), and of the main branch's path. */

import { readClosedMesh, sameMesh } from "../../../specimen/closed_mesh";
import type { Field } from "../../../specimen/model_schema";
import { type Notes, quote } from "../../../specimen/notes";
import { isRecord, readNumbers } from "../../../specimen/read_values";
import { onStep } from "../../../specimen/table";
import {
	AREA_KINDS,
	type Area,
	type AreaRotation,
	FARTHEST,
	MAX_AREAS,
	MAX_PATH,
	SMALLEST,
	type Triple,
	UNTURNED,
	unit,
} from "../areas/area";
import { text } from "../messages.generated";
import type { GrammarSpecimen } from "../specimen";

/** Steps of a rotation's numbers: 1 / DECIMALS. */
const DECIMALS = 10_000;
/** Deviation of a rotation's length from 1 that is accepted as rounding. */
const SLACK = 1e-3;
const MILLIMETRES = 1000;

/** `areas=box:0,0.8,0:1,1,1;cone:0,2,0:1,2,1:0,0,0.38,0.92`: kind, centre, size, and optionally the rotation. */
export const areas: Field<GrammarSpecimen> = {
	keys: ["areas"],
	settings: ["areas=KIND:X,Y,Z:W,H,D:QX,QY,QZ,QW;…"],
	read: (specimen, key, value, notes) => {
		const read = readAreas(key, value, specimen.areas, notes);
		if (read.length > 0) specimen.areas = read;
		else delete specimen.areas;
	},
	query: (specimen, preset) => {
		const [written, before] = [specimen, preset].map((each) => (each.areas ?? []).map(writeArea).join(";"));
		return written === before ? [] : [["areas", written]];
	},
	unlinked: {
		keep: (specimen, preset) => {
			const own = specimen.areas?.some(({ mesh }, i) => mesh && !sameMesh(mesh, preset.areas?.[i]?.mesh));
			return own ? text("link_without_mesh") : undefined;
		},
		missing: () => {},
	},
};

/** `path=x,y,z,x,y,z,…`: places that the main branch passes, metres. */
export const path: Field<GrammarSpecimen> = {
	keys: ["path"],
	settings: ["path=X,Y,Z,…"],
	read: (specimen, key, value, notes) => {
		const read = readPath(key, value, notes);
		if (read) delete specimen.from;
		if (read?.length) specimen.path = read;
		else if (read) delete specimen.path;
	},
	query: (specimen, preset) => {
		const [written, before] = [specimen, preset].map((each) => each.path?.join(",") ?? "");
		return written === before ? [] : [["path", written]];
	},
};

/** `from=0,1,2,1`: for each place of the path the place before it, counted from 1, if the branch forks. */
export const from: Field<GrammarSpecimen> = {
	keys: ["from"],
	settings: ["from=0,1,…"],
	read: (specimen, key, value, notes) => {
		const read = value === "" ? [] : readNumbers(value);
		const places = (specimen.path?.length ?? 0) / 3;
		const sound = read?.every((before, i) => Number.isInteger(before) && before <= i && before >= Math.min(i, 1));
		if (read?.length === 0) delete specimen.from;
		else if (read && sound && read.length === places) specimen.from = read;
		else notes.add(key, text.message("not_earlier_points", { value: quote(value) }), text("no_fork"));
	},
	query: (specimen, preset) => {
		const [written, before] = [specimen, preset].map((each) => each.from?.join(",") ?? "");
		return written === before ? [] : [["from", written]];
	},
};

/** Limits a coordinate in metres to the range and rounds it to millimetres. */
const fittedCoordinate = (value: number): number => onStep(Math.min(Math.max(value, -FARTHEST), FARTHEST), MILLIMETRES);
/** Limits a size in metres to the range and rounds it to millimetres. */
const fittedSize = (value: number): number => onStep(Math.min(Math.max(value, SMALLEST), FARTHEST), MILLIMETRES);

/** Normalises an area to the form of documents: rounded to the steps of a link. */
export function fittedArea({ kind, centre, size, rotation, mesh }: Area): Area {
	const length = Math.hypot(...rotation);
	const turn = Math.abs(length - 1) < SLACK && rotation[3] >= 0 ? rotation : unit(rotation);
	const sizes = size.map((value) => fittedSize(value));
	return {
		kind,
		centre: centre.map(fittedCoordinate) as unknown as Triple,
		size: (kind === "sphere" ? [sizes[0], sizes[0], sizes[0]] : sizes) as unknown as Triple,
		rotation: turn.map((value) => onStep(value, DECIMALS)) as unknown as AreaRotation,
		...(kind === "mesh" && mesh ? { mesh } : {}),
	};
}

/** Rounds the coordinates of places to the steps of a link, and limits the number of places. */
export const fittedPath = (places: readonly number[]): number[] => places.slice(0, 3 * MAX_PATH).map(fittedCoordinate);

/** Writes an area as in links: kind, centre, size and, where it is turned, rotation. */
function writeArea({ kind, centre, size, rotation }: Area): string {
	const turn = rotation.every((value, i) => value === UNTURNED[i]) ? [] : [rotation.join(",")];
	return [kind, centre.join(","), size.join(","), ...turn].join(":");
}

/** Reads areas; omits invalid ones with a note. `before` are the preset's, which may have meshes. */
function readAreas(key: string, value: unknown, before: readonly Area[] = [], notes: Notes): Area[] {
	const list = typeof value === "string" ? value.split(";").filter(Boolean) : Array.isArray(value) ? value : undefined;
	if (!list) {
		notes.add(key, text.message("not_areas", { value: quote(value) }), text("preset_areas_used"));
		return [...before];
	}
	if (list.length > MAX_AREAS)
		notes.add(key, text.message("too_many_areas", { most: MAX_AREAS }), text("first_used", { most: MAX_AREAS }));
	return list.slice(0, MAX_AREAS).flatMap((each, i) => readArea(key, each, before[i], notes) ?? []);
}

/**
 * Reads an area from the outside; `before` is the area that it replaces, whose mesh is used if the new one has none.
 */
function readArea(key: string, value: unknown, before: Area | undefined, notes: Notes): Area | undefined {
	const fields = isRecord(value) ? value : fieldsOfText(value);
	const kind = AREA_KINDS.find((each) => each === fields.kind);
	const centre = readCount(fields.centre, 3);
	const size = readCount(fields.size, 3);
	const rotation = fields.rotation === undefined ? UNTURNED : readCount(fields.rotation, 4);
	if (!kind || !centre || !size || !rotation) {
		notes.add(key, text.message("not_an_area", { value: quote(value) }), text("left_out"));
		return undefined;
	}
	const placed = { centre, size, rotation } as unknown as Pick<Area, "centre" | "size" | "rotation">;
	if (kind !== "mesh") return fittedArea({ kind, ...placed });
	const mesh = fields.mesh === undefined ? before?.mesh : readClosedMesh(key, fields.mesh, notes);
	if (mesh) return fittedArea({ kind, ...placed, mesh });
	notes.add("mesh", text.message("mesh_missing"), text("ellipsoid_used"));
	return fittedArea({ kind: "ellipsoid", ...placed });
}

/** Splits the text of an area at its colons into fields, which are not checked. */
function fieldsOfText(value: unknown): Readonly<Record<string, unknown>> {
	const [kind, centre, size, rotation] = typeof value === "string" ? value.split(":") : [];
	return { kind, centre, size, rotation };
}

/** Reads a list of `count` finite numbers; undefined where it is not one. */
function readCount(value: unknown, count: number): number[] | undefined {
	const read = value === undefined ? undefined : readNumbers(value);
	return read?.length === count && read.every(Number.isFinite) ? read : undefined;
}

/** Reads a path: empty if there are no places; undefined if it is invalid. */
function readPath(key: string, value: unknown, notes: Notes): number[] | undefined {
	const read = value === "" ? [] : readNumbers(value);
	if (!read || read.length % 3 !== 0 || !read.every(Number.isFinite)) {
		notes.add(key, text.message("not_points", { value: quote(value) }), text("preset_areas_used"));
		return undefined;
	}
	if (read.length > 3 * MAX_PATH)
		notes.add(key, text.message("too_many_points", { most: MAX_PATH }), text("first_used", { most: MAX_PATH }));
	return fittedPath(read);
}
