/** The measures of a growth by their keys. */
import { shortFloat } from "../../export/numbers";
import type { Grown } from "./grown";
import { MEASURES, type MeasureInfo, type MeasureKey } from "./measures.generated";

/** A measure's description and its value: null where it does not apply to this bunch. */
export type MeasureValue = readonly [info: MeasureInfo, value: number | null];

/** Every measure in the order of the table; empty where none were asked for. */
export function measureValues({ measures }: Grown): MeasureValue[] {
	if (!measures) return [];
	return MEASURES.map((info, index) => {
		const value = measures[index] ?? Number.NaN;
		return [info, Number.isFinite(value) ? shortFloat(value) : null];
	});
}

/** What a file says of them: by key. */
export type WrittenMeasures = Partial<Record<MeasureKey, number | null>>;

/** `{ measures }` for a file; nothing where none were asked for. */
export function measuresOf(grown: Grown): { measures?: WrittenMeasures } {
	if (!grown.measures) return {};
	return { measures: Object.fromEntries(measureValues(grown).map(([{ key }, value]) => [key, value])) };
}
