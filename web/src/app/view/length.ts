/** Lengths in the 3-D view, in the units of the language: "12.3 cm". */
import { formatNumber } from "../../locale/format";

const UNITS = [
	{ unit: "millimeter", metres: 0.001 },
	{ unit: "centimeter", metres: 0.01 },
	{ unit: "meter", metres: 1 },
] as const;

/** Formats a length of so many metres in millimetres below a centimetre, in metres from a metre on, else in centimetres. */
export function formatLength(metres: number, digits = 3): string {
	// Rounded first, so that 9.996 mm is 1 cm.
	const rounded = Number(metres.toPrecision(digits));
	const { unit, metres: size } = UNITS[rounded < 0.01 ? 0 : rounded < 1 ? 1 : 2];
	return formatNumber(rounded / size, { style: "unit", unit, maximumSignificantDigits: digits });
}
