/** Subdivides the ground's mesh, so that mottles are visible on a small bed too. Pure. */
import type { PartMesh } from "../../plant/part";
import { type GroundGrid, gridOf, interpolate } from "./ground_grid";

/** Least number of cells along a side. */
const LEAST_CELLS = 28;

/** A ground's mesh with the size of its grid. */
export interface Ground {
	readonly mesh: PartMesh;
	readonly grid: GroundGrid;
}

/** Returns the number of cells along a side after subdivision: a multiple of those of the core's mesh. */
const subdividedCells = (cells: number): number => cells * Math.ceil(LEAST_CELLS / cells);

/**
 * Returns the ground with every cell of the core's grid divided into equal cells, at least `LEAST_CELLS` along each
 * side; all values of the vertices are interpolated.
 * @param mesh the mesh from the core
 */
export function finerGround(mesh: PartMesh): Ground {
	const coarse = gridOf(mesh);
	const grid = { across: subdividedCells(coarse.across), deep: subdividedCells(coarse.deep) };
	const [positions, normals, uvs, sky, indices]: number[][] = [[], [], [], [], []];
	for (let row = 0; row <= grid.deep; row++)
		for (let column = 0; column <= grid.across; column++) {
			// Position in the coarse grid, in cells, and the values of a vertex interpolated there.
			const [u, v] = [(column * coarse.across) / grid.across, (row * coarse.deep) / grid.deep];
			const interpolated = (values: ArrayLike<number>, width: number) =>
				Array.from({ length: width }, (_, component) => interpolate(coarse, values, [width, component], u, v));
			const position = interpolated(mesh.positions, 3);
			const normal = interpolated(mesh.normals, 3);
			const length = Math.hypot(...normal) || 1;
			positions.push(...position);
			normals.push(...normal.map((value) => value / length));
			uvs.push(position[0], position[2]);
			sky.push(mesh.sky ? Math.round(interpolated(mesh.sky, 1)[0]) : 255);
			if (row === grid.deep || column === grid.across) continue;
			const corner = (grid.across + 1) * row + column;
			const below = corner + grid.across + 1;
			indices.push(corner, below, corner + 1, corner + 1, below, below + 1);
		}
	const finerMesh = {
		positions: Float32Array.from(positions),
		normals: Float32Array.from(normals),
		uvs: Float32Array.from(uvs),
		indices: Uint32Array.from(indices),
		sky: Uint8Array.from(sky),
	};
	return { mesh: finerMesh, grid };
}
