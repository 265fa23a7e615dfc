import { Table } from "../../specimen/table";
import { GROUPS, PARAMETERS } from "./parameters.generated";

/** How any grammar is drawn. */
export const GRAMMAR_TABLE = new Table(PARAMETERS, GROUPS);
