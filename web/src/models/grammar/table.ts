import { Table } from "../../specimen/table";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** How any grammar is drawn, and what is measured of what it grows. */
export const GRAMMAR_TABLE = new Table(PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
