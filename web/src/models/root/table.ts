import { translatedTable } from "../../specimen/translated_tables";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** Parameters and measures of the root. */
export const ROOT_TABLE = translatedTable("root", PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
