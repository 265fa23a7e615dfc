/** Computes the fingerprint of docs/fingerprint.md from a growth and its JSON. */

import type { RecordedRows } from "../../../../web/src/formats/json";
import {
	type Berries,
	INTERNODE_KINDS,
	INTERNODE_STATES,
	type Internodes,
	type Procedure,
} from "../../../../web/src/models/bunch/bunch_plant";
import type { BunchRecord, NaturalBerryRecord } from "../../../../web/src/models/bunch/record";

export function fingerprintOf(
	{ count, parent, kind, axis, state, ends, radii }: Internodes,
	berries: Berries,
	procedure: Procedure,
): string {
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
	for (let i = 0; i < berries.count; i++) {
		values.push(...berries.spheres.subarray(4 * i, 4 * i + 4), berries.parent[i]);
		if (procedure === "paper") continue;
		values.push(berries.ids[i], ...berries.traits.subarray(8 * i, 8 * i + 2));
		values.push(...berries.directions.subarray(3 * i, 3 * i + 3));
	}
	return hash(values);
}

export function fingerprintOfDocument({
	internodes,
	berries,
	procedure,
}: Pick<RecordedRows<BunchRecord>, "internodes" | "berries" | "procedure">): string {
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
	const natural = ({ id, width, length, direction }: NaturalBerryRecord) => [id, width, length, ...direction];
	const more = procedure === "natural" ? natural : () => [];
	return hash([
		...values,
		...berries.flatMap((berry) => [
			berry.x,
			berry.y,
			berry.z,
			berry.r,
			berry.parent,
			...more(berry as NaturalBerryRecord),
		]),
	]);
}

function hash(values: number[]): string {
	const words = new Uint32Array(Float32Array.from(values, (value) => value + 0).buffer);
	let state = 14695981039346656037n;
	for (const word of words) state = BigInt.asUintN(64, (state ^ BigInt(word)) * 1099511628211n);
	return state.toString(16).padStart(16, "0");
}
