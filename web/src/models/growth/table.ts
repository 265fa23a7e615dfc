import { Table } from "../../specimen/table";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** What a growth grammar does not say of its tree, and what is measured of it. */
export const GROWTH_TABLE = new Table(PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
