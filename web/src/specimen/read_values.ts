/** Reads single values from outside: text of a link, a form or the command line, or values of a JSON file. */

const DECIMAL = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[+-]?\d+)?$/i;

/** Reads a number from a number or its text; undefined for any other value. Never NaN. */
export function readNumber(value: unknown): number | undefined {
	if (typeof value === "number") return Number.isNaN(value) ? undefined : value;
	if (typeof value !== "string") return undefined;
	const text = value.trim();
	return DECIMAL.test(text) ? Number(text) : undefined;
}

/** Reads a list from a list or from text with commas; a single value becomes a list of one. */
export function readList(value: unknown): readonly unknown[] {
	if (Array.isArray(value)) return value;
	return typeof value === "string" ? value.split(",") : [value];
}

/** Reads numbers from a list or from text with commas; undefined where one of them is no number. */
export function readNumbers(value: unknown): number[] | undefined {
	const numbers: number[] = [];
	for (const part of readList(value)) {
		const number = readNumber(part);
		if (number === undefined) return undefined;
		numbers.push(number);
	}
	return numbers;
}

/**
 * Reads a colour, `43264F`, `#43264f` or `#abc`, as six hexadecimal digits in lower case; undefined for other values.
 */
export function readColour(value: unknown): string | undefined {
	if (typeof value !== "string") return undefined;
	const digits = value.trim().replace(/^#/, "").toLowerCase();
	if (/^[0-9a-f]{6}$/.test(digits)) return digits;
	return /^[0-9a-f]{3}$/.test(digits) ? digits.replace(/./g, "$&$&") : undefined;
}

/** Reads a choice: returns its index in `options` from an option's name or from the index itself. */
export function readChoice(value: unknown, options: readonly string[]): number | undefined {
	const named = typeof value === "string" ? options.indexOf(value.trim().toLowerCase()) : -1;
	const place = named >= 0 ? named : readNumber(value);
	return place !== undefined && Object.hasOwn(options, place) ? place + 0 : undefined;
}

/** Returns whether a value is an object that is neither null nor a list. */
export function isRecord(value: unknown): value is Readonly<Record<string, unknown>> {
	return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** Returns a field of an object; undefined where the value is no object or has no such field of its own. */
export function fieldOf(value: unknown, key: string): unknown {
	return typeof value === "object" && value !== null && Object.hasOwn(value, key)
		? (value as Record<string, unknown>)[key]
		: undefined;
}
