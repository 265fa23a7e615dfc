import { MessageError } from "../../locale/message_error";
import { text } from "../messages.generated";

/** Triangles of a file, without connectivity. */
export interface Soup {
	/** 3 × points. */
	points: number[];
	/** 3 × triangles. */
	triangles: number[];
}

/** Largest number of triangles that are welded and simplified, and largest number of their points. */
const MAX_TRIANGLES_READ = 500_000;
const MAX_POINTS = 3 * MAX_TRIANGLES_READ;

/** Error: the file holds no mesh that can be a boundary; the message gives the reason and the remedy. */
export class MeshFileError extends MessageError {
	override name = "MeshFileError";
}

/**
 * Checks a number of triangles before reading them.
 * @throws MeshFileError if there are too many
 */
export function bounded(triangles: number): void {
	if (triangles > MAX_TRIANGLES_READ)
		throw new MeshFileError(text.message("mesh_too_many_triangles", { most: MAX_TRIANGLES_READ }));
}

/**
 * Checks a number of points before reading them.
 * @throws MeshFileError if there are too many
 */
export function boundedPoints(points: number): void {
	if (points > MAX_POINTS) throw new MeshFileError(text.message("mesh_too_many_points", { most: MAX_POINTS }));
}
