/** The specimens that grow in a stand. */

import { shortFloat } from "../../formats/numbers";
import type { Member, MemberRequest, Members, TextPosition } from "../model";
import { placeHanging, spotsWanted } from "./hanging";
import { text } from "./messages.generated";
import type { StandPlant } from "./stand_plant";

/** Numbers per plant in `Places.surroundings`: 8 heights of the horizon, then 8 lengths of free room. */
const SURROUNDING_VALUES = 16;

/** Returns the settings of a plant by key: options as words, numbers with four significant digits, as displayed. */
export function valuesOf({ kinds, places }: StandPlant, plant: number): Record<string, number | string> {
	const { settings } = kinds[places.kind[plant]];
	return Object.fromEntries(
		settings.map(({ key, word }, i) => [
			key,
			word === "" ? Number(places.values[places.width * plant + i].toPrecision(4)) : word,
		]),
	);
}

/**
 * Returns the title of each kind: the preset's title when a plant of the kind has grown, before that the name in the
 * plan.
 */
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

/** Returns for each kind the index of the first kind of the same name. */
export function firstOfSameName({ kinds }: Pick<StandPlant, "kinds">): readonly number[] {
	const names = kinds.map(({ name }) => name);
	return names.map((name) => names.indexOf(name));
}

/** Counts the plants of the same name, in the order of the plan. */
export function plantGroups(stand: StandPlant): readonly PlantGroup[] {
	const counts = stand.kinds.map(() => 0);
	const first = firstOfSameName(stand);
	for (const kind of stand.places.kind) counts[first[kind]]++;
	const titles = titlesOf(stand);
	return [...new Set(first)].map((kind) => ({ title: titles[kind], kind, count: counts[kind] }));
}

/**
 * Returns the request for one plant. It has the plant's surroundings, unless it hangs on another plant or its member is shared
 * by several plants, which cannot all have the same surroundings.
 * @param spotTags tags of the organs at which other plants hang, by the kind of their parent; the response has the
 * positions of these organs
 */
export function requestOf(stand: StandPlant, plant: number, spotTags = spotsWanted(stand)): MemberRequest {
	const { kinds, places } = stand;
	const { model, preset, place, settings, seeds } = kinds[places.kind[plant]];
	const settingPositions = Object.fromEntries(
		settings.map(({ key, place: position }): [string, TextPosition] => [key, position]),
	);
	const sharesMember = seeds > 0;
	const hangs = places.parent[plant] >= 0;
	const tags = spotTags.get(places.kind[plant]);
	const surroundings = places.surroundings.subarray(SURROUNDING_VALUES * plant, SURROUNDING_VALUES * (plant + 1));
	return {
		model,
		preset,
		seed: places.seed[plant],
		values: valuesOf(stand, plant),
		place,
		places: settingPositions,
		...(tags ? { spots: [...tags] } : {}),
		...(sharesMember || hangs ? {} : { surroundings: Array.from(surroundings, shortFloat) }),
	};
}

/** Returns the first plant of each member. */
export function firstOf({ memberOf }: StandPlant): number[] {
	const first: number[] = [];
	for (const [plant, member] of memberOf.entries()) if (member === first.length) first.push(plant);
	return first;
}

export const standMembers: Members<StandPlant> = {
	requests: (stand) => {
		const spotTags = spotsWanted(stand);
		return firstOf(stand).map((plant) => requestOf(stand, plant, spotTags));
	},
	joined: (stand, members) => {
		const grown = members.filter((member) => member !== undefined);
		if (grown.length === members.length)
			return placeHanging({ ...stand, members, fingerprint: fingerprintOf(stand, grown) });
		// The note may stay where the user cancels.
		const note = text("some_grown", { grown: grown.length, count: members.length });
		return placeHanging({ ...stand, members, notes: [...stand.notes, note] });
	},
};

/** Parameters of the FNV-1a hash of 64 bits. */
const FNV_PRIME = 1099511628211n;
const FNV_START = 14695981039346656037n;
const LOW_WORD = 0xffffffffn;

/**
 * Computes the fingerprint of the placements and all members (docs/fingerprint.md): an FNV-1a hash of the low word of
 * each, then of the high word.
 */
function fingerprintOf({ fingerprint }: StandPlant, members: readonly Member[]): string {
	let state = FNV_START;
	for (const each of [fingerprint, ...members.map((member) => member.fingerprint)]) {
		const whole = BigInt(`0x${each}`);
		for (const word of [whole & LOW_WORD, whole >> 32n]) state = BigInt.asUintN(64, (state ^ word) * FNV_PRIME);
	}
	return state.toString(16).padStart(16, "0");
}
