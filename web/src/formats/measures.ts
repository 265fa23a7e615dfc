/** The measures of a plant by their keys. */
import type { Plant } from "../plant/plant";
import type { MeasureInfo } from "../specimen/measures";
import type { Table } from "../specimen/table";
import { shortFloat } from "./numbers";

/** A measure's description and its value: null where it does not apply to this plant. */
export type MeasureValue = readonly [info: MeasureInfo, value: number | null];

/** Returns every measure with its value, in the order of the table; empty where none were requested. */
export function measureValues(table: Pick<Table, "measures">, { measures }: Pick<Plant, "measures">): MeasureValue[] {
	if (!measures) return [];
	return table.measures.map((info, index) => {
		const value = measures[index] ?? Number.NaN;
		return [info, Number.isFinite(value) ? shortFloat(value) : null];
	});
}

/** Measures in a file, by key. */
export type WrittenMeasures = Record<string, number | null>;

/** Returns `{ measures }` for a file; an empty object where none were requested. */
export function measuresOf(
	table: Pick<Table, "measures">,
	grown: Pick<Plant, "measures">,
): { measures?: WrittenMeasures } {
	if (!grown.measures) return {};
	return { measures: Object.fromEntries(measureValues(table, grown).map(([{ key }, value]) => [key, value])) };
}
