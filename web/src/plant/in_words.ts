/** Numbers in sentences. */

/** "9.2 m", "34 cm". */
export function lengthInWords(metres: number): string {
	if (metres >= 1) return `${Math.round(metres * 10) / 10} m`;
	const centimetres = metres * 100;
	return `${centimetres < 10 ? Math.round(centimetres * 10) / 10 : Math.round(centimetres)} cm`;
}

/** "5,400 leaves", "1 leaf". */
export function countInWords(count: number, one: string, many: string): string {
	return `${count.toLocaleString("en")} ${count === 1 ? one : many}`;
}

/** The lowest and highest end of segments; 0 and 0 where there are none. */
export function heightsOf(ends: Float32Array): { low: number; high: number } {
	if (ends.length === 0) return { low: 0, high: 0 };
	let low = Number.POSITIVE_INFINITY;
	let high = Number.NEGATIVE_INFINITY;
	for (let at = 1; at < ends.length; at += 3) {
		if (ends[at] < low) low = ends[at];
		if (ends[at] > high) high = ends[at];
	}
	return { low, high };
}
