/** Names of a volume's nine numbers, and descriptions of numbers in a flower's text. */
import { text as message } from "../messages.generated";

/** Symbol, message with the name, and unit of each number. */
export const FIELDS = [
	["N", "field_n", ""],
	["T", "field_t", ""],
	["atx", "field_atx", "°"],
	["aty", "field_aty", "°"],
	["atz", "field_atz", "°"],
	["H", "field_h", "mm"],
	["L", "field_l", "mm"],
	["W", "field_w", "mm"],
	["m", "field_m", ""],
] as const;

/**
 * Describes a number: a volume's by `FIELDS`, a variable by the comment behind its definition; empty if there is none.
 */
export function describeNumber(text: string, name: string): string {
	const field = FIELDS.find(([sign]) => sign === name);
	if (field) return field[2] ? message("field_unit", { name: message(field[1]), unit: field[2] }) : message(field[1]);
	for (const head of text.matchAll(/^[ \t]*#[ \t]*define[ \t]+([\p{L}\p{N}_]+)[ \t]*=/gmu)) {
		if (head[1] !== name) continue;
		const line = text.slice(head.index + head[0].length).split("\n", 1)[0];
		const from = line.indexOf("/*");
		const to = line.indexOf("*/", from + 2);
		if (from >= 0 && to >= 0) return line.slice(from + 2, to).trim();
	}
	return "";
}
