import { translatedTable } from "../../specimen/translated_tables";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** Parameters of a tree that its growth grammar does not define, and its measures. */
export const GROWTH_TABLE = translatedTable("growth", PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
