import { Table } from "../../specimen/table";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** What a plan does not say of its stand, and what is measured of it. */
export const STAND_TABLE = new Table(PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
