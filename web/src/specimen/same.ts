import type { Specimen } from "./specimen";
import { ENTRIES, valueIn } from "./table";

/** Whether two specimens are the same document, and so have the same link. */
export function sameSpecimen(a: Specimen, b: Specimen): boolean {
	return (
		a === b ||
		(a.preset === b.preset &&
			a.seed === b.seed &&
			a.grammar === b.grammar &&
			a.inputs?.m === b.inputs?.m &&
			a.inputs?.n?.join() === b.inputs?.n?.join() &&
			a.thinned.join() === b.thinned.join() &&
			ENTRIES.every((entry) => valueIn(a, entry) === valueIn(b, entry)))
	);
}
