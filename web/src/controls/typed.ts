/** A number as people type it: a comma for a point, a true minus; NaN where it is none. */
export function readTyped(text: string): number {
	const plain = text.trim().replace(",", ".").replace("−", "-");
	return plain === "" ? Number.NaN : Number(plain);
}
