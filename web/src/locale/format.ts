/** Formats values inside messages in the language in use. Generated messages call these functions. */
import { localeTag } from "./locale";

/** A value in a message: numbers are formatted, texts inserted as they are. */
export type Value = string | number;

/** Formats a number with the separators of the language: 10,000 or 10 000. */
export const formatNumber = (value: number, options?: Intl.NumberFormatOptions): string =>
	numberFormat(options).format(value);

/** Formats a number with a fixed number of decimals: 1,234.50. */
export function formatDecimals(value: number, decimals: number): string {
	const tag = localeTag();
	const key = `${tag} ${decimals}`;
	let format = decimalFormats.get(key);
	if (!format) {
		format = new Intl.NumberFormat(tag, { minimumFractionDigits: decimals, maximumFractionDigits: decimals });
		decimalFormats.set(key, format);
	}
	return format.format(value);
}

/** Formats a date, by default as day, month and year. */
export const formatDate = (date: Date, options: Intl.DateTimeFormatOptions = { dateStyle: "medium" }): string =>
	new Intl.DateTimeFormat(localeTag(), options).format(date);

/** Joins texts into a list: "a, b and c". */
export const formatList = (texts: Iterable<string>, type: "conjunction" | "disjunction" = "conjunction"): string =>
	new Intl.ListFormat(localeTag(), { type }).format(texts);

/** Returns the text of a value in a message: numbers are formatted. */
export const show = (value: Value): string => (typeof value === "number" ? formatNumber(value) : value);

/** Returns the case for a number: an exact one ("=0"), else that of the language's plural rules. */
export function plural(value: Value, cases: Readonly<Record<string, string>>): string {
	const number = Number(value);
	return cases[`=${number}`] ?? cases[pluralRules().select(number)] ?? cases.other;
}

/** Returns the case for a word; `other` for a word without one. */
export const choose = (value: Value, cases: Readonly<Record<string, string>>): string =>
	cases[String(value)] ?? cases.other;

let numbers: [string, Intl.NumberFormat] | undefined;
let rules: [string, Intl.PluralRules] | undefined;
/** Formats by language and number of decimals: creating one takes longer than the numbers of a plant. */
const decimalFormats = new Map<string, Intl.NumberFormat>();

/**
 * Returns the format of numbers in the language. Formats without options are created once a language, because creating
 * one takes about 20 µs.
 */
function numberFormat(options?: Intl.NumberFormatOptions): Intl.NumberFormat {
	const tag = localeTag();
	if (options) return new Intl.NumberFormat(tag, options);
	if (numbers?.[0] !== tag) numbers = [tag, new Intl.NumberFormat(tag)];
	return numbers[1];
}

/** Returns the plural rules of the language, created once. */
function pluralRules(): Intl.PluralRules {
	const tag = localeTag();
	if (rules?.[0] !== tag) rules = [tag, new Intl.PluralRules(tag)];
	return rules[1];
}
