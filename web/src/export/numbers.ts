/** Numbers as text: as short as exactness allows. */

/** Significant digits: fewer are rarely enough for a float32, nine always are. */
const FEWEST_DIGITS = 6;
const MOST_DIGITS = 9;

/**
 * The shortest decimal that a reader of float32 takes for `value` (itself a float32), as a number; printed by
 * `JSON.stringify` it is that decimal. 0.1f, which is 0.10000000149011612, becomes 0.1.
 */
export function shortFloat(value: number): number {
	// Adding 0 makes 0 of −0, which JSON would print so in any case.
	if (Number.isInteger(value)) return value + 0;
	for (let digits = FEWEST_DIGITS; digits < MOST_DIGITS; digits++) {
		const short = Number(value.toPrecision(digits));
		if (Math.fround(short) === value) return short;
	}
	return Number(value.toPrecision(MOST_DIGITS));
}

/** `value` to so many decimals. */
export function rounded(value: number, decimals: number): number {
	return Number(value.toFixed(decimals));
}
