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
	const above = MOST_DIGITS - 1 - Math.floor(Math.log10(Math.abs(value)));
	for (let digits = FEWEST_DIGITS; digits < MOST_DIGITS; digits++) {
		const short = ofDigits(value, digits, above - MOST_DIGITS + digits);
		if (Math.fround(short) === value) return short;
	}
	return ofDigits(value, MOST_DIGITS, above);
}

/** `value` to so many significant digits, `places` of them after the point. */
function ofDigits(value: number, digits: number, places: number): number {
	const power = POWERS[places];
	const scaled = Math.abs(value) * power;
	const whole = Math.round(scaled);
	// One rounding each of exact numbers, as in reading the decimal; but near a half the product's own could turn the scale.
	const sure = Math.abs(scaled - whole) < 0.499_999;
	if (power === undefined || !sure) return Number(value.toPrecision(digits));
	return (value < 0 ? -whole : whole) / power;
}

/** Powers of ten that are exact as numbers. */
const POWERS = Array.from({ length: 23 }, (_, exponent) => Number(`1e${exponent}`));

/** `value` to so many decimals. */
export function rounded(value: number, decimals: number): number {
	return Number(value.toFixed(decimals));
}
