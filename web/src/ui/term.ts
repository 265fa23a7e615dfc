import { html } from "lit";
import { symbol } from "./symbol";

/** A line of a list of numbers: words, the paper's symbol if there is one, a value. */
export function term(words: string, value: unknown, sign = ""): unknown {
	return html`<dt>${words}${symbol(sign)}</dt><dd>${value}</dd>`;
}
