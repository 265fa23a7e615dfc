/**
 * Positions of plants that hang at organs of their parent (`at bunch`). The plan lists these plants before anything
 * has grown; the positions of the organs are known when the parent has grown.
 */

import type { Member } from "../model";
import { text } from "./messages.generated";
import type { Places, StandPlant } from "./stand_plant";

/** Returns the tags of the organs at which plants hang, by the kind of the plants that have these organs. */
export function spotsWanted({ kinds, places }: StandPlant): Map<number, Set<string>> {
	const tags = new Map<number, Set<string>>();
	if (kinds.every(({ spot }) => spot === "")) return tags;
	for (let plant = 0; plant < places.count; plant++) {
		const { spot } = kinds[places.kind[plant]];
		if (spot === "") continue;
		const parentKind = places.kind[places.parent[plant]];
		tags.set(parentKind, (tags.get(parentKind) ?? new Set()).add(spot));
	}
	return tags;
}

/**
 * Places hanging plants at the organs of their parents, evenly spread. Plants without a free organ, and those whose
 * parent has not grown, are left out. Idempotent.
 */
export function placeHanging(stand: StandPlant): StandPlant {
	const { kinds, places } = stand;
	if (kinds.every(({ spot }) => spot === "")) return stand;
	const at = places.at.slice();
	const transforms = places.transforms.slice();
	const attached: number[] = [];
	// Number of plants without a free organ.
	let unplaced = 0;
	for (let plant = 0; plant < places.count; ) {
		// Plants that are attached to the same parent follow each other.
		const siblings = siblingCount(places, plant);
		const { spot } = kinds[places.kind[plant]];
		const parent = places.parent[plant];
		const member = spot === "" ? undefined : stand.members[stand.memberOf[parent]];
		const spots = member && spotsOf(member, spot);
		const placed = spot === "" ? siblings : Math.min(siblings, (spots?.length ?? 0) / 3);
		if (spots) unplaced += siblings - placed;
		for (let k = 0; k < placed; k++) {
			attached.push(plant + k);
			if (!spots) continue;
			// Spread the plants evenly over the organs.
			const organ = Math.floor(((k + 0.5) * spots.length) / 3 / placed);
			const position = positionInStand(places, parent, spots.subarray(3 * organ, 3 * organ + 3));
			at.set(position, 3 * (plant + k));
			transforms.set(position, (transforms.length / places.count) * (plant + k));
		}
		plant += siblings;
	}
	const newPlaces = { ...places, at, transforms };
	if (attached.length === places.count) return { ...stand, places: newPlaces };
	return withoutUnplaced(stand, newPlaces, attached, unplaced);
}

/**
 * Returns the number of successive plants of the same kind and parent, from `plant` on; 1 for a plant on the ground.
 */
function siblingCount({ kind, parent, count }: Places, plant: number): number {
	let end = plant + 1;
	if (parent[plant] < 0) return 1;
	while (end < count && kind[end] === kind[plant] && parent[end] === parent[plant]) end++;
	return end - plant;
}

const NONE = new Float32Array(0);
/** Returns the positions of a member's organs with a tag, 3 numbers each; none where it has no such organs. */
const spotsOf = ({ spots }: Member, tag: string): Float32Array => spots?.[tag] ?? NONE;

/**
 * Transforms a point of a plant's own axes to the stand: scaled, turned about the vertical axis, moved to the plant's
 * foot.
 */
function positionInStand(
	{ at, scale, turn }: Places,
	plant: number,
	[x, y, z]: Float32Array,
): [number, number, number] {
	const [size, angle] = [scale[plant], (turn[plant] * Math.PI) / 180];
	const [cosine, sine] = [size * Math.cos(angle), size * Math.sin(angle)];
	const [footX, footY, footZ] = at.subarray(3 * plant, 3 * plant + 3);
	return [footX + cosine * x - sine * z, footY + size * y, footZ + sine * x + cosine * z];
}

/**
 * Returns the stand with only the plants in `attached` and those before them. Parents come before the plants attached
 * to them, and are never left out.
 * @param unplaced number of plants that are left out
 */
function withoutUnplaced(stand: StandPlant, places: Places, attached: readonly number[], unplaced: number): StandPlant {
	// Copies the rows of the remaining plants; every array has the same number of values for each plant.
	const remainingRows = <A extends Float32Array | Uint32Array | Int32Array>(column: A): A => {
		const width = column.length / places.count;
		const rows = column.slice(0, width * attached.length) as A;
		for (const [i, plant] of attached.entries())
			rows.set(column.subarray(width * plant, width * (plant + 1)), width * i);
		return rows;
	};
	const note = text("no_place", { count: unplaced });
	return {
		...stand,
		places: {
			...places,
			count: attached.length,
			kind: remainingRows(places.kind),
			seed: remainingRows(places.seed),
			parent: remainingRows(places.parent),
			at: remainingRows(places.at),
			scale: remainingRows(places.scale),
			turn: remainingRows(places.turn),
			values: remainingRows(places.values),
			surroundings: remainingRows(places.surroundings),
			transforms: remainingRows(places.transforms),
		},
		memberOf: remainingRows(stand.memberOf),
		counts: {
			...stand.counts,
			plants: attached.length,
			borne: stand.counts.borne - (places.count - attached.length),
		},
		notes: unplaced > 0 ? [...stand.notes, note] : stand.notes,
	};
}
