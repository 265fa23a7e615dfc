/** Wavefront OBJ: reads positions and faces; other statements do not matter for a boundary. */
import { text } from "../messages.generated";
import { bounded, boundedPoints, MeshFileError, type Soup } from "./soup";
import { linesOf, wordsOf } from "./text_lines";

/**
 * Reads an OBJ file; polygons become triangle fans.
 * @throws MeshFileError with the number of the unreadable line
 */
export function readObj(text: string): Soup {
	const soup: Soup = { points: [], triangles: [] };
	let number = 0;
	for (const line of linesOf(text)) {
		const words = wordsOf(line);
		const kind = words.next().value;
		if (kind === "v") addPoint(soup, words, number);
		if (kind === "f") addFace(soup, words, number);
		number++;
	}
	return soup;
}

/**
 * Adds the point of a line `v x y z`; further numbers, a weight or a colour, are ignored.
 * @param line line number from 0, for messages
 */
function addPoint({ points }: Soup, words: Iterator<string>, line: number): void {
	boundedPoints(points.length / 3 + 1);
	for (let k = 0; k < 3; k++) {
		const { done, value } = words.next();
		if (done) throw new MeshFileError(text.message("obj_point_incomplete", { line: line + 1 }));
		points.push(coordinate(value, line));
	}
}

/**
 * Adds a face as a fan of triangles about its first corner; indices may be relative to the points so far.
 * @param line line number from 0, for messages
 */
function addFace({ points, triangles }: Soup, words: Iterable<string>, line: number): void {
	let [first, last, corners] = [0, 0, 0];
	for (const word of words) {
		const next = corner(word, points.length / 3, line);
		if (corners === 0) first = next;
		if (corners > 1) {
			bounded(triangles.length / 3 + 1);
			triangles.push(first, last, next);
		}
		last = next;
		corners++;
	}
	if (corners < 3) throw new MeshFileError(text.message("obj_face_incomplete", { line: line + 1 }));
}

/** Reads a number. @param line line number from 0, for the MeshFileError of a word that is none */
function coordinate(word: string, line: number): number {
	const value = Number(word);
	if (Number.isFinite(value)) return value;
	throw new MeshFileError(text.message("obj_not_a_number", { line: line + 1, word: word.slice(0, 32) }));
}

/**
 * Reads a corner of a face, `7`, `-1` or `7/2/3`: the index of its point, from 0. The file counts from 1, or backwards
 * from the last point so far; texture and normal indices after a slash are ignored.
 * @param count number of points so far
 * @param line line number from 0, for messages
 */
function corner(word: string, count: number, line: number): number {
	const index = Number.parseInt(word, 10);
	const place = index < 0 ? count + index : index - 1;
	if (place >= 0 && place < count) return place;
	throw new MeshFileError(text.message("obj_unknown_point", { line: line + 1, word: word.slice(0, 32) }));
}
