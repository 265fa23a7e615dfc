/** A result's sections → Grown (layout: wasm_api/panicle.h). */
import { CORE_REASONS, CoreError } from "./errors";
import { SECTION } from "./exports";
import type { Berries, Counts, Grown, Internodes, Mesh, Plan, PlanSide, StemMesh, StemPart } from "./grown";
import type { Sections } from "./sections";

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
	const grown: Grown = {
		plan: readPlan(sections, SECTION.plan),
		counts: readCounts(sections.words(SECTION.counts)),
		internodes: readInternodes(sections),
		berries: readBerries(sections),
		notes: sections.text(SECTION.notes).split("\n").filter(Boolean),
		fingerprint: hexadecimal(prints[0], prints[1]),
		timings: { grow },
	};
	if (!sections.isEmpty(SECTION.second)) grown.second = readPlan(sections, SECTION.second);
	if (!sections.isEmpty(SECTION.berryPositions)) {
		grown.stem = readStem(sections);
		grown.berry = readMesh(sections, SECTION.berryPositions);
		grown.meshFingerprint = hexadecimal(prints[2], prints[3]);
	}
	return grown;
}

/** Buffers of a grown bunch, for handing it to another thread without copying. */
export function buffersOf(grown: Grown): ArrayBuffer[] {
	const holders: object[] = [grown.internodes, grown.berries, grown.stem ?? {}, grown.berry ?? {}];
	return holders.flatMap((holder) =>
		Object.values(holder).flatMap((value) => (ArrayBuffer.isView(value) ? [value.buffer as ArrayBuffer] : [])),
	);
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
	};
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
