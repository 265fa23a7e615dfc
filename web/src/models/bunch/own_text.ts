/** Notes on a bunch that a custom text grows; the core treats custom and built-in texts alike. */
import { text } from "./messages.generated";
import { procedureOf } from "./schema";
import type { BunchSpecimen } from "./specimen";

/** Returns a note where a bunch has a text of its own, which the parameter of the stalk's length does not affect. */
export function ownTextNotes(specimen: BunchSpecimen): string[] {
	const { grammar, parameters } = specimen;
	if (grammar === undefined || procedureOf(specimen) !== "natural" || !(parameters.peduncle > 0)) return [];
	return [text("stalk_not_from_grammar")];
}
