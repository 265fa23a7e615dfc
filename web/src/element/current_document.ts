/** Holds the document of an element: read from its attributes, then changed by scripts and controls. */
import type { SpecimenDocument } from "./grown_detail";

/**
 * Reads the attributes when the document is first needed. After a failed reading or change, the next call tries again.
 */
export class CurrentDocument {
	readonly #readAttributes: () => Promise<SpecimenDocument>;
	#current: Promise<SpecimenDocument> | undefined;

	/** @param readAttributes rejects if the script of a model cannot be fetched */
	constructor(readAttributes: () => Promise<SpecimenDocument>) {
		this.#readAttributes = readAttributes;
	}

	/** The current document. Rejects as reading the attributes does. */
	get(): Promise<SpecimenDocument> {
		return this.#current ?? this.#makeCurrent(this.#readAttributes());
	}

	/** Changes the document. Rejects as `get` does, and with errors of `make`: the document then stays as it was. */
	change(make: (before: SpecimenDocument) => SpecimenDocument): Promise<SpecimenDocument> {
		const before = this.get();
		return this.#makeCurrent(before.then(make), before);
	}

	/** Drops the document after a change of attributes, which are read again when needed. */
	forget(): void {
		this.#current = undefined;
	}

	/** Makes a document current. @param before the document to restore if the next one fails */
	#makeCurrent(next: Promise<SpecimenDocument>, before?: Promise<SpecimenDocument>): Promise<SpecimenDocument> {
		this.#current = next;
		next.catch(async () => {
			const isBeforeGood = await before?.then(
				() => true,
				() => false,
			);
			if (this.#current === next) this.#current = isBeforeGood ? before : undefined;
		});
		return next;
	}
}
