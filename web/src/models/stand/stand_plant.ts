/** Reads a stand from the columns of a response (wasm-core/src/models/stand/model.hpp). */

import type { Columns } from "../../core/container";
import type { Answer } from "../../core/core";
import { EMPTY_PLANT, type Plant } from "../../plant/plant";
import { readPlant } from "../../plant/read_plant";
import type { Member, TextPosition } from "../model";
import { fetchedSoil } from "./fetched_soil";
import { text } from "./messages.generated";
import type { Soil } from "./soil";

/** A parameter that a line of the plan sets. */
export interface Setting {
	readonly key: string;
	/** The option; empty for a number that is drawn for each plant. */
	readonly word: string;
	readonly place: TextPosition;
}

/** A kind of plant: a line of the plan. */
export interface PlantKind {
	/** `growth/oak`. */
	readonly name: string;
	readonly model: string;
	readonly preset: string;
	readonly place: TextPosition;
	/** Number of different specimens; 0: one per plant. */
	readonly seeds: number;
	/** Tag of the parent's organs at which the kind hangs; empty where the plan gives positions. */
	readonly spot: string;
	/** Size of the crown at scale 1, metres. */
	readonly crown: { readonly width: number; readonly height: number };
	readonly settings: readonly Setting[];
}

/** Placements of plants, one element per plant; attached plants come after all others. */
export interface Places {
	readonly count: number;
	readonly kind: Uint32Array;
	readonly seed: Uint32Array;
	/** Index of the plant that each one is attached to; −1 for plants on the ground. */
	readonly parent: Int32Array;
	/** Positions, 3 × count, metres. */
	readonly at: Float32Array;
	readonly scale: Float32Array;
	/** Directions of the x axes, degrees from +x to +z. */
	readonly turn: Float32Array;
	/** `width` × count: values drawn for the settings of the plant's kind, in their order. */
	readonly values: Float32Array;
	readonly width: number;
	/** Surroundings, 16 × count (specimen/surroundings.ts). */
	readonly surroundings: Float32Array;
	/** 8 × count: position, rotation as a unit quaternion x y z w, scale. */
	readonly transforms: Float32Array;
}

export interface StandPlant extends Plant {
	readonly kinds: readonly PlantKind[];
	readonly places: Places;
	/** Size of the ground, metres. */
	readonly ground: { readonly width: number; readonly depth: number; readonly relief: number };
	/** Soil for display, where the stand was grown with meshes. */
	readonly soil?: Soil;
	/** Index of each plant's member; plants of one kind and seed share a member. */
	readonly memberOf: Uint32Array;
	/** Members; undefined those that have not grown yet. */
	readonly members: readonly (Member | undefined)[];
}

/** Reads the answer of the core: kinds of plants, places and the ground. */
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
		notes: mesh && !soil ? [...plant.notes, text("no_soil")] : plant.notes,
		// Plants take the place of organs.
		organs: EMPTY_PLANT.organs,
		kinds,
		places,
		ground: { width, depth, relief },
		memberOf: membersOf(kinds, places),
		members: [],
	};
}

/** Reads the kinds of plants, each with its line in the plan. */
function readKinds(columns: Columns): PlantKind[] {
	const crown = columns.floats("kinds.crown");
	const places = columns.uint32("kinds.place");
	const seeds = columns.uint32("kinds.seeds");
	// Empty lines are significant here and in the settings.
	const spots = columns.text("kinds.spot").split("\n");
	const settings = readSettings(columns);
	return columns.lines("kinds.names").map((name, i) => {
		const slash = name.indexOf("/");
		return {
			name,
			model: name.slice(0, slash),
			preset: name.slice(slash + 1),
			place: textPositionAt(places, i),
			seeds: seeds[i],
			spot: spots[i],
			crown: { width: crown[2 * i], height: crown[2 * i + 1] },
			settings: settings.filter(({ kind }) => kind === i),
		};
	});
}

/** Reads the settings of all kinds, each with the index of its kind. */
function readSettings(columns: Columns): (Setting & { kind: number })[] {
	const keys = columns.lines("settings.keys");
	const words = columns.text("settings.words").split("\n");
	const kinds = columns.uint32("settings.kind");
	const places = columns.uint32("settings.place");
	return keys.map((key, i) => ({ key, word: words[i], kind: kinds[i], place: textPositionAt(places, i) }));
}

/**
 * Returns line and column of element `i`.
 * @param places 2 numbers for each element
 */
const textPositionAt = (places: Uint32Array, i: number): TextPosition => ({
	line: places[2 * i],
	column: places[2 * i + 1],
});

/**
 * Returns the index of each plant's member. A member is a specimen that is grown once and drawn at each plant that has
 * it. Plants of one kind and seed share a member where the plan's line limits the number of seeds; without a limit
 * (`seeds` is 0) each plant has a member of its own.
 */
function membersOf(kinds: readonly PlantKind[], { count, kind, seed }: Places): Uint32Array {
	const memberByKey = new Map<string, number>();
	let members = 0;
	return Uint32Array.from({ length: count }, (_, plant) => {
		if (kinds[kind[plant]].seeds === 0) return members++;
		const key = `${kind[plant]} ${seed[plant]}`;
		const member = memberByKey.get(key) ?? members++;
		memberByKey.set(key, member);
		return member;
	});
}
