import { translatedTable } from "../../specimen/translated_tables";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** Parameters and measures of the tree. */
export const TREE_TABLE = translatedTable("tree", PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
