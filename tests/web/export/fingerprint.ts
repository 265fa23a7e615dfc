/** The fingerprint of docs/fingerprint.md, computed from what a growth and its JSON hold. */
import { type Berries, INTERNODE_KINDS, INTERNODE_STATES, type Internodes } from "../../../web/src/core/grown";
import type { GrownDocument } from "../../../web/src/export/json";

export function fingerprintOf({ count, parent, kind, axis, state, ends, radii }: Internodes, berries: Berries): string {
	const values: number[] = [];
	for (let i = 0; i < count; i++) {
		values.push(
			parent[i],
			kind[i],
			axis[i],
			state[i],
			...ends.subarray(6 * i, 6 * i + 6),
			...radii.subarray(2 * i, 2 * i + 2),
		);
	}
	for (let i = 0; i < berries.count; i++) values.push(...berries.spheres.subarray(4 * i, 4 * i + 4), berries.parent[i]);
	return hash(values);
}

export function fingerprintOfDocument({ internodes, berries }: Pick<GrownDocument, "internodes" | "berries">): string {
	const values = internodes.flatMap(({ parent, kind, axis, state, start, end, radius, radiusEnd }) => [
		parent,
		INTERNODE_KINDS.indexOf(kind),
		axis,
		INTERNODE_STATES.indexOf(state),
		...start,
		...end,
		radius,
		radiusEnd,
	]);
	return hash([...values, ...berries.flatMap(({ x, y, z, r, parent }) => [x, y, z, r, parent])]);
}

function hash(values: number[]): string {
	const words = new Uint32Array(Float32Array.from(values, (value) => value + 0).buffer);
	let state = 14695981039346656037n;
	for (const word of words) state = BigInt.asUintN(64, (state ^ BigInt(word)) * 1099511628211n);
	return state.toString(16).padStart(16, "0");
}
