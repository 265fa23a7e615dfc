import { Table } from "../../specimen/table";
import { MEASURE_GROUPS, MEASURES } from "./measures.generated";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** What a flower's grammar does not say of it, and what is measured of it. */
export const FLOWER_TABLE = new Table(PARAMETERS, GROUPS, MEASURES, MEASURE_GROUPS);
