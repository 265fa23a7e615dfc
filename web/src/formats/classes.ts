/** Classes of descriptors (OIV) for files: of measures, and of the look. */
import type { Plant } from "../plant/plant";
import { classOf, type Descriptor, type MeasureClass } from "../specimen/measures";
import type { Specimen } from "../specimen/specimen";
import type { Table } from "../specimen/table";
import { measureValues } from "./measures";

/** The class of one descriptor in a file. */
export interface WrittenClass {
	/** Code of the OIV's descriptor. */
	readonly oiv: number;
	/** The number of the class. */
	readonly class: number;
	/** The class in words. */
	readonly words: string;
}

/** The part of a model that classes need. */
export interface Classing<S extends Specimen> {
	readonly table: Pick<Table, "measures">;
	readonly descriptors?: readonly Descriptor<S>[];
}

/** Descriptors of a model in the order of files: of its measures, then of the look. */
export function descriptorsOf<S extends Specimen>({
	table,
	descriptors = [],
}: Classing<S>): { key: string; oiv: number }[] {
	const measured = table.measures.flatMap(({ key, oiv, classes }) =>
		oiv === undefined || !classes ? [] : [{ key, oiv }],
	);
	return [...measured, ...descriptors.map(({ key, oiv }) => ({ key, oiv }))];
}

/**
 * Returns the classes by the keys of their measures, without those that do not apply; empty where measures were not
 * requested.
 */
export function classesOf<S extends Specimen>(
	{ table, descriptors = [] }: Classing<S>,
	plant: Pick<Plant, "measures">,
	specimen: S,
): Record<string, WrittenClass> {
	if (!plant.measures) return {};
	const measured = measureValues(table, plant).map(([info, value]) => {
		const { key, oiv } = info;
		return [key, oiv, classOf(info, value ?? Number.NaN)] as const;
	});
	const looks = descriptors.map(({ key, oiv, classOf }) => [key, oiv, classOf(specimen)] as const);
	return Object.fromEntries(
		[...measured, ...looks].flatMap(([key, oiv, found]) =>
			oiv !== undefined && found ? [[key, written(oiv, found)]] : [],
		),
	);
}

/** Returns a class as files have it. */
const written = (oiv: number, { note, words }: MeasureClass): WrittenClass => ({ oiv, class: note, words });
