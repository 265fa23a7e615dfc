/**
 * Reads STL files, binary or text. Printers have +Z up, as do Panicle's own prints, so meshes are rotated to +Y up.
 * Normals and colours are ignored.
 */
import { text } from "../messages.generated";
import { bounded, MeshFileError, type Soup } from "./soup";
import { linesOf, wordsOf } from "./text_lines";

const HEADER = 80;
const TRIANGLE = 50;

/**
 * Reads an STL file, binary or text.
 * @throws MeshFileError with the unreadable part
 */
export function readStl(bytes: ArrayBuffer): Soup {
	const count = bytes.byteLength < HEADER + 4 ? 0 : new DataView(bytes).getUint32(HEADER, true);
	// Some programs begin binary files with “solid”, too, and pad them at the end. Text read as a count gives more
	// triangles than any file has.
	if (count > 0 && bytes.byteLength >= HEADER + 4 + TRIANGLE * count) return readBinary(new DataView(bytes), count);
	const file = new TextDecoder().decode(bytes);
	if (/^\s*solid\b/i.test(file) && /\bfacet\b/i.test(file)) return readText(file);
	throw new MeshFileError(text.message("stl_damaged"));
}

/**
 * Reads a binary file's triangles, each with points of its own.
 * @param count number of triangles that the header states
 * @throws MeshFileError if a coordinate is not finite, or there are too many triangles
 */
function readBinary(view: DataView, count: number): Soup {
	bounded(count);
	const points: number[] = [];
	for (let triangle = 0; triangle < count; triangle++) {
		// Three corners follow the normal.
		for (let corner = 1; corner <= 3; corner++) {
			const at = HEADER + 4 + TRIANGLE * triangle + 12 * corner;
			const [x, y, z] = [view.getFloat32(at, true), view.getFloat32(at + 4, true), view.getFloat32(at + 8, true)];
			if (!Number.isFinite(x + y + z))
				throw new MeshFileError(text.message("stl_corner_invalid", { triangle: triangle + 1 }));
			addRotated(points, x, y, z);
		}
	}
	return unindexedSoup(points);
}

/** Reads the corners of a text STL. Throws if a facet has not three corners. */
function readText(file: string): Soup {
	const points: number[] = [];
	let number = 0;
	for (const line of linesOf(file)) {
		const words = wordsOf(line);
		const kind = words.next().value?.toLowerCase();
		const corners = points.length / 3;
		if (kind === "endfacet" && corners % 3 !== 0)
			throw new MeshFileError(text.message("stl_facet_incomplete", { line: number + 1 }));
		if (kind === "vertex") {
			bounded((corners + 1) / 3);
			addCorner(points, words, number);
		}
		number++;
	}
	if (points.length === 0 || points.length % 9 !== 0) throw new MeshFileError(text.message("stl_damaged"));
	return unindexedSoup(points);
}

/**
 * Adds the corner of a line `vertex x y z`.
 * @param words the words after `vertex`
 * @param line line number from 0, for messages
 */
function addCorner(points: number[], words: Iterator<string>, line: number): void {
	const [x, y, z] = [words.next(), words.next(), words.next()].map(({ done, value }) => (done ? NaN : Number(value)));
	if (!Number.isFinite(x + y + z) || !words.next().done)
		throw new MeshFileError(text.message("stl_corner_not_numbers", { line: line + 1 }));
	addRotated(points, x, y, z);
}

/** Adds a point, converted from +Z up to +Y up. */
function addRotated(points: number[], x: number, y: number, z: number): void {
	points.push(x, z, -y);
}

/** Returns triangles of which each has corners of its own: nine numbers per triangle. */
const unindexedSoup = (points: number[]): Soup => ({
	points,
	triangles: Array.from({ length: points.length / 3 }, (_, corner) => corner),
});
