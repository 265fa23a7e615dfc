import { translatedTable } from "../../specimen/translated_tables";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** The bunch's parameters and measures. */
export const BUNCH_TABLE = translatedTable("bunch", PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
