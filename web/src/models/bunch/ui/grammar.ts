import type { GrammarSource } from "../../../grammar_editor/source";
import { INTERNODE_KINDS } from "../bunch_plant";
import { BUILT_IN } from "../request";
import { procedureOf } from "../schema";
import type { BunchSpecimen } from "../specimen";
import { BUNCH_TABLE } from "../table";

/** Source of a bunch's text for the editor, one for each procedure. */
export const grammar: GrammarSource<BunchSpecimen> = {
	plantName: "bunch",
	group: "branching",
	builtIn: (specimen) => BUILT_IN[procedureOf(specimen)],
	roles: INTERNODE_KINDS,
	governed: new Set(BUNCH_TABLE.core.flatMap(({ define }) => define ?? [])),
};
