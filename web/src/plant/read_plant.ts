/**
 * Reads a plant from the columns of an answer (layout: wasm-core/src/exports/panicle.h). Arrays are views of the
 * answer's bytes.
 */
import type { Columns } from "../core/container";
import type { Answer } from "../core/core";
import { readTrace } from "./derivation_trace";
import { EMPTY_PLANT, type Mesh, type MeshRun, type Organs, type Plant, type PlantMesh, type Segments } from "./plant";

/** The value of `cut_short` for the host's time limit, rather than a limit of the core. */
const CUT_BY_TIME = 2;

/** Reads the data that every model's plant has; models read their own from the same columns. */
export function readPlant({ columns, milliseconds }: Answer): Plant {
	const names = columns.lines("counts.names");
	const values = columns.uint32("counts");
	const plant: Plant = {
		segments: readSegments(columns),
		organs: readOrgans(columns),
		meshes: columns.lines("meshes").map((name) => readPlantMesh(columns, name)),
		counts: Object.fromEntries(names.map((name, index) => [name, values[index]])),
		notes: columns.lines("notes"),
		fingerprint: hexadecimal(columns.uint32("fingerprint")),
		timings: { grow: milliseconds },
	};
	if (columns.has("measures")) plant.measures = columns.floats("measures");
	if (columns.has("cut_short")) plant.cutShort = columns.uint32("cut_short")[0] === CUT_BY_TIME ? "time" : "limit";
	const trace = readTrace(columns);
	if (trace) plant.trace = trace;
	if (columns.has("mesh_fingerprint")) plant.meshFingerprint = hexadecimal(columns.uint32("mesh_fingerprint"));
	return plant;
}

/** Reads the segments: `ends` has 6 values each (start, end), `radii` 2. */
function readSegments(columns: Columns): Segments {
	const parent = columns.ints("segments.parent");
	return {
		count: parent.length,
		parent,
		tag: columns.uint32("segments.tag"),
		tags: columns.lines("segments.tags"),
		ends: columns.floats("segments.ends"),
		radii: columns.floats("segments.radii"),
	};
}

/** Reads the organs: attached shapes, each with its mesh and its place. */
function readOrgans(columns: Columns): Organs {
	if (!columns.has("organs.tag")) return EMPTY_PLANT.organs;
	const tag = columns.uint32("organs.tag");
	return {
		count: tag.length,
		tag,
		tags: columns.lines("organs.tags"),
		segment: columns.ints("organs.segment"),
		mesh: columns.ints("organs.mesh"),
		transforms: columns.floats("organs.transforms"),
		...readSky(columns, "organs."),
	};
}

/** Reads a mesh with its material and its runs of triangles. */
function readPlantMesh(columns: Columns, name: string): PlantMesh {
	const prefix = `mesh.${name}.`;
	const mesh = readMesh(columns, prefix);
	return {
		name,
		material: columns.text(`${prefix}material`),
		...mesh,
		runs: readRuns(columns, prefix),
		...readSky(columns, prefix),
	};
}

/** Reads the column `sky` of a mesh; nothing where it was not requested. */
export function readSky(columns: Columns, prefix: string): { sky?: Uint8Array } {
	const name = `${prefix}sky`;
	return columns.has(name) ? { sky: columns.uint8(name) } : {};
}

/** Reads the arrays of a mesh whose columns begin with `prefix`. */
export function readMesh(columns: Columns, prefix: string): Mesh {
	return {
		positions: columns.floats(`${prefix}positions`),
		normals: columns.floats(`${prefix}normals`),
		uvs: columns.floats(`${prefix}uvs`),
		indices: columns.uint32(`${prefix}indices`),
	};
}

/** Reads the named runs of a mesh whose columns begin with `prefix`. */
function readRuns(columns: Columns, prefix: string): MeshRun[] {
	const names = columns.lines(`${prefix}runs.names`);
	const ranges = names.length > 0 ? columns.uint32(`${prefix}runs`) : new Uint32Array(0);
	return names.map((name, index) => {
		const [firstVertex, vertexCount, firstIndex, indexCount] = ranges.subarray(4 * index, 4 * index + 4);
		return { name, firstVertex, vertexCount, firstIndex, indexCount };
	});
}

/** Formats a 64-bit number, given as its low and high half, as 16 hexadecimal digits. */
function hexadecimal([low, high]: Uint32Array): string {
	return [high, low].map((word) => word.toString(16).padStart(8, "0")).join("");
}
