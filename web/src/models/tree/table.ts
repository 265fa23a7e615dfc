import { Table } from "../../specimen/table";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** The tree's parameters and measures. */
export const TREE_TABLE = new Table(PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
