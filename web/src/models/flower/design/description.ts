/** Reads and writes an organ's description, a comment in the text: `@organ petal outline=rounded count=5 …@`. */
import { type Margin, readMargin, writtenMargin } from "./margin";
import { FIELDS, type NumberField, type Organ, type OrganField } from "./organs";
import { DRAWN } from "./shapes";

export interface Description {
	readonly organ: Organ;
	/** Values by the keys of the organ's fields. */
	readonly values: Readonly<Record<string, string | number>>;
	/** The margin of a drawn outline. */
	readonly margin?: Margin;
}

/** Returns a description of default values, except for the given ones. */
export function usual(organ: Organ, values: Description["values"] = {}): Description {
	return {
		organ,
		values: Object.fromEntries(FIELDS[organ].map((field) => [field.key, taken(field, values[field.key])])),
	};
}

/** Returns a value clamped to a field's range and step, or the field's default if the value is invalid. */
export function taken(field: OrganField, value: string | number | undefined): string | number {
	if (value === undefined) return field.usual;
	if (field.kind === "choice") return field.options.includes(String(value)) ? value : field.usual;
	if (field.kind === "colour") return /^[0-9a-f]{6}$/.test(String(value)) ? value : field.usual;
	return nearest(field, Number(value));
}

/** Returns the nearest value in the field's range and on its step; the usual value where the number is invalid. */
function nearest({ least, most, step, usual: usualValue }: NumberField, value: number): number {
	if (!Number.isFinite(value)) return usualValue;
	const steps = Math.round(Math.min(most, Math.max(least, value)) / step) * step;
	return Math.min(most, Math.max(least, Math.round(steps * 1000) / 1000));
}

/** Returns a description with some values changed; a drawn outline keeps its margin. */
export function described(
	description: Description,
	values: Description["values"],
	margin = description.margin,
): Description {
	const { organ } = description;
	return { ...usual(organ, { ...description.values, ...values }), ...(margin && { margin }) };
}

/** Writes a description as a line, without a line break. */
export function lineOf({ organ, values, margin }: Description): string {
	const settings = FIELDS[organ].map(({ key }) => `${key}=${values[key]}`);
	if (margin && values.outline === DRAWN) settings.push(`margin=${writtenMargin(margin)}`);
	return `@organ ${organ} ${settings.join(" ")}@`;
}

/**
 * Parses a line written by `lineOf`; missing and invalid values become defaults. Returns undefined if the line is no
 * description.
 */
export function readLine(line: string): Description | undefined {
	// Anchors at whole words, here and below: otherwise each part of a long word would be tried by itself.
	const [, name, rest] = /^@organ (\w+)\b([^@\n]*)@\s*$/.exec(line) ?? [];
	if (name === undefined || !Object.hasOwn(FIELDS, name)) return undefined;
	const organ = name as Organ;
	const settings = Object.fromEntries(rest.split(/\s+/).flatMap((word) => settingIn(word)));
	const margin = settings.margin === undefined ? undefined : readMargin(settings.margin);
	const description = usual(organ, settings);
	if (description.values.outline === DRAWN && !margin)
		return described(description, { outline: FIELDS[organ].find(({ key }) => key === "outline")?.usual ?? DRAWN });
	return { ...description, ...(margin && { margin }) };
}

/**
 * Reads `count=5` as a key and a value, in a list; an empty list for other words. Characters before the key that are
 * not letters are ignored.
 */
function settingIn(word: string): [key: string, value: string][] {
	const equals = word.indexOf("=");
	let from = equals;
	while (from > 0 && /[a-z]/.test(word[from - 1])) from--;
	return from < equals && equals + 1 < word.length ? [[word.slice(from, equals), word.slice(equals + 1)]] : [];
}
