/** Pseudo-random numbers that are the same on every machine: hashes of whole numbers, and smooth noise made of them. */

/** Returns a well-mixed hash of two integers (the finaliser of MurmurHash3) as a fraction of 1. */
export function hashFraction(id: number, stream: number): number {
	let h = Math.imul(id + 1, 0x9e3779b1) ^ Math.imul(stream + 1, 0x85ebca6b);
	h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
	h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
	return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
}

/** Computes smooth noise of one octave, 0 … 1, that changes over about one unit: the same as `noise` in NOISE_CHUNK. */
export function noise(x: number, y: number, z: number): number {
	const cx = Math.floor(x);
	const cy = Math.floor(y);
	const cz = Math.floor(z);
	const fx = eased(x - cx);
	const fy = eased(y - cy);
	const fz = eased(z - cz);
	const near = plane(cx, cy, cz, fx, fy);
	return near + fz * (plane(cx, cy, cz + 1, fx, fy) - near);
}

/** Interpolates between the four corners of a cell with the same z. */
function plane(cx: number, cy: number, cz: number, fx: number, fy: number): number {
	const a = corner(cx, cy, cz);
	const b = corner(cx, cy + 1, cz);
	const low = a + fx * (corner(cx + 1, cy, cz) - a);
	const high = b + fx * (corner(cx + 1, cy + 1, cz) - b);
	return low + fy * (high - low);
}

/** Returns a random number, 0 … 1, for a corner of the grid: a hash of its whole coordinates. */
function corner(x: number, y: number, z: number): number {
	const a = Math.imul(x, 0x9e3779b1);
	const b = Math.imul(y, 0x85ebca6b);
	const c = Math.imul(z, 0xc2b2ae35);
	let h = Math.imul(a ^ (b >>> 7) ^ (b << 9) ^ (c >>> 13) ^ (c << 3), 0x27d4eb2d);
	h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
	return (h >>> 16) / 65535;
}

/** Returns a smooth transition from 0 to 1 for t in 0 … 1. */
function eased(t: number): number {
	return t * t * (3 - 2 * t);
}

/** Noise for shaders, on the eight corners of a cell. */
export const NOISE_CHUNK = /* glsl */ `
const uvec3 NOISE_PRIMES = uvec3(0x9e3779b1u, 0x85ebca6bu, 0xc2b2ae35u);
vec4 mixed_bits(uvec4 h) {
	h *= 0x27d4eb2du;
	h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
	return vec4(h >> 16u) / 65535.0;
}
float hash(ivec3 cell) {
	uvec3 c = uvec3(cell) * NOISE_PRIMES;
	return mixed_bits(uvec4(c.x ^ (c.y >> 7u) ^ (c.y << 9u) ^ (c.z >> 13u) ^ (c.z << 3u))).x;
}
float noise(vec3 at) {
	vec3 floored = floor(at);
	vec3 f = at - floored;
	f = f * f * (3.0 - 2.0 * f);
	uvec3 low = uvec3(ivec3(floored)) * NOISE_PRIMES;
	uvec3 high = low + NOISE_PRIMES;
	uvec2 b = uvec2(low.y, high.y);
	uvec2 c = uvec2(low.z, high.z);
	uvec4 across = ((b >> 7u) ^ (b << 9u)).xyxy ^ ((c >> 13u) ^ (c << 3u)).xxyy;
	vec4 sides = mix(mixed_bits(across ^ low.x), mixed_bits(across ^ high.x), f.x);
	vec2 ends = mix(sides.xz, sides.yw, f.y);
	return mix(ends.x, ends.y, f.z);
}
`;
