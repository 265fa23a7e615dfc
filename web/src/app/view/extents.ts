/** The size of a plant from its lowest to its highest point, and as much sideways. */
import { everyPart, type Part, TRANSFORM } from "../../plant/part";

/** Sizes along the axes of the plant, metres. */
export interface Extents {
	readonly width: number;
	readonly height: number;
	readonly depth: number;
}

/** A box that points extend. */
class Box {
	readonly #low = [Infinity, Infinity, Infinity];
	readonly #high = [-Infinity, -Infinity, -Infinity];

	add(x: number, y: number, z: number): void {
		this.#along(0, x);
		this.#along(1, y);
		this.#along(2, z);
	}

	/** Whether a ball is completely inside. */
	contains(x: number, y: number, z: number, radius: number): boolean {
		return [x, y, z].every((at, axis) => at - radius >= this.#low[axis] && at + radius <= this.#high[axis]);
	}

	/** Undefined without a point. */
	get extents(): Extents | undefined {
		const [width, height, depth] = this.#high.map((high, axis) => high - this.#low[axis]);
		return width >= 0 ? { width, height, depth } : undefined;
	}

	#along(axis: number, at: number): void {
		if (at < this.#low[axis]) this.#low[axis] = at;
		if (at > this.#high[axis]) this.#high[axis] = at;
	}
}

/** Returns the extents of all points of all parts; undefined without any. */
export function extentsOf(parts: Iterable<Part>): Extents | undefined {
	const box = new Box();
	for (const { shape } of everyPart(parts)) {
		if (!shape) continue;
		const { positions } = shape.mesh;
		if (shape.instances) addInstances(box, positions, shape.instances.transforms);
		else for (let i = 0; i < positions.length; i += 3) box.add(positions[i], positions[i + 1], positions[i + 2]);
	}
	return box.extents;
}

/** Adds the points of all instances, except of those that are inside the box anyway. */
function addInstances(box: Box, positions: Float32Array, transforms: Float32Array): void {
	let reach = 0;
	for (let i = 0; i < positions.length; i += 3)
		reach = Math.max(reach, Math.hypot(positions[i], positions[i + 1], positions[i + 2]));
	for (let at = 0; at < transforms.length; at += TRANSFORM) {
		const [x, y, z, qx, qy, qz, qw, scale] = transforms.subarray(at, at + TRANSFORM);
		if (box.contains(x, y, z, reach * scale)) continue;
		for (let i = 0; i < positions.length; i += 3) {
			const [px, py, pz] = [scale * positions[i], scale * positions[i + 1], scale * positions[i + 2]];
			// v + 2 q × (q × v + w v)
			const cx = qy * pz - qz * py + qw * px;
			const cy = qz * px - qx * pz + qw * py;
			const cz = qx * py - qy * px + qw * pz;
			box.add(x + px + 2 * (qy * cz - qz * cy), y + py + 2 * (qz * cx - qx * cz), z + pz + 2 * (qx * cy - qy * cx));
		}
	}
}
