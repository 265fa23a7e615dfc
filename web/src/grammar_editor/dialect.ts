/** A language that grammars are written in, as the editor knows it. */
import { Facet } from "@codemirror/state";
import { scan, type Token } from "./scan";
import { WORDS, type Word } from "./words.generated";

export interface Dialect {
	/** Takes a text to pieces, blanks left out. */
	scan(text: string): Token[];
	/** Words of the language, in addition to the text's own names. */
	readonly words: readonly Word[];
}

/** That of L-systems: docs/language.md. */
export const LSYSTEM: Dialect = { scan, words: WORDS };

/** Language of the edited text; defaults to L-systems. */
export const dialect = Facet.define<Dialect, Dialect>({ combine: ([chosen = LSYSTEM]) => chosen });
