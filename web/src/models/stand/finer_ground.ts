/** Subdivides the ground's mesh, so that mottles are visible on a small bed too. Pure. */
import type { PartMesh } from "../../plant/part";
import { between, type GroundGrid, gridOf } from "./ground_grid";

/** Least number of cells along a side. */
const FEWEST = 28;

/** A ground's mesh with the size of its grid. */
export interface Ground {
	readonly mesh: PartMesh;
	readonly grid: GroundGrid;
}

const finely = (cells: number): number => cells * Math.ceil(FEWEST / cells);

/** @param mesh the mesh from the core */
export function finerGround(mesh: PartMesh): Ground {
	const coarse = gridOf(mesh);
	const grid = { across: finely(coarse.across), deep: finely(coarse.deep) };
	const [positions, normals, uvs, sky, indices]: number[][] = [[], [], [], [], []];
	for (let row = 0; row <= grid.deep; row++)
		for (let column = 0; column <= grid.across; column++) {
			const [u, v] = [(column * coarse.across) / grid.across, (row * coarse.deep) / grid.deep];
			const all = (of: ArrayLike<number>, parts: number) =>
				Array.from({ length: parts }, (_, part) => between(coarse, of, [parts, part], u, v));
			const place = all(mesh.positions, 3);
			const way = all(mesh.normals, 3);
			const length = Math.hypot(...way) || 1;
			positions.push(...place);
			normals.push(...way.map((value) => value / length));
			uvs.push(place[0], place[2]);
			sky.push(mesh.sky ? Math.round(all(mesh.sky, 1)[0]) : 255);
			if (row === grid.deep || column === grid.across) continue;
			const corner = (grid.across + 1) * row + column;
			const below = corner + grid.across + 1;
			indices.push(corner, below, corner + 1, corner + 1, below, below + 1);
		}
	const made = {
		positions: Float32Array.from(positions),
		normals: Float32Array.from(normals),
		uvs: Float32Array.from(uvs),
		indices: Uint32Array.from(indices),
		sky: Uint8Array.from(sky),
	};
	return { mesh: made, grid };
}
