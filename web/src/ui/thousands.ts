import { formatNumber } from "../locale/format";

/**
 * Adds separators to the numbers in a text, "67108864 words" → "67,108,864 words": the core writes numbers without
 * them, for programs.
 */
export function withThousands(text: string): string {
	return text.replace(/[\d.,]+/g, (run) => {
		const [digits] = run.split(/[.,]/, 1);
		// Digits next to a decimal point are not a whole number.
		if (digits.length < 5 || run[digits.length] === ".") return run;
		return formatNumber(Number(digits)) + run.slice(digits.length);
	});
}

/** Formats a count: 10,000. */
export const formatCount = (count: number): string => formatNumber(count);
