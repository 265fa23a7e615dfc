import type { NumberKey } from "../models/bunch/parameters.generated";
import type { Specimen } from "./specimen";
import { CORE_ENTRIES, writtenIn } from "./table";

/** A specimen as files hold it: choices by the names of their options. */
export type WrittenSpecimen = Omit<Specimen, "parameters"> & { parameters: Record<NumberKey, number | string> };

/** What goes into JSON and glTF; `restore` brings it back as it was. */
export function writtenSpecimen(specimen: Specimen): WrittenSpecimen {
	const parameters = Object.fromEntries(CORE_ENTRIES.map((entry) => [entry.key, writtenIn(specimen, entry)]));
	return { ...specimen, parameters: parameters as Record<NumberKey, number | string> };
}
