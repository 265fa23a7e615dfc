/** The document of an element, read from its attributes until a script or a control changes it. */
import type { SpecimenDocument } from "./grown_detail";

/** Reads the attributes when the document is first needed. A reading or a change that failed is forgotten, so that the next call tries again. */
export class CurrentDocument {
	readonly #readAttributes: () => Promise<SpecimenDocument>;
	#current: Promise<SpecimenDocument> | undefined;

	/** @param readAttributes rejects where the script of a model cannot be fetched */
	constructor(readAttributes: () => Promise<SpecimenDocument>) {
		this.#readAttributes = readAttributes;
	}

	/** The document as it is now. Rejects as reading the attributes does. */
	get(): Promise<SpecimenDocument> {
		return this.#current ?? this.#keep(this.#readAttributes());
	}

	/** Changes the document. Rejects as `get` does, and with what `make` throws: the document then stays as it was. */
	change(make: (before: SpecimenDocument) => SpecimenDocument): Promise<SpecimenDocument> {
		const before = this.get();
		return this.#keep(before.then(make), before);
	}

	/** The attributes have changed: they are read again when the document is next needed. */
	forget(): void {
		this.#current = undefined;
	}

	/** @param before the document that is current again where the next one fails */
	#keep(next: Promise<SpecimenDocument>, before?: Promise<SpecimenDocument>): Promise<SpecimenDocument> {
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
