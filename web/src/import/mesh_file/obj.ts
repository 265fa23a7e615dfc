/** Wavefront OBJ: reads positions and faces; other statements do not matter for a boundary. */
import { bounded, boundedPoints, MeshFileError, type Soup } from "./soup";
import { linesOf, wordsOf } from "./text_lines";

/**
 * Polygons become triangle fans.
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

/** Numbers after the third are a weight or a colour. */
function addPoint({ points }: Soup, words: Iterator<string>, line: number): void {
	boundedPoints(points.length / 3 + 1);
	for (let k = 0; k < 3; k++) {
		const { done, value } = words.next();
		if (done) throw wrong(line, "a point of fewer than three numbers");
		points.push(coordinate(value, line));
	}
}

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
	if (corners < 3) throw wrong(line, "a face of fewer than three corners");
}

function coordinate(word: string, line: number): number {
	const value = Number(word);
	if (Number.isFinite(value)) return value;
	throw wrong(line, `“${word.slice(0, 32)}”, which is no number`);
}

/**
 * Index counted from 1, or backwards from the last point so far; texture and normal indices after a slash are ignored.
 */
function corner(word: string, count: number, line: number): number {
	const index = Number.parseInt(word, 10);
	const place = index < 0 ? count + index : index - 1;
	if (place >= 0 && place < count) return place;
	throw wrong(line, `a corner, “${word.slice(0, 32)}”, that is none of the points before it`);
}

function wrong(line: number, what: string): MeshFileError {
	return new MeshFileError(`Line ${line + 1} of the OBJ has ${what}.`);
}
