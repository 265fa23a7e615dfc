/** Triangles of a file, without connectivity. */
export interface Soup {
	/** 3 × points. */
	points: number[];
	/** 3 × triangles. */
	triangles: number[];
}

/** Largest number of triangles that are welded and simplified, and largest number of their points. */
const MOST_READ = 500_000;
const MOST_POINTS = 3 * MOST_READ;

/** Error: the file holds no mesh that can be a boundary; the message gives the reason and the remedy. */
export class MeshFileError extends Error {
	override name = "MeshFileError";
}

/**
 * Checks a number of triangles before reading them.
 * @throws MeshFileError if there are too many
 */
export function bounded(triangles: number): void {
	if (triangles > MOST_READ) throw tooMany(MOST_READ, "triangles");
}

/**
 * Checks a number of points before reading them.
 * @throws MeshFileError if there are too many
 */
export function boundedPoints(points: number): void {
	if (points > MOST_POINTS) throw tooMany(MOST_POINTS, "points");
}

function tooMany(most: number, what: string): MeshFileError {
	return new MeshFileError(`The mesh has more than ${most.toLocaleString("en")} ${what}: simplify it first.`);
}
