/** Columns of an answer → a stand (wasm-core/src/models/stand/model.hpp). */
import type { Columns } from "../../core/container";
import type { Answer } from "../../core/core";
import { EMPTY_PLANT, type Plant } from "../../plant/plant";
import { readPlant } from "../../plant/read_plant";
import type { Member, TextPosition } from "../model";
import { fetchedSoil } from "./fetched_soil";
import type { Soil } from "./soil";

/** A parameter that a line sets. */
export interface Setting {
	readonly key: string;
	/** What it is set to; empty where that is a number, drawn for each plant. */
	readonly word: string;
	readonly place: TextPosition;
}

/** A line of what grows. */
export interface Kind {
	/** `growth/oak`. */
	readonly name: string;
	readonly model: string;
	readonly preset: string;
	readonly place: TextPosition;
	/** How many different ones there are; 0: as many as plants. */
	readonly seeds: number;
	/** At which of its bearer's organs it hangs, by their tag; empty where the plan says where. */
	readonly spot: string;
	/** At scale 1, metres. */
	readonly crown: { readonly width: number; readonly height: number };
	readonly settings: readonly Setting[];
}

/** Where plants stand, an element each; those that others bear behind all others. */
export interface Places {
	readonly count: number;
	readonly kind: Uint32Array;
	readonly seed: Uint32Array;
	/** The plant that bears it, −1 of those that stand. */
	readonly parent: Int32Array;
	/** 3 × count, metres. */
	readonly at: Float32Array;
	readonly scale: Float32Array;
	/** Of its x axis, degrees from +x to +z. */
	readonly turn: Float32Array;
	/** `width` × count: what was drawn for the settings of its kind, in their order. */
	readonly values: Float32Array;
	readonly width: number;
	/** 16 × count. */
	readonly surroundings: Float32Array;
	/** 8 × count: place, rotation as a unit quaternion x y z w, scale. */
	readonly transforms: Float32Array;
}

export interface StandPlant extends Plant {
	readonly kinds: readonly Kind[];
	readonly places: Places;
	/** Metres. */
	readonly ground: { readonly width: number; readonly depth: number; readonly relief: number };
	/** What lies on the ground, where it was grown with meshes. */
	readonly soil?: Soil;
	/** Of each plant the member that it is: those of one seed are one. */
	readonly memberOf: Uint32Array;
	/** What grows there, as far as it has grown. */
	readonly members: readonly (Member | undefined)[];
}

/** The stand is there all the same, but elsewhere its link has another ground. */
const BARE =
	"What lays soil over the ground could not be fetched: the ground is of one colour and ends at a straight edge.";

export function readStand(answer: Answer): StandPlant {
	const { columns } = answer;
	const [width, depth, relief] = columns.floats("ground.size");
	const plant = readPlant(answer);
	const kinds = readKinds(columns);
	const kind = columns.uint32("plants.kind");
	const places: Places = {
		count: kind.length,
		kind,
		seed: columns.uint32("plants.seed"),
		parent: columns.ints("plants.bearer"),
		at: columns.floats("plants.at"),
		scale: columns.floats("plants.scale"),
		turn: columns.floats("plants.turn"),
		values: columns.floats("plants.values"),
		width: columns.width("plants.values"),
		surroundings: columns.floats("plants.surroundings"),
		transforms: plant.organs.transforms,
	};
	const [mesh] = plant.meshes;
	const soil = mesh && fetchedSoil()?.(mesh);
	return {
		...plant,
		...(soil ? { soil } : {}),
		notes: mesh && !soil ? [...plant.notes, BARE] : plant.notes,
		// Placements are told as plants.
		organs: EMPTY_PLANT.organs,
		kinds,
		places,
		ground: { width, depth, relief },
		memberOf: membersOf(kinds, places),
		members: [],
	};
}

function readKinds(columns: Columns): Kind[] {
	const crown = columns.floats("kinds.crown");
	const places = columns.uint32("kinds.place");
	const seeds = columns.uint32("kinds.seeds");
	// Empty lines mean something here, and in what is set.
	const spots = columns.text("kinds.spot").split("\n");
	const settings = readSettings(columns);
	return columns.lines("kinds.names").map((name, i) => {
		const slash = name.indexOf("/");
		return {
			name,
			model: name.slice(0, slash),
			preset: name.slice(slash + 1),
			place: placeAt(places, i),
			seeds: seeds[i],
			spot: spots[i],
			crown: { width: crown[2 * i], height: crown[2 * i + 1] },
			settings: settings.filter(({ kind }) => kind === i),
		};
	});
}

function readSettings(columns: Columns): (Setting & { kind: number })[] {
	const keys = columns.lines("settings.keys");
	const words = columns.text("settings.words").split("\n");
	const kinds = columns.uint32("settings.kind");
	const places = columns.uint32("settings.place");
	return keys.map((key, i) => ({ key, word: words[i], kind: kinds[i], place: placeAt(places, i) }));
}

const placeAt = (places: Uint32Array, i: number): TextPosition => ({ line: places[2 * i], column: places[2 * i + 1] });

/** A member is told by its line and its seed, where the line says how many seeds there are; else each plant is one. */
function membersOf(kinds: readonly Kind[], { count, kind, seed }: Places): Uint32Array {
	const known = new Map<string, number>();
	let members = 0;
	return Uint32Array.from({ length: count }, (_, plant) => {
		if (kinds[kind[plant]].seeds === 0) return members++;
		const key = `${kind[plant]} ${seed[plant]}`;
		const member = known.get(key) ?? members++;
		known.set(key, member);
		return member;
	});
}
