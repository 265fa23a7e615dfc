/**
 * Positions of plants that hang at organs of their parent (`at bunch`). The plan lists these plants before anything
 * has grown; the positions of the organs are known when the parent has grown.
 */
import type { Member } from "../model";
import type { Places, StandPlant } from "./stand_plant";

/** Tags of the requested organs, by the index of the parent's kind. */
export function spotsWanted({ kinds, places }: StandPlant): Map<number, Set<string>> {
	const wanted = new Map<number, Set<string>>();
	if (kinds.every(({ spot }) => spot === "")) return wanted;
	for (let plant = 0; plant < places.count; plant++) {
		const { spot } = kinds[places.kind[plant]];
		if (spot === "") continue;
		const parent = places.kind[places.parent[plant]];
		wanted.set(parent, (wanted.get(parent) ?? new Set()).add(spot));
	}
	return wanted;
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
	let full = 0;
	for (let plant = 0; plant < places.count; ) {
		const among = siblingCount(places, plant);
		const { spot } = kinds[places.kind[plant]];
		const parent = places.parent[plant];
		const member = spot === "" ? undefined : stand.members[stand.memberOf[parent]];
		const spots = member && spotsOf(member, spot);
		const hangs = spot === "" ? among : Math.min(among, (spots?.length ?? 0) / 3);
		if (spots) full += among - hangs;
		for (let k = 0; k < hangs; k++) {
			attached.push(plant + k);
			if (!spots) continue;
			const which = Math.floor(((k + 0.5) * spots.length) / 3 / hangs);
			const place = positionOn(places, parent, spots.subarray(3 * which, 3 * which + 3));
			at.set(place, 3 * (plant + k));
			transforms.set(place, (transforms.length / places.count) * (plant + k));
		}
		plant += among;
	}
	const moved = { ...places, at, transforms };
	if (attached.length === places.count) return { ...stand, places: moved };
	return withoutUnplaced(stand, moved, attached, full);
}

/** Number of successive plants of the same kind and parent. */
function siblingCount({ kind, parent, count }: Places, plant: number): number {
	let end = plant + 1;
	if (parent[plant] < 0) return 1;
	while (end < count && kind[end] === kind[plant] && parent[end] === parent[plant]) end++;
	return end - plant;
}

const NONE = new Float32Array(0);
const spotsOf = ({ spots }: Member, tag: string): Float32Array => spots?.[tag] ?? NONE;

/** Transforms a point on a plant to the stand. */
function positionOn({ at, scale, turn }: Places, plant: number, [x, y, z]: Float32Array): [number, number, number] {
	const [size, angle] = [scale[plant], (turn[plant] * Math.PI) / 180];
	const [cosine, sine] = [size * Math.cos(angle), size * Math.sin(angle)];
	const [footX, footY, footZ] = at.subarray(3 * plant, 3 * plant + 3);
	return [footX + cosine * x - sine * z, footY + size * y, footZ + sine * x + cosine * z];
}

/**
 * The stand with only the plants in `attached`. Parents come before the plants attached to them, and are never left
 * out.
 */
function withoutUnplaced(stand: StandPlant, places: Places, attached: readonly number[], full: number): StandPlant {
	const rows = <A extends Float32Array | Uint32Array | Int32Array>(from: A): A => {
		const width = from.length / places.count;
		const to = from.slice(0, width * attached.length) as A;
		for (const [i, plant] of attached.entries()) to.set(from.subarray(width * plant, width * (plant + 1)), width * i);
		return to;
	};
	const note = `${full} found no place on what bears them: it has not as many.`;
	return {
		...stand,
		places: {
			...places,
			count: attached.length,
			kind: rows(places.kind),
			seed: rows(places.seed),
			parent: rows(places.parent),
			at: rows(places.at),
			scale: rows(places.scale),
			turn: rows(places.turn),
			values: rows(places.values),
			surroundings: rows(places.surroundings),
			transforms: rows(places.transforms),
		},
		memberOf: rows(stand.memberOf),
		counts: {
			...stand.counts,
			plants: attached.length,
			borne: stand.counts.borne - (places.count - attached.length),
		},
		notes: full > 0 ? [...stand.notes, note] : stand.notes,
	};
}
