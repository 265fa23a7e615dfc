/** Reads specimens from the page's address, and writes the current one to the address bar once it is at rest. */
import { fromPreset } from "../specimen/from_preset";
import {
	decodeLink,
	decodeQuery,
	encodeLink,
	encodeQuery,
	hasPacked,
	isQueryWhole,
	modelInQuery,
} from "../specimen/link";
import type { ModelSchema } from "../specimen/model_schema";
import type { Restored } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";

type Address = Pick<Location, "search" | "hash">;

/** Returns the name of the model in the address; undefined where it names none. */
export function modelInAddress({ search }: Pick<Location, "search">): string | undefined {
	return modelInQuery(search);
}

/**
 * Reads the specimen in the query, synchronously. `whole` is false where the fragment contains a packed text, which
 * `readWholeAddress` reads.
 */
export function readAddress<S extends Specimen>(
	schema: ModelSchema<S>,
	{ search, hash }: Address,
): Restored<S> & { whole: boolean } {
	return { ...decodeQuery(schema, search), whole: !hasPacked(schema, hash) };
}

/** Reads the specimen in the query and in the fragment, which is unpacked. */
export function readWholeAddress<S extends Specimen>(
	schema: ModelSchema<S>,
	{ search, hash }: Address,
): Promise<Restored<S>> {
	return decodeLink(schema, search, hash);
}

/** Returns the absolute link to a specimen, for copying and for files. */
export async function linkOf<S extends Specimen>(schema: ModelSchema<S>, specimen: S): Promise<string> {
	return `${location.origin}${location.pathname}${await encodeLink(schema, specimen)}`;
}

/** Returns the parts of a specimen that its link cannot contain, a sentence each. */
export function notInLink<S extends Specimen>(schema: ModelSchema<S>, specimen: S): string[] {
	const preset = fromPreset(schema, specimen.preset);
	return schema.details.flatMap(({ unlinked }) => unlinked?.keep(specimen, preset) ?? []);
}

/** Returns whether a fragment contains no specimen's text: an element's id, or any other typed text. */
export function isForeign<S extends Specimen>(schema: ModelSchema<S>, { hash }: Pick<Location, "hash">): boolean {
	return hash.length > 1 && !hasPacked(schema, hash);
}

/**
 * Writes specimens to the address bar. Another preset adds an entry to the browser's history, so that Back returns to
 * the last preset; a change of the same preset replaces the current entry.
 */
export class AddressBar {
	readonly #location: Pick<Location, "search" | "hash" | "pathname">;
	readonly #history: Pick<History, "replaceState" | "pushState">;
	#newest: Specimen | undefined;
	/** Model and preset of the specimen in the address. */
	#origin: string | undefined;

	constructor(
		place: Pick<Location, "search" | "hash" | "pathname"> = location,
		past: Pick<History, "replaceState" | "pushState"> = history,
	) {
		this.#location = place;
		this.#history = past;
	}

	/** Records that the browser has moved to another history entry, whose address holds this specimen. */
	arrived(specimen: Specimen): void {
		this.#origin = originOf(specimen);
	}

	/**
	 * Writes a specimen's link to the address bar: as a new entry of the browser's history if it has another origin
	 * (preset) than the last one, else in place of it.
	 */
	async write<S extends Specimen>(schema: ModelSchema<S>, specimen: S): Promise<void> {
		this.#newest = specimen;
		const fitsQuery = isQueryWhole(schema, specimen);
		const link = fitsQuery ? encodeQuery(schema, specimen) : await encodeLink(schema, specimen);
		// Packing is asynchronous: a newer specimen may have come to rest meanwhile.
		if (this.#newest !== specimen) return;
		const origin = originOf(specimen);
		const isOtherOrigin = this.#origin !== undefined && this.#origin !== origin;
		this.#origin = origin;
		const { search, hash, pathname } = this.#location;
		if (`${search}${hash}` === link) return;
		try {
			if (isOtherOrigin) this.#history.pushState(null, "", `${pathname}${link}`);
			else this.#history.replaceState(null, "", `${pathname}${link}`);
		} catch {
			// Browsers refuse more than about a hundred writes within seconds; the next write succeeds.
		}
	}
}

/** Returns a key of the model and preset of a specimen. */
function originOf({ model, preset }: Specimen): string {
	return `${model} ${preset}`;
}
