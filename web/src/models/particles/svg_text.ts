/** Text for the SVGs of leaves, trees and roots. */

/** Rounds to hundredths, here of a millimetre. */
export function short(value: number): number {
	return Math.round(value * 100) / 100 + 0; // −0 becomes 0
}

/** Escapes text between tags. */
export function escaped(text: string): string {
	return text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
}
