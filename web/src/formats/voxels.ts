/** A body as voxels: the inside of closed meshes, with thin parts thickened to at least one cell. */
import type { Mesh } from "../plant/plant";

/** Cells, 1 inside the body; x runs fastest. The outermost layer on every side is empty. */
export interface Voxels {
	readonly size: readonly [x: number, y: number, z: number];
	/** The corner of the first cell, and the edge of every cell. */
	readonly origin: readonly number[];
	readonly pitch: number;
	readonly cells: Uint8Array;
}

/** Empty layers around the box: the growth of bodies, and one. */
const MARGIN = 4;

/**
 * Returns a grid of empty cells around a box.
 * @param low @param high corners of the box
 * @param pitch edge of a cell
 * @param margin empty layers on every side of the box
 */
export function emptyVoxels(low: readonly number[], high: readonly number[], pitch: number, margin = MARGIN): Voxels {
	const count = (axis: number) => Math.ceil((high[axis] - low[axis]) / pitch) + 2 * margin;
	const size = [count(0), count(1), count(2)] as const;
	const origin = low.map((value) => value - margin * pitch);
	return { size, origin, pitch, cells: new Uint8Array(size[0] * size[1] * size[2]) };
}

/** Fills the cells whose middle is inside any of the closed meshes, by the winding number of all of them together. */
export function fillInside({ size: [nx, ny, nz], origin, pitch, cells }: Voxels, closed: readonly Mesh[]): void {
	// Crossings of each row along x: the position, and whether it enters or leaves a body.
	const rows = new Map<number, number[]>();
	const cellsAlong = (mesh: Mesh, vertex: number, axis: number) =>
		(mesh.positions[3 * vertex + axis] - origin[axis]) / pitch - 0.5;
	for (const mesh of closed) {
		for (let i = 0; i < mesh.indices.length; i += 3) {
			const [a, b, c] = [mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]];
			const [ay, by, cy] = [
				cellsAlong(mesh, a, 1) + RAY_SHIFT[0],
				cellsAlong(mesh, b, 1) + RAY_SHIFT[0],
				cellsAlong(mesh, c, 1) + RAY_SHIFT[0],
			];
			const [az, bz, cz] = [
				cellsAlong(mesh, a, 2) + RAY_SHIFT[1],
				cellsAlong(mesh, b, 2) + RAY_SHIFT[1],
				cellsAlong(mesh, c, 2) + RAY_SHIFT[1],
			];
			const [ax, bx, cx] = [cellsAlong(mesh, a, 0), cellsAlong(mesh, b, 0), cellsAlong(mesh, c, 0)];
			const [z1, y1] = [
				Math.min(nz - 1, Math.floor(Math.max(az, bz, cz))),
				Math.min(ny - 1, Math.floor(Math.max(ay, by, cy))),
			];
			for (let z = Math.max(0, Math.ceil(Math.min(az, bz, cz))); z <= z1; z++) {
				for (let y = Math.max(0, Math.ceil(Math.min(ay, by, cy))); y <= y1; y++) {
					// Barycentric coordinates of the row in the projected triangle, up to a factor; their sign gives its side.
					const u = (by - y) * (cz - z) - (bz - z) * (cy - y);
					const v = (cy - y) * (az - z) - (cz - z) * (ay - y);
					const w = (ay - y) * (bz - z) - (az - z) * (by - y);
					if (!((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))) continue;
					const row = rows.get(z * ny + y) ?? [];
					row.push((u * ax + v * bx + w * cx) / (u + v + w), u > 0 ? -1 : 1);
					rows.set(z * ny + y, row);
				}
			}
		}
	}
	for (const [row, crossings] of rows) fillRow(cells.subarray(row * nx, (row + 1) * nx), crossings);
}

/** Shares of a cell by which meshes are shifted, so that no row runs along an edge of a symmetrical body. */
const RAY_SHIFT = [1.7e-5, 2.3e-5] as const;

/**
 * Fills the cells of a row where the winding number is not zero.
 * @param crossings pairs: a position (in cells; whole numbers are the middles of cells), and ±1 for entering or leaving
 * a body
 */
function fillRow(row: Uint8Array, crossings: readonly number[]): void {
	const order = Array.from({ length: crossings.length / 2 }, (_, i) => i).sort(
		(i, j) => crossings[2 * i] - crossings[2 * j],
	);
	let winding = 0;
	for (const [k, i] of order.entries()) {
		winding += crossings[2 * i + 1];
		if (winding === 0 || k + 1 === order.length) continue;
		const [from, to] = [Math.ceil(crossings[2 * i]), Math.floor(crossings[2 * order[k + 1]])];
		if (to >= from) row.fill(1, Math.max(0, from), Math.min(row.length, to + 1));
	}
}

