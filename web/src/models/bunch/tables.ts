/**
 * Tables of a bunch for spreadsheets and data frames: berries, measures. Need no meshes. docs/export.md describes the
 * columns.
 */
import { type CsvValue, writeCsv } from "../../formats/csv";
import { measureValues } from "../../formats/measures";
import { rounded } from "../../formats/numbers";
import { classOf } from "../../specimen/measures";
import type { BunchPlant } from "./bunch_plant";
import { SKIN, skinClass } from "./measures";
import type { BunchSpecimen as Specimen } from "./specimen";
import { BUNCH_TABLE } from "./table";
import { traitOf } from "./traits";

/** Millimetres to the micrometre. */
const MM_DECIMALS = 3;
const SHARE_DECIMALS = 4;
const MM = 1000;

/** Columns: name, and value for a berry. */
const BERRY_COLUMNS: readonly (readonly [name: string, cell: (grown: BunchPlant, index: number) => CsvValue])[] = [
	["berry", (_, i) => i + 1],
	["id", ({ berries }, i) => berries.ids[i]],
	["x_mm", (grown, i) => millimetres(grown.berries.spheres[4 * i])],
	["y_mm", (grown, i) => millimetres(grown.berries.spheres[4 * i + 1])],
	["z_mm", (grown, i) => millimetres(grown.berries.spheres[4 * i + 2])],
	["width_mm", ({ berries }, i) => millimetres(traitOf(berries, i, "width"))],
	["length_mm", ({ berries }, i) => millimetres(traitOf(berries, i, "length"))],
	["radius_mm", ({ berries }, i) => millimetres(berries.spheres[4 * i + 3])],
	["volume_mm3", ({ berries }, i) => rounded((4 / 3) * Math.PI * (MM * berries.spheres[4 * i + 3]) ** 3, 1)],
	["direction_x", (grown, i) => directionCell(grown, i, 0)],
	["direction_y", (grown, i) => directionCell(grown, i, 1)],
	["direction_z", (grown, i) => directionCell(grown, i, 2)],
	["exposure", shareCell("exposure")],
	["turned", shareCell("turned")],
	["opened", shareCell("opened")],
	["set", shareCell("set")],
	["shrivel", shareCell("shrivel")],
	["seeds", shareCell("seeds")],
	["axis", ({ berries, internodes }, i) => internodes.axis[berries.parent[i]]],
	["pedicel", ({ berries }, i) => berries.parent[i]],
	["pedicel_length_mm", pedicelLength],
];

/** Writes one row per berry, in order of growth; each row names its bunch, so that tables can be concatenated. */
export function berriesCsv(grown: BunchPlant, { preset, seed }: Specimen): string {
	const rows = Array.from({ length: grown.berries.count }, (_, i) => [
		preset,
		seed,
		...BERRY_COLUMNS.map(([, cell]) => cell(grown, i)),
	]);
	return writeCsv([["preset", "seed", ...BERRY_COLUMNS.map(([name]) => name)], ...rows]);
}

/**
 * Writes one row per measure, and one for the skin's colour; none if there are no measures. A value that does not
 * apply is empty.
 */
export function measuresCsv(grown: BunchPlant, { preset, seed, look }: Specimen): string {
	const rows = measureValues(BUNCH_TABLE, grown).map(([info, value]): CsvValue[] => {
		const { key, label, kind, unit, oiv = null } = info;
		const classFound = classOf(info, value ?? Number.NaN);
		const unitCell = kind === "share" ? "1" : unit;
		return [preset, seed, key, label, value, unitCell, oiv, classFound?.note ?? null, classFound?.words ?? null];
	});
	if (rows.length > 0) {
		const { key, label, oiv } = SKIN;
		const { note, words } = skinClass(look);
		rows.push([preset, seed, key, label, note, "", oiv, note, words]);
	}
	return writeCsv([["preset", "seed", "key", "measure", "value", "unit", "oiv", "class", "class_words"], ...rows]);
}

/** Converts metres to millimetres, rounded to micrometres. */
function millimetres(metres: number): number {
	return rounded(MM * metres, MM_DECIMALS);
}

/** Returns one component of a berry's direction, rounded; axis 0, 1, 2 is x, y, z. */
function directionCell({ berries }: BunchPlant, index: number, axis: number): number {
	return rounded(berries.directions[3 * index + axis], SHARE_DECIMALS);
}

/** Returns the function of a column: it returns a trait of a berry, rounded for the table. */
function shareCell(trait: Parameters<typeof traitOf>[2]) {
	return ({ berries }: BunchPlant, index: number): number => rounded(traitOf(berries, index, trait), SHARE_DECIMALS);
}

/** Returns the length of a berry's pedicel, millimetres. */
function pedicelLength({ berries, internodes }: BunchPlant, index: number): number {
	const [ax, ay, az, bx, by, bz] = internodes.ends.subarray(6 * berries.parent[index], 6 * berries.parent[index] + 6);
	return millimetres(Math.hypot(bx - ax, by - ay, bz - az));
}
