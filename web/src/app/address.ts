/** The address bar: always holds the specimen that is at rest. */
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

/** The name of the model that the address says it is of. */
export function modelInAddress({ search }: Pick<Location, "search">): string | undefined {
	return modelInQuery(search);
}

/** What the address says, at once; a text in the fragment has to be unpacked and follows by `readWholeAddress`. */
export function readAddress<S extends Specimen>(
	schema: ModelSchema<S>,
	{ search, hash }: Address,
): Restored<S> & { whole: boolean } {
	return { ...decodeQuery(schema, search), whole: !hasPacked(schema, hash) };
}

/** What the address says, its fragment included. */
export function readWholeAddress<S extends Specimen>(
	schema: ModelSchema<S>,
	{ search, hash }: Address,
): Promise<Restored<S>> {
	return decodeLink(schema, search, hash);
}

/** The whole link, for copying and for files. */
export async function linkOf<S extends Specimen>(schema: ModelSchema<S>, specimen: S): Promise<string> {
	return `${location.origin}${location.pathname}${await encodeLink(schema, specimen)}`;
}

/** What a link does not hold of a specimen, in words. */
export function notInLink<S extends Specimen>(schema: ModelSchema<S>, specimen: S): string[] {
	const preset = fromPreset(schema, specimen.preset);
	return schema.details.flatMap(({ unlinked }) => unlinked?.keep(specimen, preset) ?? []);
}

/** Whether a fragment is none of a specimen's: an element's id, or whatever was typed. */
export function isForeign<S extends Specimen>(schema: ModelSchema<S>, { hash }: Pick<Location, "hash">): boolean {
	return hash.length > 1 && !hasPacked(schema, hash);
}

/**
 * Writes specimens into the address bar. What is of another preset than the address gets an entry of its own in the
 * browser's history, so that Back brings the last preset; whatever is changed of one takes the place of what was there.
 */
export class AddressBar {
	readonly #location: Pick<Location, "search" | "hash" | "pathname">;
	readonly #history: Pick<History, "replaceState" | "pushState">;
	#newest: Specimen | undefined;
	/** What the address is of. */
	#origin: string | undefined;

	constructor(
		place: Pick<Location, "search" | "hash" | "pathname"> = location,
		past: Pick<History, "replaceState" | "pushState"> = history,
	) {
		this.#location = place;
		this.#history = past;
	}

	/** The browser has gone to another entry, which is of this specimen. */
	arrived(specimen: Specimen): void {
		this.#origin = originOf(specimen);
	}

	async write<S extends Specimen>(schema: ModelSchema<S>, specimen: S): Promise<void> {
		this.#newest = specimen;
		const whole = isQueryWhole(schema, specimen);
		const link = whole ? encodeQuery(schema, specimen) : await encodeLink(schema, specimen);
		// Packing a text takes its time: a newer specimen may have come to rest meanwhile.
		if (this.#newest !== specimen) return;
		const origin = originOf(specimen);
		const another = this.#origin !== undefined && this.#origin !== origin;
		this.#origin = origin;
		const { search, hash, pathname } = this.#location;
		if (`${search}${hash}` === link) return;
		try {
			if (another) this.#history.pushState(null, "", `${pathname}${link}`);
			else this.#history.replaceState(null, "", `${pathname}${link}`);
		} catch {
			// Browsers forbid more than some hundred writes in a few seconds; the next one will hold.
		}
	}
}

function originOf({ model, preset }: Specimen): string {
	return `${model} ${preset}`;
}