/** Fills the cells that surfaces pass through without a filled neighbour: parts thinner than a cell. */
export function fillThin(voxels: Voxels, surfaces: readonly Mesh[]): void {
	const {
		size: [nx, ny],
		origin,
		pitch,
		cells,
	} = voxels;
	// Filled cells and their neighbours.
	const filledOrNear = cells.slice();
	dilate(filledOrNear, voxels.size, -1, 1);
	const fillAt = (x: number, y: number, z: number) => {
		const cell = (Math.floor(z) * ny + Math.floor(y)) * nx + Math.floor(x);
		if (filledOrNear[cell] === 0) cells[cell] = 1;
	};
	for (const { positions, indices } of surfaces) {
		const cellsOf = (vertex: number) => [0, 1, 2].map((k) => (positions[3 * vertex + k] - origin[k]) / pitch);
		for (let i = 0; i < indices.length; i += 3) {
			const [a, b, c] = [cellsOf(indices[i]), cellsOf(indices[i + 1]), cellsOf(indices[i + 2])];
			// Points of the triangle at most half a cell apart.
			const steps = Math.ceil(2 * Math.max(distance(a, b), distance(b, c), distance(c, a))) || 1;
			for (let u = 0; u <= steps; u++) {
				for (let v = 0; v <= steps - u; v++) {
					const [s, t] = [u / steps, v / steps];
					const coordinate = (k: number) => a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k]);
					fillAt(coordinate(0), coordinate(1), coordinate(2));
				}
			}
		}
	}
}

/** Returns the distance between two points. */
const distance = (a: readonly number[], b: readonly number[]) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

/**
 * Makes the body a union of cubes of `thickness` cells, which is its least thickness. Thicker parts stay as they are (an
 * opening); thinner ones grow around their middle.
 */
export function thicken({ size, cells }: Voxels, thickness: number): void {
	const [from, to] = [-Math.floor((thickness - 1) / 2), Math.ceil((thickness - 1) / 2)];
	const opened = cells.slice();
	erode(opened, size, from, to);
	dilate(opened, size, from, to);
	for (let i = 0; i < cells.length; i++) cells[i] = cells[i] & ~opened[i];
	dilate(cells, size, from, to);
	for (let i = 0; i < cells.length; i++) cells[i] |= opened[i];
}

/**
 * Fills gaps into which no cube of `2 * radius + 1` cells fits (a closing).
 * @param voxels with at least `radius + 1` empty layers on every side
 */
export function closeGaps({ size, cells }: Voxels, radius: number): void {
	dilate(cells, size, -radius, radius);
	erode(cells, size, -radius, radius);
}

/** Fills cells with a filled cell at minus `from` … `to` along each axis (a dilation by a box). */
function dilate(cells: Uint8Array, size: Voxels["size"], from: number, to: number): void {
	filterBox(cells, size, from, to, 1);
}

/** Leaves only cells with all cells filled at `from` … `to` along each axis (an erosion by a box). */
function erode(cells: Uint8Array, size: Voxels["size"], from: number, to: number): void {
	filterBox(cells, size, from, to, 0);
}

/**
 * Dilates or erodes by a box, along one axis after the other.
 * @param from first offset of the box along each axis, cells; `to` is the last one
 * @param spreading the value that spreads: 1 dilates, 0 erodes; its offsets are then those of the other cells reversed
 */
function filterBox(cells: Uint8Array, [nx, ny, nz]: Voxels["size"], from: number, to: number, spreading: 0 | 1): void {
	const [firstOffset, lastOffset] = spreading ? [-to, -from] : [from, to];
	const axes = [
		[nx, 1, ny * nz, nx],
		[ny, nx, nx * nz, 0],
		[nz, nx * ny, nx * ny, 0],
	] as const;
	for (const [axis, [count, step, rows]] of axes.entries()) {
		const row = new Uint8Array(count);
		for (let r = 0; r < rows; r++) {
			const start = axis === 0 ? r * nx : axis === 1 ? Math.floor(r / nx) * nx * ny + (r % nx) : r;
			let any = false;
			for (let i = 0; i < count; i++) {
				row[i] = cells[start + i * step];
				any ||= row[i] !== 0;
			}
			if (!any) continue;
			for (let i = 0; i < count; i++) {
				let value: number = 1 - spreading;
				for (let k = Math.max(0, i + firstOffset); k <= Math.min(count - 1, i + lastOffset) && value !== spreading; k++)
					value = row[k];
				cells[start + i * step] = value;
			}
		}
	}
}

/**
 * Fills one cell of every square of four in which only two diagonal ones are filled: there edges would have four faces.
 */
export function withoutPinches({ size: [nx, ny, nz], cells }: Voxels): void {
	const plane = nx * ny;
	const fillPinch = (at: number, u: number, v: number) => {
		const filled = cells[at];
		if (cells[at + u] === filled || cells[at + v] === filled || cells[at + u + v] !== filled) return false;
		cells[filled ? at + u : at] = 1;
		return true;
	};
	for (let changed = true; changed; ) {
		changed = false;
		for (let i = 0; i < plane * (nz - 1) - nx - 1; i++) {
			// A cell that differs from fewer than two of its neighbours is no corner of such a square.
			const filled = 3 * cells[i];
			if (Math.abs(filled - cells[i + 1] - cells[i + nx] - cells[i + plane]) < 2) continue;
			if (fillPinch(i, 1, nx)) changed = true;
			if (fillPinch(i, 1, plane)) changed = true;
			if (fillPinch(i, nx, plane)) changed = true;
		}
	}
}
