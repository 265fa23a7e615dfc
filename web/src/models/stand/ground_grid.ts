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

/** Finds the number of cells of the grid along each side: the first row ends where z changes. */
export function gridOf({ positions }: Pick<PartMesh, "positions">): GroundGrid {
	let row = 1;
	while (3 * row + 2 < positions.length && positions[3 * row + 2] === positions[2]) row++;
	return { across: row - 1, deep: positions.length / 3 / row - 1 };
}

/**
 * Interpolates one component of a grid's values bilinearly.
 * @param values `width` numbers for each vertex
 * @param [width, component] numbers for each vertex, and index of the one to interpolate
 * @param u cells from the left
 * @param v cells from the back
 */
export function interpolate(
	{ across, deep }: GroundGrid,
	values: ArrayLike<number>,
	[width, component]: readonly [width: number, component: number],
	u: number,
	v: number,
): number {
	const [i, j] = [Math.min(across - 1, Math.floor(u)), Math.min(deep - 1, Math.floor(v))];
	const at = (x: number, y: number) => values[width * ((across + 1) * (j + y) + i + x) + component];
	const back = at(0, 0) + (u - i) * (at(1, 0) - at(0, 0));
	const front = at(0, 1) + (u - i) * (at(1, 1) - at(0, 1));
	return back + (v - j) * (front - back);
}

/** Returns the height of the ground at a point, metres; beyond the ground, the height at its edge. */
export function heightAt({ ground, meshes }: GroundSurface, x: number, z: number): number {
	const [mesh] = meshes;
	if (!mesh) return 0;
	const grid = gridOf(mesh);
	const cellsAlong = (value: number, size: number, cells: number) => clamp(value / size + 0.5) * cells;
	const [u, v] = [cellsAlong(x, ground.width, grid.across), cellsAlong(z, ground.depth, grid.deep)];
	return interpolate(grid, mesh.positions, [3, 1], u, v);
}
