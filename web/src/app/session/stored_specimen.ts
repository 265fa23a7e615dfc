/**
 * A specimen as the browser stores it: its link, uncompressed, and the fields that no link can hold. Stored data is not
 * trusted: reading gives a complete specimen for any input.
 */

import { fromPreset } from "../../specimen/from_preset";
import { decodeUnpacked, encodeQuery, textsOf } from "../../specimen/link";
import type { ModelSchema } from "../../specimen/model_schema";
import { restore } from "../../specimen/restore";
import type { Specimen } from "../../specimen/specimen";

export interface StoredSpecimen {
	/** The query of its link. */
	readonly query: string;
	/** The long texts of its link, by their keys in the fragment. */
	readonly texts: Readonly<Record<string, string>>;
	/** The fields that no link can hold, as JSON. */
	readonly extra?: string;
}

/** Converts a specimen to its stored form. */
export function storedSpecimen<S extends Specimen>(schema: ModelSchema<S>, specimen: S): StoredSpecimen {
	const extra = extraOf(schema, specimen);
	return {
		query: encodeQuery(schema, specimen),
		texts: Object.fromEntries(textsOf(schema, specimen)),
		...(extra === undefined ? {} : { extra }),
	};
}

/** Reads a specimen from its stored form. */
export function specimenOf<S extends Specimen>(schema: ModelSchema<S>, { query, texts, extra }: StoredSpecimen): S {
	const { specimen } = decodeUnpacked(schema, query, texts);
	return extra === undefined ? specimen : withExtra(schema, specimen, extra);
}

/** Returns the fields of a specimen that its link cannot contain, as JSON; undefined where it contains all. */
export function extraOf<S extends Specimen>(schema: ModelSchema<S>, specimen: S): string | undefined {
	const preset = fromPreset(schema, specimen.preset);
	const fields = schema.details.filter(({ unlinked }) => unlinked?.keep(specimen, preset) !== undefined);
	if (fields.length === 0) return undefined;
	const values = fields.flatMap(({ keys }) => keys.map((key) => [key, Reflect.get(specimen, key)]));
	return JSON.stringify(Object.fromEntries(values));
}

/** Adds the fields of `extraOf` to a specimen from a link; unreadable ones are left out. */
export function withExtra<S extends Specimen>(schema: ModelSchema<S>, specimen: S, extra: string): S {
	try {
		return restore(schema, JSON.parse(extra), specimen).specimen;
	} catch {
		return specimen;
	}
}
