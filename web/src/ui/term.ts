import { html } from "lit";
import { symbol } from "./symbol";

/** Draws an item of a description list: words, the paper's symbol if there is one, a value. */
export function term(words: string, value: unknown, sign = ""): unknown {
	return html`<dt>${words}${symbol(sign)}</dt><dd>${value}</dd>`;
}
