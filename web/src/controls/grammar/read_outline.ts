import { type Outline, outlineOf } from "./outline";
import type { GrammarSource } from "./source";

/** The outline of a text, read again once the text is another. */
export class ReadOutline {
	#read: { text: string; outline: Outline } | undefined;

	of(text: string, { dialect }: Pick<GrammarSource, "dialect">): Outline {
		if (this.#read?.text !== text) this.#read = { text, outline: outlineOf(text, dialect?.scan(text)) };
		return this.#read.outline;
	}
}
