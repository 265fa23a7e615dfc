import { translatedTable } from "../../specimen/translated_tables";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** Parameters of a flower that its grammar does not define, and its measures. */
export const FLOWER_TABLE = translatedTable("flower", PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
