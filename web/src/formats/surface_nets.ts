/**
 * The surface of voxels as one closed mesh (Gibson 1998, "Constrained elastic surface nets"): a vertex in each cube of
 * eight neighbours that are not all equal, smoothed, at most a quarter of a cell from the cube's middle along each
 * axis.
 */
import type { Voxels } from "./voxels";

/** Rounds of smoothing. */
const ROUNDS = 8;
/** Greatest movement of a vertex from its cube's middle, in cells. */
const REACH = 0.25;

export interface Surface {
	/** 3 × vertices. */
	positions: Float32Array;
	/** 3 × triangles, counter-clockwise seen from outside. */
	indices: Uint32Array;
}

/**
 * Builds the closed surface between filled and empty cells.
 * @param voxels without pinches (voxels.ts), the outermost layer empty
 */
export function surfaceOf({ size: [nx, ny, nz], origin, pitch, cells }: Voxels): Surface {
	const middles: number[] = [];
	const quads: number[] = [];
	const plane = nx * ny;
	/** Vertices by cube, of this layer of cubes and of the one below. */
	let [below, here] = [new Int32Array(plane), new Int32Array(plane)];
	const addQuad = (facesUp: boolean, a: number, b: number, c: number, d: number) => {
		if (facesUp) quads.push(a, b, c, d);
		else quads.push(d, c, b, a);
	};
	for (let z = 0; z + 1 < nz; z++) {
		for (let y = 0; y + 1 < ny; y++) {
			for (let x = 0; x + 1 < nx; x++) {
				const at = z * plane + y * nx + x;
				const sum =
					cells[at] +
					cells[at + 1] +
					cells[at + nx] +
					cells[at + nx + 1] +
					cells[at + plane] +
					cells[at + plane + 1] +
					cells[at + plane + nx] +
					cells[at + plane + nx + 1];
				if (sum === 0 || sum === 8) continue;
				const cube = y * nx + x;
				here[cube] = middles.length / 3;
				middles.push(x + 1, y + 1, z + 1);
				// A face for each of the cube's first edges that crosses the surface.
				const filled = cells[at] === 1;
				if (filled !== (cells[at + 1] === 1))
					addQuad(filled, below[cube - nx], below[cube], here[cube], here[cube - nx]);
				if (filled !== (cells[at + nx] === 1))
					addQuad(filled, below[cube - 1], here[cube - 1], here[cube], below[cube]);
				if (filled !== (cells[at + plane] === 1))
					addQuad(filled, here[cube - nx - 1], here[cube - nx], here[cube], here[cube - 1]);
			}
		}
		[below, here] = [here, below];
	}
	const positions = relax(Float32Array.from(middles), Uint32Array.from(quads));
	return { positions: positions.map((value, i) => origin[i % 3] + pitch * value), indices: trianglesOf(quads) };
}

/** Moves every vertex towards the mean of its neighbours, at most `REACH` from its cube's middle along each axis. */
function relax(middles: Float32Array, quads: Uint32Array): Float32Array {
	const positions = middles.slice();
	const [sums, counts] = [new Float32Array(positions.length), new Uint8Array(positions.length / 3)];
	for (let round = 0; round < ROUNDS; round++) {
		sums.fill(0);
		counts.fill(0);
		for (let at = 0; at < quads.length; at++) {
			const [from, to] = [quads[at], quads[at % 4 === 3 ? at - 3 : at + 1]];
			for (let k = 0; k < 3; k++) sums[3 * from + k] += positions[3 * to + k];
			counts[from]++;
		}
		for (let i = 0; i < positions.length; i++) {
			const count = counts[Math.floor(i / 3)];
			if (count > 0) positions[i] = Math.max(middles[i] - REACH, Math.min(middles[i] + REACH, sums[i] / count));
		}
	}
	return positions;
}

/** Splits each quad into two triangles. */
function trianglesOf(quads: readonly number[]): Uint32Array {
	const indices = new Uint32Array(1.5 * quads.length);
	for (let from = 0, to = 0; from < quads.length; from += 4, to += 6) {
		const [a, b, c, d] = [quads[from], quads[from + 1], quads[from + 2], quads[from + 3]];
		indices.set([a, b, c, a, c, d], to);
	}
	return indices;
}
