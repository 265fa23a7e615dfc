import { translatedTable } from "../../specimen/translated_tables";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** Parameters of how any grammar is drawn, and measures of its plants. */
export const GRAMMAR_TABLE = translatedTable("grammar", PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
