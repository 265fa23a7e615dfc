/** Polynomials of degree 6 that give the widths of organs (Petrenko 2014, equation 1), fitted by least squares. */

export const DEGREE = 6;

/** Coefficients c0 … c6. */
export type Coefficients = readonly number[];

/** A point for a polynomial to approximate. */
export interface Sample {
	readonly t: number;
	readonly value: number;
}

/** Evaluates a polynomial at `t` by Horner's scheme. */
export function valueAt(coefficients: Coefficients, t: number): number {
	return coefficients.reduceRight((sum, coefficient) => sum * t + coefficient, 0);
}

/**
 * Fits a polynomial of degree 6 to samples by least squares, with Householder reflections: normal equations would lose
 * half of the digits.
 * @param samples at least seven, of different `t` between 0 and 1
 * @throws RangeError if there are fewer
 */
export function fitted(samples: readonly Sample[]): Coefficients {
	const size = DEGREE + 1;
	if (new Set(samples.map(({ t }) => t)).size < size) throw new RangeError(`A fit takes ${size} different places.`);
	const rows = samples.map(({ t, value }) => [...Array.from({ length: size }, (_, k) => t ** k), value]);
	for (let k = 0; k < size; k++) reflect(rows, k);
	const coefficients = new Array<number>(size).fill(0);
	for (let k = size - 1; k >= 0; k--) {
		const rest = coefficients.reduce((sum, value, j) => (j > k ? sum + rows[k][j] * value : sum), 0);
		coefficients[k] = (rows[k][size] - rest) / rows[k][k];
	}
	return coefficients;
}

/**
 * Applies the Householder reflection that clears column `k` below row `k`, in place.
 * @param rows matrix of the least-squares system, with the right-hand side as its last column
 */
function reflect(rows: number[][], k: number): void {
	const length = Math.hypot(...rows.slice(k).map((row) => row[k]));
	const mirror = rows.map((row, i) => (i < k ? 0 : row[k]));
	mirror[k] += mirror[k] < 0 ? -length : length;
	const square = mirror.reduce((sum, value) => sum + value * value, 0);
	if (square === 0) return;
	for (let j = k; j < rows[0].length; j++) {
		const factor = (2 * rows.reduce((sum, row, i) => sum + mirror[i] * row[j], 0)) / square;
		rows.forEach((row, i) => {
			row[j] -= factor * mirror[i];
		});
	}
}

/** Returns the largest distance between a polynomial and its samples. */
export function errorOf(coefficients: Coefficients, samples: readonly Sample[]): number {
	return samples.reduce((most, { t, value }) => Math.max(most, Math.abs(valueAt(coefficients, t) - value)), 0);
}
