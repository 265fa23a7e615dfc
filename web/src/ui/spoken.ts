/** Units as words. */

const SPOKEN: Readonly<Record<string, string>> = {
	px: "pixels",
	mm: "millimetres",
	"×": "times",
	"°": "degrees",
	"%": "percent",
	u: "units",
};

/** "millimetres" for mm; a unit without words is read as written. */
export function spoken(unit: string): string {
	return SPOKEN[unit] ?? unit;
}
