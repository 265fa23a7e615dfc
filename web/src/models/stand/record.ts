/** Records of a stand for the JSON document and for tables: one per plant. */
import { type CsvValue, writeCsv } from "../../formats/csv";
import { shortFloat } from "../../formats/numbers";
import type { Member } from "../model";
import { valuesOf } from "./members";
import type { StandSpecimen } from "./specimen";
import type { StandPlant } from "./stand_plant";

/** A plant of a stand. */
export interface PlantRecord {
	model: string;
	preset: string;
	seed: number;
	/** Position, metres. */
	x: number;
	y: number;
	z: number;
	scale: number;
	/** Direction of its x axis, degrees from +x to +z. */
	turn: number;
	/** Settings that differ from the preset, by key. */
	values: Record<string, number | string>;
	/** Index of the plant that this one is attached to; absent where there is none. */
	bearer?: number;
	/** 16 hexadecimal digits; absent before the plant has grown. */
	fingerprint?: string;
	/** Query and fragment that grow the plant alone, with its surroundings; absent before it has grown. */
	link?: string;
}

/** Returns the record of a stand for the JSON document: the ground's size and all plants. */
export function standRecord(stand: StandPlant): {
	ground: StandPlant["ground"];
	plants: PlantRecord[];
} {
	return { ground: stand.ground, plants: plantRecords(stand) };
}

/**
 * Returns one record per plant: where and how it is placed, the member that it shows, and in `bearer` the index of the
 * plant that it is attached to.
 */
function plantRecords(stand: StandPlant): PlantRecord[] {
	const { kinds, places, memberOf, members } = stand;
	return Array.from({ length: places.count }, (_, plant) => {
		const { model, preset } = kinds[places.kind[plant]];
		const [x, y, z] = [...places.at.subarray(3 * plant, 3 * plant + 3)].map(shortFloat);
		const member = members[memberOf[plant]];
		const { fingerprint, link } = member ?? {};
		const parent = places.parent[plant];
		return {
			model,
			preset,
			seed: places.seed[plant],
			x,
			y,
			z,
			scale: shortFloat(places.scale[plant]),
			turn: shortFloat(places.turn[plant]),
			values: usedValues(valuesOf(stand, plant), member),
			...(parent >= 0 ? { bearer: parent } : {}),
			...(fingerprint === undefined ? {} : { fingerprint, link }),
		};
	});
}

/**
 * Replaces drawn values by those that the plant uses: rounded to integers where required and limited to their ranges.
 */
function usedValues(values: PlantRecord["values"], member: Member | undefined): PlantRecord["values"] {
	const parameters: Readonly<Record<string, unknown>> = member?.specimen.parameters ?? {};
	const each = ([key, value]: [string, number | string]) => {
		const used = parameters[key];
		return [key, typeof value === "number" && typeof used === "number" ? used : value];
	};
	return Object.fromEntries(Object.entries(values).map(each));
}

/** Writes a table with one row per plant; each row names the stand, so that tables can be concatenated. */
export function placementsCsv(stand: StandPlant, { preset: plan, seed: standSeed }: StandSpecimen): string {
	const keys = [...new Set(stand.kinds.flatMap(({ settings }) => settings.map(({ key }) => key)))];
	const header = [
		...["stand", "stand_seed", "plant", "model", "preset", "seed", "x_m", "y_m", "z_m", "scale", "turn_deg", "bearer"],
		...keys,
		"fingerprint",
	];
	const rows = plantRecords(stand).map((each, i): CsvValue[] => [
		...[plan, standSeed, i, each.model, each.preset, each.seed, each.x, each.y, each.z, each.scale, each.turn],
		each.bearer ?? null,
		...keys.map((key) => (Object.hasOwn(each.values, key) ? each.values[key] : null)),
		each.fingerprint ?? null,
	]);
	return writeCsv([header, ...rows]);
}
