/** A result's sections → Grown (layout: boundary/panicle.h). */
import { CORE_REASONS, CoreError } from "../../core/errors";
import { SECTION } from "../../core/exports";
import {
	type Berries,
	type BerrySurfaces,
	type Counts,
	FOLIAGE_KINDS,
	type Foliage,
	type FoliagePart,
	FRUITS,
	type Grown,
	type Internodes,
	type Mesh,
	type Plan,
	type PlanSide,
	PROCEDURES,
	type StemMesh,
	type StemPart,
	THINNED_WHY,
	type Thinned,
} from "./grown";
import type { Sections } from "../../core/sections";

/**
 * @param grow milliseconds that the growth took
 * @throws CoreError where the core gave a reason in place of a bunch
 */
export function readGrown(sections: Sections, grow: number): Grown {
	const [reason, line, column] = sections.words(SECTION.status);
	if (reason !== 0) {
		throw new CoreError(CORE_REASONS[reason] ?? "bad request", sections.text(SECTION.message), line, column);
	}
	const prints = sections.words(SECTION.fingerprints);
	const [procedure, fruit] = sections.words(SECTION.procedure);
	const [, , taper, blunt] = sections.floats(SECTION.procedure);
	const grown: Grown = {
		procedure: PROCEDURES[procedure],
		form: { fruit: FRUITS[fruit], taper, blunt },
		plan: readPlan(sections, SECTION.plan),
		counts: readCounts(sections.words(SECTION.counts)),
		internodes: readInternodes(sections),
		berries: readBerries(sections),
		thinned: readThinned(sections),
		notes: sections.text(SECTION.notes).split("\n").filter(Boolean),
		fingerprint: hexadecimal(prints[0], prints[1]),
		timings: { grow },
	};
	if (!sections.isEmpty(SECTION.second)) grown.second = readPlan(sections, SECTION.second);
	if (!sections.isEmpty(SECTION.measures)) grown.measures = sections.floats(SECTION.measures);
	if (!sections.isEmpty(SECTION.surfacePositions)) grown.surfaces = readSurfaces(sections);
	if (!sections.isEmpty(SECTION.flowerPositions)) grown.flower = readMesh(sections, SECTION.flowerPositions);
	if (!sections.isEmpty(SECTION.foliagePositions)) grown.foliage = readFoliage(sections);
	if (!sections.isEmpty(SECTION.berryPositions)) grown.berry = readMesh(sections, SECTION.berryPositions);
	if (grown.berry || grown.surfaces || !sections.isEmpty(SECTION.stemPositions)) {
		grown.stem = readStem(sections);
		grown.meshFingerprint = hexadecimal(prints[2], prints[3]);
	}
	return grown;
}

/** Buffers of a grown bunch, for handing it to another thread without copying. */
export function buffersOf(grown: Grown): ArrayBuffer[] {
	const { internodes, berries, stem, berry, surfaces, flower, foliage, measures } = grown;
	const holders: object[] = [internodes, berries, stem ?? {}, berry ?? {}, surfaces ?? {}, flower ?? {}, foliage ?? {}];
	const values = holders.flatMap((holder) => Object.values(holder));
	return [...values, measures].flatMap((value) => (ArrayBuffer.isView(value) ? [value.buffer as ArrayBuffer] : []));
}

const WORDS_PER_SIDE = 4;

function readPlan(sections: Sections, section: number): Plan {
	const ints = sections.ints(section);
	const floats = new Float32Array(ints.buffer);
	const side = (index: number): PlanSide => {
		const at = index * WORDS_PER_SIDE;
		return { w: floats[at], r: floats[at + 1], n: ints[at + 2], rd: ints[at + 3] };
	};
	const m = 4 * WORDS_PER_SIDE;
	return { m: ints[m], sides: [side(0), side(1), side(2), side(3)], axes: Array.from(ints.subarray(m + 1)) };
}

function readCounts([endStructures, internodes, pedicels, berries, withered, cut]: Uint32Array): Counts {
	return { endStructures, internodes, pedicels, berries, withered, cut };
}

function readInternodes(sections: Sections): Internodes {
	const rows = sections.ints(SECTION.internodes);
	const count = rows.length / 4;
	const column = (index: number) => Int32Array.from({ length: count }, (_, row) => rows[4 * row + index]);
	return {
		count,
		parent: column(0),
		kind: Uint8Array.from(column(1)),
		axis: column(2),
		state: Uint8Array.from(column(3)),
		ends: sections.floats(SECTION.internodeEnds),
		radii: sections.floats(SECTION.internodeRadii),
	};
}

function readBerries(sections: Sections): Berries {
	const spheres = sections.floats(SECTION.berries);
	return {
		count: spheres.length / 4,
		spheres,
		directions: sections.floats(SECTION.berryDirections),
		parent: sections.ints(SECTION.berryParents),
		ids: sections.words(SECTION.berryIds),
		traits: sections.floats(SECTION.berryTraits),
	};
}

const WORDS_PER_THINNED = 5;

function readThinned(sections: Sections): Thinned[] {
	const words = sections.words(SECTION.thinned);
	const floats = new Float32Array(words.buffer);
	return Array.from({ length: words.length / WORDS_PER_THINNED }, (_, index) => {
		const at = index * WORDS_PER_THINNED;
		return {
			id: words[at],
			why: THINNED_WHY[words[at + 1]],
			place: [floats[at + 2], floats[at + 3], floats[at + 4]],
		};
	});
}

function readSurfaces(sections: Sections): BerrySurfaces {
	return {
		uvs: sections.floats(SECTION.surfaceUvs),
		indices: sections.words(SECTION.surfaceIndices),
		positions: sections.floats(SECTION.surfacePositions),
		normals: sections.floats(SECTION.surfaceNormals),
		pressed: sections.bytes(SECTION.surfacePressed),
	};
}

function readFoliage(sections: Sections): Foliage {
	const rows = sections.words(SECTION.foliageParts);
	const parts: FoliagePart[] = [];
	for (let at = 0; at < rows.length; at += WORDS_PER_PART) {
		const [kind, firstVertex, vertexCount, firstIndex, indexCount] = rows.subarray(at, at + WORDS_PER_PART);
		parts.push({ kind: FOLIAGE_KINDS[kind], firstVertex, vertexCount, firstIndex, indexCount });
	}
	return { ...readMesh(sections, SECTION.foliagePositions), parts };
}

/** Positions, normals, texture coordinates and indices stand in four sections in a row. */
function readMesh(sections: Sections, first: number): Mesh {
	return {
		positions: sections.floats(first),
		normals: sections.floats(first + 1),
		uvs: sections.floats(first + 2),
		indices: sections.words(first + 3),
	};
}

const WORDS_PER_PART = 5;

function readStem(sections: Sections): StemMesh {
	const rows = sections.ints(SECTION.stemParts);
	const parts: StemPart[] = [];
	for (let at = 0; at < rows.length; at += WORDS_PER_PART) {
		const [axis, firstVertex, vertexCount, firstIndex, indexCount] = rows.subarray(at, at + WORDS_PER_PART);
		parts.push({ axis, firstVertex, vertexCount, firstIndex, indexCount });
	}
	return { ...readMesh(sections, SECTION.stemPositions), internode: sections.words(SECTION.stemInternodes), parts };
}

function hexadecimal(low: number, high: number): string {
	return [high, low].map((word) => word.toString(16).padStart(8, "0")).join("");
}
