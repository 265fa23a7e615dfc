/** Chance that is the same for ever: hashes of whole numbers, and smooth noise made of them with + − × alone. */

/** A well-mixed hash of two integers (the finaliser of MurmurHash3) as a fraction of 1. */
export function hashFraction(id: number, stream: number): number {
	let h = Math.imul(id + 1, 0x9e3779b1) ^ Math.imul(stream + 1, 0x85ebca6b);
	h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
	h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
	return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
}

/** Smooth noise, 0 … 1, that changes over about one unit; `seed` is a whole number. */
export function noise(x: number, y: number, z: number, seed: number): number {
	const cx = Math.floor(x);
	const cy = Math.floor(y);
	const cz = Math.floor(z);
	const fx = eased(x - cx);
	const fy = eased(y - cy);
	const fz = eased(z - cz);
	const near = plane(cx, cy, cz, fx, fy, seed);
	return near + fz * (plane(cx, cy, cz + 1, fx, fy, seed) - near);
}

/** Between the four corners of a cell that have the same z. */
function plane(cx: number, cy: number, cz: number, fx: number, fy: number, seed: number): number {
	const a = corner(cx, cy, cz, seed);
	const b = corner(cx, cy + 1, cz, seed);
	const low = a + fx * (corner(cx + 1, cy, cz, seed) - a);
	const high = b + fx * (corner(cx + 1, cy + 1, cz, seed) - b);
	return low + fy * (high - low);
}

function corner(x: number, y: number, z: number, seed: number): number {
	return hashFraction(Math.imul(x, 0x1f1f1f1f) ^ Math.imul(y, 0x27d4eb2f) ^ Math.imul(z, 0x165667b1), seed);
}

function eased(t: number): number {
	return t * t * (3 - 2 * t);
}
