/** An organ's description as it stands in the text: one comment, `@organ petal outline=rounded count=5 …@`. */
import { type Margin, readMargin, writtenMargin } from "./margin";
import { FIELDS, type NumberField, type Organ, type OrganField } from "./organs";
import { DRAWN } from "./shapes";

export interface Description {
	readonly organ: Organ;
	/** By the keys of the organ's fields. */
	readonly values: Readonly<Record<string, string | number>>;
	/** Of an outline that is drawn. */
	readonly margin?: Margin;
}

/** What nobody has said of it. */
export function usual(organ: Organ, values: Description["values"] = {}): Description {
	return {
		organ,
		values: Object.fromEntries(FIELDS[organ].map((field) => [field.key, taken(field, values[field.key])])),
	};
}

/** A value as the field takes it; its usual one where it does not. */
export function taken(field: OrganField, value: string | number | undefined): string | number {
	if (value === undefined) return field.usual;
	if (field.kind === "choice") return field.options.includes(String(value)) ? value : field.usual;
	if (field.kind === "colour") return /^[0-9a-f]{6}$/.test(String(value)) ? value : field.usual;
	return nearest(field, Number(value));
}

function nearest({ least, most, step, usual: other }: NumberField, value: number): number {
	if (!Number.isFinite(value)) return other;
	const steps = Math.round(Math.min(most, Math.max(least, value)) / step) * step;
	return Math.min(most, Math.max(least, Math.round(steps * 1000) / 1000));
}

/** With other values; those that are drawn keep their margin. */
export function described(
	description: Description,
	values: Description["values"],
	margin = description.margin,
): Description {
	const { organ } = description;
	return { ...usual(organ, { ...description.values, ...values }), ...(margin && { margin }) };
}

/** The line, without its end. */
export function lineOf({ organ, values, margin }: Description): string {
	const said = FIELDS[organ].map(({ key }) => `${key}=${values[key]}`);
	if (margin && values.outline === DRAWN) said.push(`margin=${writtenMargin(margin)}`);
	return `@organ ${organ} ${said.join(" ")}@`;
}

/** The other way round: what is not said, or not understood, is as usual. Undefined where the line is none. */
export function readLine(line: string): Description | undefined {
	// Whole words alone, here and below: of a long one each part would be tried by itself.
	const [, name, rest] = /^@organ (\w+)\b([^@\n]*)@\s*$/.exec(line) ?? [];
	if (name === undefined || !Object.hasOwn(FIELDS, name)) return undefined;
	const organ = name as Organ;
	const said = Object.fromEntries(rest.split(/\s+/).flatMap((word) => settingIn(word)));
	const margin = said.margin === undefined ? undefined : readMargin(said.margin);
	const description = usual(organ, said);
	if (description.values.outline === DRAWN && !margin)
		return described(description, { outline: FIELDS[organ].find(({ key }) => key === "outline")?.usual ?? DRAWN });
	return { ...description, ...(margin && { margin }) };
}

/** Reads `count=5`; characters before the key that are not letters are ignored. */
function settingIn(word: string): [key: string, value: string][] {
	const at = word.indexOf("=");
	let from = at;
	while (from > 0 && /[a-z]/.test(word[from - 1])) from--;
	return from < at && at + 1 < word.length ? [[word.slice(from, at), word.slice(at + 1)]] : [];
}
