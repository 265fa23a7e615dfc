/** Where a model's grammars come from, and what a change of one writes into the document. */
import type { Plant } from "../../plant/plant";
import type { WithGrammar } from "../../specimen/grammar_text";
import type { Specimen } from "../../specimen/specimen";
import type { Change, Desk } from "../desk";
import type { Dialect } from "./dialect";

/** What the editor of grammars has to know of a model. */
export interface GrammarSource<S extends Specimen & WithGrammar = Specimen & WithGrammar> {
	/** What sentences call a plant of it: "bunch". */
	readonly noun: string;
	/** The group of the panel that says so where a plant has a grammar of its own; absent: one at the panel's end, for hands write texts. */
	readonly group?: string;
	/**
	 * The text by which a document grows that has none of its own. One that has yet to be fetched is promised: once the promise is
	 * kept, this gives it.
	 */
	builtIn(specimen: S): string | Promise<unknown>;
	/** The language of its texts; that of L-systems where absent. */
	readonly dialect?: Dialect;
	/** The names that `#role` takes. */
	readonly roles?: readonly string[];
	/** Whether its texts have constants; absent: they have. */
	readonly constants?: false;
	/** Whether constants have their sliders before the text is the plant's own. */
	readonly always?: boolean;
	/** Constants that parameters of the table stand for: they have their sliders already. */
	readonly governed?: ReadonlySet<string>;
	/** What a plant lacks of what its text asks for, a line each: said below the text. */
	warnings?(grown: Plant, specimen: S): readonly string[];
	/** What a text of its own changes in the document; its `grammar` where absent. */
	details?(text: string | undefined, specimen: S): NonNullable<Change["details"]>;
}

/** The text that a document grows by; undefined while it is fetched, and then `later` is called once it is there. */
export function textOf(source: GrammarSource, specimen: Specimen & WithGrammar, later: () => void): string | undefined {
	if (specimen.grammar !== undefined) return specimen.grammar;
	const text = source.builtIn(specimen);
	if (typeof text === "string") return text;
	text.then(later, () => {}); // Who grows it says why it did not come.
	return undefined;
}

/** Whether a document has a text of its own. */
export function isOwn({ grammar }: WithGrammar): boolean {
	return grammar !== undefined;
}

/** The change that makes a text the document's: one that is the built-in one is none of its own. */
export function withText(source: GrammarSource, specimen: Specimen & WithGrammar, text: string | undefined): Change {
	const own = text === undefined || text === source.builtIn(specimen) ? undefined : text;
	return { details: source.details?.(own, specimen) ?? { grammar: own } };
}

/** What all of the studio that has to do with grammars is given. */
export type GrammarDesk = Desk<Specimen & WithGrammar>;
