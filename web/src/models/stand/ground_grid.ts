/** The core's mesh of the ground: a regular grid, row by row from the back, with interpolation. Pure. */
import { clamp } from "../../plant/colour";
import type { PartMesh } from "../../plant/part";

/** The ground of a stand: its size in metres, and its mesh, which is the first one. */
export interface GroundSurface {
	readonly ground: { readonly width: number; readonly depth: number };
	readonly meshes: readonly Pick<PartMesh, "positions">[];
}

/** Number of cells along each side. */
export interface GroundGrid {
	readonly across: number;
	readonly deep: number;
}

export function gridOf({ positions }: Pick<PartMesh, "positions">): GroundGrid {
	let row = 1;
	while (3 * row + 2 < positions.length && positions[3 * row + 2] === positions[2]) row++;
	return { across: row - 1, deep: positions.length / 3 / row - 1 };
}

/**
 * Interpolates one column of a grid bilinearly.
 * @param of `parts` × vertices
 * @param u cells from the left
 * @param v cells from the back
 */
export function between(
	{ across, deep }: GroundGrid,
	of: ArrayLike<number>,
	[parts, part]: readonly [parts: number, part: number],
	u: number,
	v: number,
): number {
	const [i, j] = [Math.min(across - 1, Math.floor(u)), Math.min(deep - 1, Math.floor(v))];
	const at = (x: number, y: number) => of[parts * ((across + 1) * (j + y) + i + x) + part];
	const near = at(0, 0) + (u - i) * (at(1, 0) - at(0, 0));
	const far = at(0, 1) + (u - i) * (at(1, 1) - at(0, 1));
	return near + (v - j) * (far - near);
}

/** Height of the ground at a point, metres; beyond the ground, the height at its edge. */
export function heightAt({ ground, meshes }: GroundSurface, x: number, z: number): number {
	const [mesh] = meshes;
	if (!mesh) return 0;
	const grid = gridOf(mesh);
	const along = (value: number, size: number, cells: number) => clamp(value / size + 0.5) * cells;
	const [u, v] = [along(x, ground.width, grid.across), along(z, ground.depth, grid.deep)];
	return between(grid, mesh.positions, [3, 1], u, v);
}
