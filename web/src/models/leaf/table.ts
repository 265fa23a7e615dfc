import { Table } from "../../specimen/table";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** The leaf's parameters and measures. */
export const LEAF_TABLE = new Table(PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
