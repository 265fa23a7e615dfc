/**
 * A closed mesh from a user's file: the boundary of a plant or a part of it. Files hold it; it is too long for a link.
 */
import { text } from "./messages.generated";
import { type Notes, quote } from "./notes";
import { isRecord, readNumbers } from "./read_values";

/** In arbitrary units; models scale it. */
export interface ClosedMesh {
	/** 3 × points. */
	points: number[];
	/** 3 × triangles, counter-clockwise from outside. */
	triangles: number[];
}

/** The largest mesh that import/mesh_file/closed.ts makes. */
export const MAX_TRIANGLES = 4000;

/** Returns whether two meshes are equal, number by number. */
export function sameMesh(one: ClosedMesh, other: ClosedMesh | undefined): boolean {
	const same = (a: number[], b: number[]) => a.length === b.length && a.every((value, i) => value === b[i]);
	return other !== undefined && same(one.points, other.points) && same(one.triangles, other.triangles);
}

/** Reads a closed mesh; notes an invalid one under its key, and leaves it out. */
export function readClosedMesh(key: string, value: unknown, notes: Notes): ClosedMesh | undefined {
	const [points, triangles] = isRecord(value) ? [readNumbers(value.points), readNumbers(value.triangles)] : [];
	const corners = (points?.length ?? 0) / 3;
	const sound =
		points?.every(Number.isFinite) &&
		points.length % 3 === 0 &&
		triangles?.every((index) => Number.isInteger(index) && index >= 0 && index < corners) &&
		triangles.length > 0 &&
		triangles.length % 3 === 0 &&
		triangles.length <= 3 * MAX_TRIANGLES;
	if (sound && points && triangles) return { points, triangles };
	notes.add(key, text.message("mesh_unreadable", { value: quote(value), most: MAX_TRIANGLES }), text("left_out"));
	return undefined;
}
