import { Table } from "../../specimen/table";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** The root's parameters and measures. */
export const ROOT_TABLE = new Table(PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
