/** The specimens that grow in a stand. */
import { shortFloat } from "../../formats/numbers";
import type { Member, MemberRequest, Members, TextPosition } from "../model";
import { placeHanging, spotsWanted } from "./hanging";
import type { StandPlant } from "./stand_plant";

const AROUND = 16;

/** The settings of a plant by key; numbers with four significant digits, as displayed. */
export function valuesOf({ kinds, places }: StandPlant, plant: number): Record<string, number | string> {
	const { settings } = kinds[places.kind[plant]];
	return Object.fromEntries(
		settings.map(({ key, word }, i) => [
			key,
			word === "" ? Number(places.values[places.width * plant + i].toPrecision(4)) : word,
		]),
	);
}

/** Titles of the kinds: the preset's title when a plant of the kind has grown, before that the name in the plan. */
export function titlesOf({ kinds, places, memberOf, members }: StandPlant): readonly string[] {
	const titles = kinds.map(({ preset }) => preset.charAt(0).toUpperCase() + preset.slice(1).replaceAll("-", " "));
	for (const [plant, member] of memberOf.entries()) {
		const title = members[member]?.title;
		if (title !== undefined) titles[places.kind[plant]] = title;
	}
	return titles;
}

/** Plants of the same name; several lines of a plan may have the same name. */
export interface PlantGroup {
	readonly title: string;
	/** Index of the first kind. */
	readonly kind: number;
	/** Number of plants. */
	readonly count: number;
}

/** By kind, the first kind of the same name. */
export function firstOfSameName({ kinds }: Pick<StandPlant, "kinds">): readonly number[] {
	const names = kinds.map(({ name }) => name);
	return names.map((name) => names.indexOf(name));
}

/** The groups of plants in the order of the plan. */
export function plantGroups(stand: StandPlant): readonly PlantGroup[] {
	const counts = stand.kinds.map(() => 0);
	const first = firstOfSameName(stand);
	for (const kind of stand.places.kind) counts[first[kind]]++;
	const titles = titlesOf(stand);
	return [...new Set(first)].map((kind) => ({ title: titles[kind], kind, count: counts[kind] }));
}

/** The request for one plant, with the tags of organs at which other plants hang. */
export function requestOf(stand: StandPlant, plant: number, wanted = spotsWanted(stand)): MemberRequest {
	const { kinds, places } = stand;
	const { model, preset, place, settings, seeds } = kinds[places.kind[plant]];
	const spots = Object.fromEntries(settings.map(({ key, place: spot }): [string, TextPosition] => [key, spot]));
	const alone = seeds > 0 || places.parent[plant] >= 0;
	const tags = wanted.get(places.kind[plant]);
	const around = places.surroundings.subarray(AROUND * plant, AROUND * (plant + 1));
	return {
		model,
		preset,
		seed: places.seed[plant],
		values: valuesOf(stand, plant),
		place,
		places: spots,
		...(tags ? { spots: [...tags] } : {}),
		// Members that several plants share do not depend on their surroundings.
		...(alone ? {} : { surroundings: Array.from(around, shortFloat) }),
	};
}

/** The first plant of each member. */
export function firstOf({ memberOf }: StandPlant): number[] {
	const first: number[] = [];
	for (const [plant, member] of memberOf.entries()) if (member === first.length) first.push(plant);
	return first;
}

export const standMembers: Members<StandPlant> = {
	requests: (stand) => {
		const wanted = spotsWanted(stand);
		return firstOf(stand).map((plant) => requestOf(stand, plant, wanted));
	},
	joined: (stand, members) => {
		const grown = members.filter((member) => member !== undefined);
		if (grown.length === members.length)
			return placeHanging({ ...stand, members, fingerprint: fingerprintOf(stand, grown) });
		// The note may stay where the user cancels.
		const note = `Only ${grown.length} of ${members.length} different plants have grown.`;
		return placeHanging({ ...stand, members, notes: [...stand.notes, note] });
	},
};

const PRIME = 1099511628211n;
const WORD = 0xffffffffn;

/** Fingerprint of the placements and all members (docs/fingerprint.md): the low word of each, then the high word. */
function fingerprintOf({ fingerprint }: StandPlant, members: readonly Member[]): string {
	let state = 14695981039346656037n;
	for (const each of [fingerprint, ...members.map((member) => member.fingerprint)]) {
		const whole = BigInt(`0x${each}`);
		for (const word of [whole & WORD, whole >> 32n]) state = BigInt.asUintN(64, (state ^ word) * PRIME);
	}
	return state.toString(16).padStart(16, "0");
}
