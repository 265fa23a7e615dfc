/** Triangles as a file holds them, before anything is known of how they hang together. */
export interface Soup {
	/** 3 × points. */
	points: number[];
	/** 3 × triangles. */
	triangles: number[];
}

/** A file that holds no mesh that can be a boundary; the message says why, and what to do. */
export class MeshFileError extends Error {
	override name = "MeshFileError";
}
