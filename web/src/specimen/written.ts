import type { ModelSchema } from "./model_schema";
import type { Specimen } from "./specimen";
import { writtenIn } from "./table";

/** A specimen as files hold it: choices by the names of their options. */
export type WrittenSpecimen<S extends Specimen = Specimen> = Omit<S, "parameters"> & {
	parameters: Record<keyof S["parameters"], number | string>;
};

/** Returns the specimen in JSON and glTF; `restore` turns it back. */
export function writtenSpecimen<S extends Specimen>({ table }: ModelSchema<S>, specimen: S): WrittenSpecimen<S> {
	const parameters = Object.fromEntries(table.core.map((entry) => [entry.key, writtenIn(specimen, entry)]));
	return { ...specimen, parameters: parameters as WrittenSpecimen<S>["parameters"] };
}
