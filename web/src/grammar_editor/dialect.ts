/** Languages of grammars. */
import { Facet } from "@codemirror/state";
import { scan, type Token } from "./scan";
import { WORDS, type Word } from "./words.generated";

export interface Dialect {
	/** Splits a text into tokens, without blanks. */
	scan(text: string): Token[];
	/** Words of the language, in addition to the text's own names. */
	readonly words: readonly Word[];
}

/** The language of L-systems: docs/language.md. */
export const LSYSTEM: Dialect = { scan, words: WORDS };

/** Language of the edited text; defaults to L-systems. */
export const dialect = Facet.define<Dialect, Dialect>({ combine: ([chosen = LSYSTEM]) => chosen });
