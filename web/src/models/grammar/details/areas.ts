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
	MOST_AREAS,
	MOST_PATH,
	SMALLEST,
	type Triple,
	UNTURNED,
	unit,
} from "../areas/area";
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
		const [written, before] = [specimen, preset].map((each) => (each.areas ?? []).map(inWords).join(";"));
		return written === before ? [] : [["areas", written]];
	},
	unlinked: {
		keep: (specimen, preset) => {
			const own = specimen.areas?.some(({ mesh }, i) => mesh && !sameMesh(mesh, preset.areas?.[i]?.mesh));
			return own
				? "It is too short for the mesh of an area, in whose place it brings an ellipsoid: download JSON or GLB to keep the mesh, and drop the file to bring it back."
				: undefined;
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
		else notes.add(key, `${quote(value)} does not say of each place an earlier one`, "the main branch does not fork");
	},
	query: (specimen, preset) => {
		const [written, before] = [specimen, preset].map((each) => each.from?.join(",") ?? "");
		return written === before ? [] : [["from", written]];
	},
};

const near = (value: number): number => onStep(Math.min(Math.max(value, -FARTHEST), FARTHEST), MILLIMETRES);
const wide = (value: number): number => onStep(Math.min(Math.max(value, SMALLEST), FARTHEST), MILLIMETRES);

/** Normalises an area to the form of documents: rounded to the steps of a link. */
export function fittedArea({ kind, centre, size, rotation, mesh }: Area): Area {
	const length = Math.hypot(...rotation);
	const turn = Math.abs(length - 1) < SLACK && rotation[3] >= 0 ? rotation : unit(rotation);
	const sizes = size.map((value) => wide(value));
	return {
		kind,
		centre: centre.map(near) as unknown as Triple,
		size: (kind === "sphere" ? [sizes[0], sizes[0], sizes[0]] : sizes) as unknown as Triple,
		rotation: turn.map((value) => onStep(value, DECIMALS)) as unknown as AreaRotation,
		...(kind === "mesh" && mesh ? { mesh } : {}),
	};
}

/** Rounds places to the steps of a link, and limits their number. */
export const fittedPath = (places: readonly number[]): number[] => places.slice(0, 3 * MOST_PATH).map(near);

function inWords({ kind, centre, size, rotation }: Area): string {
	const turn = rotation.every((value, i) => value === UNTURNED[i]) ? [] : [rotation.join(",")];
	return [kind, centre.join(","), size.join(","), ...turn].join(":");
}

/** Reads areas; omits invalid ones with a note. `before` are the preset's, which may have meshes. */
function readAreas(key: string, value: unknown, before: readonly Area[] = [], notes: Notes): Area[] {
	const list = typeof value === "string" ? value.split(";").filter(Boolean) : Array.isArray(value) ? value : undefined;
	if (!list) {
		notes.add(key, `${quote(value)} is not a list of areas`, "the preset's are used");
		return [...before];
	}
	if (list.length > MOST_AREAS) notes.add(key, `more than ${MOST_AREAS} areas`, `the first ${MOST_AREAS} are used`);
	return list.slice(0, MOST_AREAS).flatMap((each, i) => readArea(key, each, before[i], notes) ?? []);
}

function readArea(key: string, value: unknown, before: Area | undefined, notes: Notes): Area | undefined {
	const fields = isRecord(value) ? value : ofText(value);
	const kind = AREA_KINDS.find((each) => each === fields.kind);
	const centre = numbers(fields.centre, 3);
	const size = numbers(fields.size, 3);
	const rotation = fields.rotation === undefined ? UNTURNED : numbers(fields.rotation, 4);
	if (!kind || !centre || !size || !rotation) {
		notes.add(key, `${quote(value)} is not an area like “box:0,0.8,0:1,1,1”`, "left out");
		return undefined;
	}
	const placed = { centre, size, rotation } as unknown as Pick<Area, "centre" | "size" | "rotation">;
	if (kind !== "mesh") return fittedArea({ kind, ...placed });
	const mesh = fields.mesh === undefined ? before?.mesh : readClosedMesh(key, fields.mesh, notes);
	if (mesh) return fittedArea({ kind, ...placed, mesh });
	notes.add(
		"mesh",
		"none came along",
		"links are too short for one, so an ellipsoid stands in its place until a file with it is dropped",
	);
	return fittedArea({ kind: "ellipsoid", ...placed });
}

function ofText(value: unknown): Readonly<Record<string, unknown>> {
	const [kind, centre, size, rotation] = typeof value === "string" ? value.split(":") : [];
	return { kind, centre, size, rotation };
}

function numbers(value: unknown, count: number): number[] | undefined {
	const read = value === undefined ? undefined : readNumbers(value);
	return read?.length === count && read.every(Number.isFinite) ? read : undefined;
}

/** Reads a path: empty if there are no places; undefined if it is invalid. */
function readPath(key: string, value: unknown, notes: Notes): number[] | undefined {
	const read = value === "" ? [] : readNumbers(value);
	if (!read || read.length % 3 !== 0 || !read.every(Number.isFinite)) {
		notes.add(key, `${quote(value)} is not places like “0,0,0,0,1,0”`, "the preset's are used");
		return undefined;
	}
	if (read.length > 3 * MOST_PATH) notes.add(key, `more than ${MOST_PATH} places`, `the first ${MOST_PATH} are used`);
	return fittedPath(read);
}
