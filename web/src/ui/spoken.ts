/** Units as words. */
import { text } from "./messages.generated";

/** Keys of the words for units. */
const SPOKEN = {
	px: "unit_px",
	mm: "unit_mm",
	cm: "unit_cm",
	m: "unit_m",
	"×": "unit_times",
	"°": "unit_degrees",
	"%": "unit_percent",
	u: "unit_units",
} as const;

/** Returns a unit in words, "millimetres" for mm; a unit without words is read as written. */
export function spoken(unit: string): string {
	return Object.hasOwn(SPOKEN, unit) ? text(SPOKEN[unit as keyof typeof SPOKEN]) : unit;
}
