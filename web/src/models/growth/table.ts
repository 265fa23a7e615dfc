import { Table } from "../../specimen/table";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** Parameters of a tree that its growth grammar does not define, and its measures. */
export const GROWTH_TABLE = new Table(PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
