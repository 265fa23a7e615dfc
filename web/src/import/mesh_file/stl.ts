/**
 * Reads STL files, binary or text. Printers have +Z up, as do Panicle's own prints, so meshes are rotated to +Y up.
 * Normals and colours are ignored.
 */
import { bounded, MeshFileError, type Soup } from "./soup";
import { linesOf, wordsOf } from "./text_lines";

const HEADER = 80;
const TRIANGLE = 50;

/** @throws MeshFileError with the unreadable part */
export function readStl(bytes: ArrayBuffer): Soup {
	const count = bytes.byteLength < HEADER + 4 ? 0 : new DataView(bytes).getUint32(HEADER, true);
	// Some programs begin binary files with “solid”, too, and pad them at the end. Text read as a count gives more
	// triangles than any file has.
	if (count > 0 && bytes.byteLength >= HEADER + 4 + TRIANGLE * count) return readBinary(new DataView(bytes), count);
	const text = new TextDecoder().decode(bytes);
	if (/^\s*solid\b/i.test(text) && /\bfacet\b/i.test(text)) return readText(text);
	throw new MeshFileError("The STL is damaged or unfinished: export it again.");
}

function readBinary(view: DataView, count: number): Soup {
	bounded(count);
	const points: number[] = [];
	for (let triangle = 0; triangle < count; triangle++) {
		// Three corners follow the normal.
		for (let corner = 1; corner <= 3; corner++) {
			const at = HEADER + 4 + TRIANGLE * triangle + 12 * corner;
			const [x, y, z] = [view.getFloat32(at, true), view.getFloat32(at + 4, true), view.getFloat32(at + 8, true)];
			if (!Number.isFinite(x + y + z))
				throw new MeshFileError(`Triangle ${triangle + 1} of the STL has a corner that is no place.`);
			stand(points, x, y, z);
		}
	}
	return asItStands(points);
}

function readText(text: string): Soup {
	const points: number[] = [];
	let number = 0;
	for (const line of linesOf(text)) {
		const words = wordsOf(line);
		const kind = words.next().value?.toLowerCase();
		const corners = points.length / 3;
		if (kind === "endfacet" && corners % 3 !== 0) throw wrong(number, "the end of a facet that has not three corners");
		if (kind === "vertex") {
			bounded((corners + 1) / 3);
			addCorner(points, words, number);
		}
		number++;
	}
	if (points.length === 0 || points.length % 9 !== 0)
		throw new MeshFileError("The STL is damaged or unfinished: export it again.");
	return asItStands(points);
}

function addCorner(points: number[], words: Iterator<string>, line: number): void {
	const [x, y, z] = [words.next(), words.next(), words.next()].map(({ done, value }) => (done ? NaN : Number(value)));
	if (!Number.isFinite(x + y + z) || !words.next().done) throw wrong(line, "a corner that is not three numbers");
	stand(points, x, y, z);
}

/** Converts +Z up to +Y up. */
function stand(points: number[], x: number, y: number, z: number): void {
	points.push(x, z, -y);
}

/** Every triangle has corners of its own. */
const asItStands = (points: number[]): Soup => ({
	points,
	triangles: Array.from({ length: points.length / 3 }, (_, corner) => corner),
});

function wrong(line: number, what: string): MeshFileError {
	return new MeshFileError(`Line ${line + 1} of the STL has ${what}.`);
}
