import { translatedTable } from "../../specimen/translated_tables";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** Parameters and measures of the leaf. */
export const LEAF_TABLE = translatedTable("leaf", PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
