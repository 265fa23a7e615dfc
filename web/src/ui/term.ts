import { html } from "lit";
import { symbol } from "./symbol";

/** Draws an item of a description list: a label, the paper's symbol if there is one, a value. */
export function term(label: string, value: unknown, sign = ""): unknown {
	return html`<dt>${label}${symbol(sign)}</dt><dd>${value}</dd>`;
}
