/** Numbers as text: as short as exactness allows. */

/** Significant digits: fewer are rarely enough for a float32, nine always are. */
const FEWEST_DIGITS = 6;
const MAX_DIGITS = 9;

/** Powers of ten that are exact as numbers. */
export const EXACT_POWERS = Array.from({ length: 23 }, (_, exponent) => Number(`1e${exponent}`));

/**
 * Returns the shortest decimal that reads back as the float32 `value`, as a number; `JSON.stringify` prints that
 * decimal. 0.1f, which is 0.10000000149011612, becomes 0.1.
 */
export function shortFloat(value: number): number {
	// Adding 0 turns −0 into 0, as JSON prints it.
	if (Number.isInteger(value)) return value + 0;
	const above = MAX_DIGITS - 1 - Math.floor(Math.log10(Math.abs(value)));
	for (let digits = FEWEST_DIGITS; digits < MAX_DIGITS; digits++) {
		const short = ofDigits(value, digits, above - MAX_DIGITS + digits);
		if (Math.fround(short) === value) return short;
	}
	return ofDigits(value, MAX_DIGITS, above);
}

/**
 * Returns the number of decimals of that decimal, with trailing zeros; undefined where `shortFloat` must be used: with
 * an exponent, or more than nine digits before the point.
 */
export function decimalsOf(value: number): number | undefined {
	const size = Math.abs(value);
	if (size === 0) return 0;
	if (!(size >= LEAST_PLAIN && size <= MAX_PLAIN)) return undefined;
	if (Number.isInteger(value)) return 0;
	let above = MAX_DIGITS - 1;
	if (size < 1) for (let tenths = 1; size < TENTHS[tenths - 1]; tenths++) above++;
	else for (let tens = 1; size >= EXACT_POWERS[tens]; tens++) above--;
	for (let places = Math.max(0, above - MAX_DIGITS + FEWEST_DIGITS); places <= above; places++) {
		const power = EXACT_POWERS[places];
		const scaled = size * power;
		const whole = Math.round(scaled);
		if (!isSure(scaled, whole)) return undefined;
		if (places === above || Math.fround(whole / power) === size) return places;
	}
	return undefined;
}

/** Smaller numbers are written with an exponent. */
const LEAST_PLAIN = 1e-6;
const MAX_PLAIN = 1e9;
/** The nearest numbers to negative powers of ten; no float32 is in between. */
const TENTHS = EXACT_POWERS.map((power) => 1 / power);

/** Rounds a number to `digits` significant digits, `places` of them after the point. */
function ofDigits(value: number, digits: number, places: number): number {
	const power = EXACT_POWERS[places];
	const scaled = Math.abs(value) * power;
	const whole = Math.round(scaled);
	if (power === undefined || !isSure(scaled, whole)) return Number(value.toPrecision(digits));
	return (value < 0 ? -whole : whole) / power;
}

/**
 * Returns whether the rounding is certain: reading the decimal rounds exact numbers once, but near a half the error of
 * the product could change the result.
 * @param scaled the number times a power of ten
 * @param whole the same, rounded
 */
function isSure(scaled: number, whole: number): boolean {
	return Math.abs(scaled - whole) < 0.499_999;
}

/** Rounds a value to a number of decimals. */
export function rounded(value: number, decimals: number): number {
	return Number(value.toFixed(decimals));
}
