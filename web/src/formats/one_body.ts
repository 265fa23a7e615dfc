/** Makes voxels one solid body: without hollows, and without loose pieces. */
import type { Voxels } from "./voxels";

type Size = Voxels["size"];

/** Fills every empty cell that cannot be reached from outside. */
export function fillHollows({ size, cells }: Voxels): void {
	const outside = new Uint8Array(cells.length);
	// The outermost layer is empty: its first cell reaches all of the outside.
	flood(size, 0, outside, (cell) => cells[cell] === 0);
	for (let cell = 0; cell < cells.length; cell++) if (outside[cell] === 0) cells[cell] = 1;
}

/**
 * Joins pieces to the largest piece: each within `farthest` cells of the joined ones, counted along the axes, by a rod
 * `thick` cells wide. Pieces that are farther away are removed.
 * @returns the number of removed pieces
 */
export function joinPieces({ size, cells }: Voxels, thick: number, farthest: number): number {
	const [nx, ny] = size;
	const steps = [1, -1, nx, -nx, nx * ny, -nx * ny];
	const isFilled = (cell: number) => cells[cell] === 1;
	const largest = largestPiece(size, cells);
	if (largest === undefined) return 0;
	const joined = new Uint8Array(cells.length);
	/** Cells from which the next wave starts. */
	let wave: number[] = [];
	const join = (piece: number) =>
		flood(size, piece, joined, isFilled, (cell) => {
			if (steps.some((step) => cells[cell + step] === 0)) wave.push(cell);
		});
	/**
	 * Fills a cube of `thick` cells, from `cell` in the direction of the axes; the outermost layer of the grid stays
	 * empty.
	 */
	const fillRod = (cell: number) => {
		for (let z = 0; z < thick; z++) {
			for (let y = 0; y < thick; y++) {
				for (let x = 0; x < thick; x++) {
					const each = cell + (z * ny + y) * nx + x;
					if (each < cells.length && !isOutermost(size, each)) cells[each] = 1;
				}
			}
		}
	};
	join(largest);
	// Empty cells that a wave has reached: the number of the step, from 1.
	const reachedBy = new Uint8Array(cells.length);
	for (let far = 0; far <= farthest && wave.length > 0; far++) {
		const from = wave;
		wave = [];
		for (const cell of from) {
			for (const [index, step] of steps.entries()) {
				const to = cell + step;
				if (joined[to] === 1 || reachedBy[to] !== 0 || isOutermost(size, to)) continue;
				if (cells[to] === 0) {
					reachedBy[to] = index + 1;
					wave.push(to);
					continue;
				}
				for (let at = cell; reachedBy[at] !== 0; at -= steps[reachedBy[at] - 1]) fillRod(at);
				join(to);
			}
		}
	}
	// Rods are filled, and belong to the joined piece.
	joined.fill(0);
	flood(size, largest, joined, isFilled);
	let removed = 0;
	for (let cell = 0; cell < cells.length; cell++) {
		if (cells[cell] === 0 || joined[cell] === 1) continue;
		const piece: number[] = [];
		flood(size, cell, joined, isFilled, (each) => piece.push(each));
		for (const each of piece) cells[each] = 0;
		removed++;
	}
	return removed;
}

/** Returns a cell of the piece with the most cells; undefined where no cell is filled. */
function largestPiece(size: Size, cells: Uint8Array): number | undefined {
	const seen = new Uint8Array(cells.length);
	let largest: number | undefined;
	let most = 0;
	for (let cell = 0; cell < cells.length; cell++) {
		if (cells[cell] === 0 || seen[cell] === 1) continue;
		const count = flood(size, cell, seen, (each) => cells[each] === 1);
		if (count > most) [largest, most] = [cell, count];
	}
	return largest;
}

/** Returns whether a cell is in the outermost layer of the grid. */
function isOutermost([nx, ny, nz]: Size, cell: number): boolean {
	const [x, y, z] = [cell % nx, Math.floor(cell / nx) % ny, Math.floor(cell / (nx * ny))];
	return x === 0 || y === 0 || z === 0 || x === nx - 1 || y === ny - 1 || z === nz - 1;
}

/**
 * Marks all cells of a kind that are connected, through faces of cells, with one of them; works in runs along x, so
 * that the stack stays short.
 * @param from the first cell
 * @param marked 1 for marked cells, changed in place
 * @param visit called with each newly marked cell
 * @returns the number of these cells
 */
function flood(
	[nx, ny]: Size,
	from: number,
	marked: Uint8Array,
	isOfKind: (cell: number) => boolean,
	visit?: (cell: number) => void,
): number {
	const isOpen = (cell: number) => marked[cell] === 0 && isOfKind(cell);
	const rows = [nx, -nx, nx * ny, -nx * ny];
	const seeds = [from];
	let count = 0;
	for (let seed = seeds.pop(); seed !== undefined; seed = seeds.pop()) {
		if (!isOpen(seed)) continue;
		// Fill the run of open cells around the seed, then seed each run that begins in the four neighbouring rows.
		const row = seed - (seed % nx);
		let [left, right] = [seed, seed];
		while (left > row && isOpen(left - 1)) left--;
		while (right + 1 < row + nx && isOpen(right + 1)) right++;
		marked.fill(1, left, right + 1);
		count += right + 1 - left;
		if (visit) for (let cell = left; cell <= right; cell++) visit(cell);
		for (const step of rows) {
			const [first, last] = [Math.max(0, left + step), Math.min(marked.length - 1, right + step)];
			for (let cell = first; cell <= last; cell++) {
				if (isOpen(cell) && (cell === first || !isOpen(cell - 1))) seeds.push(cell);
			}
		}
	}
	return count;
}
