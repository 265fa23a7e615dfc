import { translatedTable } from "../../specimen/translated_tables";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** Parameters of a stand that are not in its plan, and measures. */
export const STAND_TABLE = translatedTable("stand", PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
