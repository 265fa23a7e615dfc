/** What grows in a stand: each plant's own specimen. */
import { shortFloat } from "../../formats/numbers";
import type { Member, MemberRequest, Members, TextPosition } from "../model";
import { placeHanging, spotsWanted } from "./hanging";
import type { StandPlant } from "./stand_plant";

const AROUND = 16;

/** The values of a plant by their keys; numbers to four digits, as they are also told. */
export function valuesOf({ kinds, places }: StandPlant, plant: number): Record<string, number | string> {
	const { settings } = kinds[places.kind[plant]];
	return Object.fromEntries(
		settings.map(({ key, word }, i) => [
			key,
			word === "" ? Number(places.values[places.width * plant + i].toPrecision(4)) : word,
		]),
	);
}

/** What each kind is called: by its preset's title, once one of it has grown; till then by its name in the plan. */
export function titlesOf({ kinds, places, memberOf, members }: StandPlant): readonly string[] {
	const titles = kinds.map(({ preset }) => preset.charAt(0).toUpperCase() + preset.slice(1).replaceAll("-", " "));
	for (const [plant, member] of memberOf.entries()) {
		const title = members[member]?.title;
		if (title !== undefined) titles[places.kind[plant]] = title;
	}
	return titles;
}

/** What grows there: lines of the plan that name the same are one. */
export interface Sort {
	readonly title: string;
	/** The first of its kinds. */
	readonly kind: number;
	/** How many plants. */
	readonly count: number;
}

/** Of each kind the first that is called the same. */
export function firstAlike({ kinds }: Pick<StandPlant, "kinds">): readonly number[] {
	const names = kinds.map(({ name }) => name);
	return names.map((name) => names.indexOf(name));
}

/** What grows there, in the order of the plan. */
export function sortsOf(stand: StandPlant): readonly Sort[] {
	const counts = stand.kinds.map(() => 0);
	const first = firstAlike(stand);
	for (const kind of stand.places.kind) counts[first[kind]]++;
	const titles = titlesOf(stand);
	return [...new Set(first)].map((kind) => ({ title: titles[kind], kind, count: counts[kind] }));
}

/** What is to be grown for one plant, and where the organs of it are at which others hang. */
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
		// What is many is the same wherever it stands.
		...(alone ? {} : { surroundings: Array.from(around, shortFloat) }),
	};
}

/** The first plant that each member is. */
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
		// It may stay as it is, where someone cancels.
		const note = `Only ${grown.length} of ${members.length} different plants have grown.`;
		return placeHanging({ ...stand, members, notes: [...stand.notes, note] });
	},
};

const PRIME = 1099511628211n;
const WORD = 0xffffffffn;

/** Over the placements' and all members', as docs/fingerprint.md has it: the low word of each, then the high one. */
function fingerprintOf({ fingerprint }: StandPlant, members: readonly Member[]): string {
	let state = 14695981039346656037n;
	for (const each of [fingerprint, ...members.map((member) => member.fingerprint)]) {
		const whole = BigInt(`0x${each}`);
		for (const word of [whole & WORD, whole >> 32n]) state = BigInt.asUintN(64, (state ^ word) * PRIME);
	}
	return state.toString(16).padStart(16, "0");
}
