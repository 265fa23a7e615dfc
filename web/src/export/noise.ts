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
	const [cx, cy, cz] = [Math.floor(x), Math.floor(y), Math.floor(z)];
	const [fx, fy, fz] = [eased(x - cx), eased(y - cy), eased(z - cz)];
	let sum = 0;
	for (let corner = 0; corner < 8; corner++) {
		const [dx, dy, dz] = [corner & 1, (corner >> 1) & 1, corner >> 2];
		const weight = (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy) * (dz ? fz : 1 - fz);
		const cell = Math.imul(cx + dx, 0x1f1f1f1f) ^ Math.imul(cy + dy, 0x27d4eb2f) ^ Math.imul(cz + dz, 0x165667b1);
		sum += weight * hashFraction(cell, seed);
	}
	return sum;
}

function eased(t: number): number {
	return t * t * (3 - 2 * t);
}
