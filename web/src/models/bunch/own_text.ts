/** Notes on a bunch that a custom text grows; the core treats custom and built-in texts alike. */
import { procedureOf } from "./schema";
import type { BunchSpecimen } from "./specimen";

export function ownTextNotes(specimen: BunchSpecimen): string[] {
	const { grammar, parameters } = specimen;
	if (grammar === undefined || procedureOf(specimen) !== "natural" || !(parameters.peduncle > 0)) return [];
	return ["The stalk above the bunch is not the grammar's: Peduncle says how long it is, and 0 takes it away."];
}
