/** Wavefront OBJ: positions and faces; the rest of the format says nothing of a boundary. */
import { bounded, MeshFileError, type Soup } from "./soup";

/** Polygons become fans. @throws MeshFileError with the line that cannot be read */
export function readObj(text: string): Soup {
	const points: number[] = [];
	const triangles: number[] = [];
	for (const [number, line] of text.split("\n").entries()) {
		const [kind, ...words] = line.trim().split(/\s+/);
		if (kind === "v")
			points.push(...words.slice(0, 3).map((word) => coordinate(word, number)), ...missing(words, number));
		if (kind === "f") {
			const corners = words.map((word) => corner(word, points.length / 3, number));
			if (corners.length < 3) throw wrong(number, "a face of fewer than three corners");
			bounded(triangles.length / 3 + corners.length - 2);
			for (let i = 2; i < corners.length; i++) triangles.push(corners[0], corners[i - 1], corners[i]);
		}
	}
	return { points, triangles };
}

function coordinate(word: string, line: number): number {
	const value = Number(word);
	if (Number.isFinite(value)) return value;
	throw wrong(line, `“${word.slice(0, 32)}”, which is no number`);
}

function missing(words: readonly string[], line: number): [] {
	if (words.length >= 3) return [];
	throw wrong(line, "a point of fewer than three numbers");
}

/** Counted from 1, or back from the last point so far; what follows a slash are textures and normals. */
function corner(word: string, count: number, line: number): number {
	const index = Number.parseInt(word, 10);
	const place = index < 0 ? count + index : index - 1;
	if (place >= 0 && place < count) return place;
	throw wrong(line, `a corner, “${word.slice(0, 32)}”, that is none of the points before it`);
}

function wrong(line: number, what: string): MeshFileError {
	return new MeshFileError(`Line ${line + 1} of the OBJ has ${what}.`);
}
