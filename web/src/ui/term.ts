import { html } from "lit";
import { formatNumber } from "../locale/format";
import { symbol } from "./symbol";

/** Draws an item of a description list: a label, the paper's symbol if there is one, a value; numbers are formatted. */
export function term(label: string, value: unknown, sign = ""): unknown {
	return html`<dt>${label}${symbol(sign)}</dt><dd>${typeof value === "number" ? formatNumber(value) : value}</dd>`;
}
