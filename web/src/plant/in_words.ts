/** Numbers in sentences, in the language in use. */
import { formatNumber } from "../locale/format";

/** Returns a length in words: "9.2 m", "34 cm". */
export function lengthInWords(metres: number): string {
	if (metres >= 1) return `${formatNumber(metres, { maximumFractionDigits: 1 })} m`;
	const centimetres = metres * 100;
	return `${formatNumber(centimetres, { maximumFractionDigits: centimetres < 10 ? 1 : 0 })} cm`;
}

/** Returns the lowest and highest end of segments; 0 and 0 where there are none. */
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
