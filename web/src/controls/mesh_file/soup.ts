/** Triangles as a file holds them, before anything is known of how they hang together. */
export interface Soup {
	/** 3 × points. */
	points: number[];
	/** 3 × triangles. */
	triangles: number[];
}

/** Triangles that are welded and simplified at most: more would hold the page for long. */
const MOST_READ = 500_000;

/** A file that holds no mesh that can be a boundary; the message says why, and what to do. */
export class MeshFileError extends Error {
	override name = "MeshFileError";
}

/** For readers, before they take in so many triangles. @throws MeshFileError where that is more than is read */
export function bounded(triangles: number): void {
	if (triangles <= MOST_READ) return;
	throw new MeshFileError(`The mesh has more than ${MOST_READ.toLocaleString("en")} triangles: simplify it first.`);
}
