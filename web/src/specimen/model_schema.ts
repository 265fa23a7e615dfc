/** What a specimen is a specimen of: the document's side of a model (models/model.ts). Plain data and pure functions. */
import type { OwnLengths } from "./lengths";
import type { Notes } from "./notes";
import type { Presets } from "./presets";
import type { Specimen } from "./specimen";
import type { Table } from "./table";

/**
 * Something that a specimen holds beyond the table's parameters: berries taken off, a grammar's text, an outline. One
 * that several models share is in this folder; what is one model's own is in models/<model>/details/.
 */
export interface Field<S extends Specimen = Specimen> {
	/** Keys by which links and files bring it. */
	readonly keys: readonly string[];
	/** Those of them that a person may set, as the command line's help writes them: `thin=ID.ID.…`. */
	readonly settings?: readonly string[];
	/** The field of a written specimen whose own fields are such keys, where there is one: `inputs`. */
	readonly group?: string;
	/** The option that must hold for it to be heeded, as in the table. */
	readonly where?: Readonly<Record<string, string>>;
	/** What a fresh specimen has of it. A new object every time. */
	fresh?(): Partial<S>;
	/** Reads one of the keys into a specimen that may be written to. What cannot be used is noted, never thrown. */
	read?(specimen: S, key: string, value: unknown, notes: Notes): void;
	/** What to read where someone sets names that neither the table nor a detail knows: those of a text's own. */
	named?(specimen: S, values: Readonly<Record<string, string>>): Readonly<Record<string, unknown>>;
	/**
	 * The first of such names that a specimen's text does not know, and what to say of it; undefined where it knows all.
	 * @param asked those that are meant; all that the specimen has where absent
	 */
	stranger?(
		specimen: S,
		asked?: readonly string[],
	): Promise<{ readonly name: string; readonly problem: string } | undefined>;
	/** Whether a grammar's text that came without a model's name is for this one: no other model's text is claimed. */
	claims?(text: string): boolean;
	/** Whether it takes the texts that no model claims. */
	readonly takesAny?: true;
	/** Once everything has been read: makes what was read fit together, and notes what did not. */
	agree?(specimen: S, notes: Notes): void;
	/** What a link's query says of it, in order; nothing where it is as in the preset. */
	query?(specimen: S, preset: S): readonly (readonly [key: string, value: string])[];
	/** Where no link holds it. */
	readonly unlinked?: Unlinked<S>;
	/** A text that a link carries packed in its fragment. */
	readonly packed?: Packed<S>;
	/** What a change that a control made to some parameters does to others. `parameters` may be written to. */
	push?(parameters: S["parameters"], changed: Readonly<Partial<Record<string, number>>>): void;
}

/** Something too long for links. */
export interface Unlinked<S extends Specimen = Specimen> {
	/** How to keep what the specimen has of it: a sentence for who copies the link; undefined where it has none, or its preset's. */
	keep(specimen: S, preset: S): string | undefined;
	/** Notes of a specimen out of a link that it would have some. */
	missing(specimen: S, notes: Notes): void;
}

/** A text in a link's fragment (compressed_text.ts). */
export interface Packed<S extends Specimen = Specimen> {
	/** Its key after the `#`. */
	readonly link: string;
	/** Its key everywhere else, and in notes. */
	readonly key: string;
	/** Bytes of UTF-8 at which unpacking stops. */
	readonly longest: number;
	/** What is used where it cannot be read: "the built-in grammar is used". */
	readonly otherwise: string;
	/** A link carries it where the preset's is another. */
	textOf(specimen: S): string | undefined;
}

/** The table, the presets and the details of one model. */
export interface ModelSchema<S extends Specimen = Specimen> {
	/** As links and files write it: `bunch`. */
	readonly name: string;
	/** Whether a link means it that names no model. */
	readonly unnamed?: boolean;
	readonly table: Table;
	readonly presets: Presets;
	readonly details: readonly Field<S>[];
	/** Units of its own that some of its parameters are lengths in, where there are such. */
	lengths?(specimen: S): OwnLengths;
}
