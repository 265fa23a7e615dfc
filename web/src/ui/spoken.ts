/** Units as words. */

const SPOKEN: Readonly<Record<string, string>> = {
	px: "pixels",
	mm: "millimetres",
	"×": "times",
	"°": "degrees",
	"%": "percent",
	u: "units",
};

/** "millimetres" for mm; a unit that has no words of its own is read as it is written. */
export function spoken(unit: string): string {
	return SPOKEN[unit] ?? unit;
}
