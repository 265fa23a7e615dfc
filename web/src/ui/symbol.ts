import { html, nothing } from "lit";

/**
 * Draws a symbol as in the paper: `α_y`, `w₃` and `b min` in italics, with the rest as a subscript. Decorative: the
 * label beside it has the same meaning.
 */
export function symbol(text: string): unknown {
	if (text === "") return nothing;
	const whole = lowerDigits(text);
	const mark = whole.search(/[_ ]./);
	const [base, index] = mark < 0 ? [whole, ""] : [whole.slice(0, mark), whole.slice(mark + 1)];
	return html`<i class="symbol" aria-hidden="true">${base}${index ? html`<sub>${index}</sub>` : nothing}</i>`;
}

/** Writes `w₃` as `w_3`, because the page's font has no subscript digits. */
function lowerDigits(text: string): string {
	return text.replace(/[₀-₉]/g, (digit) => `_${digit.charCodeAt(0) - "₀".charCodeAt(0)}`);
}
