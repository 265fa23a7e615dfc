/**
 * The schema of a model's specimens: the document's side of a model (models/model.ts). Plain data and pure functions.
 */
import type { Message } from "../locale/texts";
import type { OwnLengths } from "./lengths";
import type { Notes } from "./notes";
import type { Presets } from "./presets";
import type { Specimen } from "./specimen";
import type { Table } from "./table";

/**
 * A field of a specimen beyond the table's parameters: removed berries, a grammar's text, an outline. Fields of several
 * models are in this folder; those of one model are in models/<model>/details/.
 */
export interface Field<S extends Specimen = Specimen> {
	/** Keys of the field in links and files. */
	readonly keys: readonly string[];
	/** Those of them that a user may set, as the command line's help writes them: `thin=ID.ID.…`. */
	readonly settings?: readonly string[];
	/** The object in a written specimen whose keys are those of this field: `inputs`. */
	readonly group?: string;
	/** Options of choices that must be chosen for the field to apply, as in the table. */
	readonly where?: Readonly<Record<string, string>>;
	/** The field's value in a fresh specimen: a new object every time. */
	fresh?(): Partial<S>;
	/** Reads one of the keys into a specimen that may be written to. Notes unusable values, never throws. */
	read?(specimen: S, key: string, value: unknown, notes: Notes): void;
	/** Reads values of names that neither the table nor a field knows: those of the text's own. */
	named?(specimen: S, values: Readonly<Record<string, string>>): Readonly<Record<string, unknown>>;
	/** All such names that a specimen's text defines. */
	names?(specimen: S): Promise<readonly string[]>;
	/**
	 * The first such name that a specimen's text does not define, with the problem; undefined where it defines all.
	 * @param names names to check; all names in the specimen where absent
	 */
	unknownName?(
		specimen: S,
		names?: readonly string[],
	): Promise<{ readonly name: string; readonly problem: Message } | undefined>;
	/** Whether a grammar's text without a model's name is for this model; at most one model claims a text. */
	claims?(text: string): boolean;
	/** Whether the model takes texts that no model claims. */
	readonly takesAny?: true;
	/** Makes the values fit together once everything has been read, and notes those that did not fit. */
	agree?(specimen: S, notes: Notes): void;
	/** Entries of a link's query, in order; none where the value is that of the preset. */
	query?(specimen: S, preset: S): readonly (readonly [key: string, value: string])[];
	/** For values that no link can hold. */
	readonly unlinked?: Unlinked<S>;
	/** A text that a link carries packed in its fragment. */
	readonly packed?: Packed<S>;
	/** Adjusts parameters to a control's change of others. `parameters` may be written to. */
	push?(parameters: S["parameters"], changed: Readonly<Partial<Record<string, number>>>): void;
}

/** A value too long for links. */
export interface Unlinked<S extends Specimen = Specimen> {
	/**
	 * Explains in a sentence how to save the specimen's value, for users that copy the link; undefined where it has
	 * none, or the preset's.
	 */
	keep(specimen: S, preset: S): string | undefined;
	/** Adds a note to a specimen from a link that lost such a value. */
	missing(specimen: S, notes: Notes): void;
}

/** A text in a link's fragment (compressed_text.ts). */
export interface Packed<S extends Specimen = Specimen> {
	/** Its key after the `#`. */
	readonly link: string;
	/** Its key in files and notes. */
	readonly key: string;
	/** Bytes of UTF-8 at which expansion stops. */
	readonly longest: number;
	/** A sentence on the outcome where the text cannot be read: "The built-in grammar is used." */
	readonly otherwise: string;
	/** The text that a link carries where the preset has another. */
	textOf(specimen: S): string | undefined;
}

/** The table, presets and fields of one model. */
export interface ModelSchema<S extends Specimen = Specimen> {
	/** As links and files write it: `bunch`. */
	readonly name: string;
	/** Whether links without a model mean this one. */
	readonly unnamed?: boolean;
	readonly table: Table;
	readonly presets: Presets;
	readonly details: readonly Field<S>[];
	/** Millimetres per unit of lengths in the model's own units, if any. */
	lengths?(specimen: S): OwnLengths;
}
