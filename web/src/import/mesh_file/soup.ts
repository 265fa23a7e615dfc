/** Triangles as a file holds them, before anything is known of how they hang together. */
export interface Soup {
	/** 3 × points. */
	points: number[];
	/** 3 × triangles. */
	triangles: number[];
}

/** Triangles that are welded and simplified at most, and points: as many as those triangles can have. */
const MOST_READ = 500_000;
const MOST_POINTS = 3 * MOST_READ;

/** Error: the file holds no mesh that can be a boundary; the message gives the reason and the remedy. */
export class MeshFileError extends Error {
	override name = "MeshFileError";
}

/** For readers, before they take in so many triangles. @throws MeshFileError where that is more than is read */
export function bounded(triangles: number): void {
	if (triangles > MOST_READ) throw tooMany(MOST_READ, "triangles");
}

/** For readers, before they take in so many points. @throws MeshFileError where that is more than is read */
export function boundedPoints(points: number): void {
	if (points > MOST_POINTS) throw tooMany(MOST_POINTS, "points");
}

function tooMany(most: number, what: string): MeshFileError {
	return new MeshFileError(`The mesh has more than ${most.toLocaleString("en")} ${what}: simplify it first.`);
}
