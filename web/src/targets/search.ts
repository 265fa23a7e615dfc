/**
 * Finds a root of residuals with few evaluations: Broyden's method (1965, "A class of methods for solving nonlinear
 * simultaneous equations") within bounds. Residuals may be noisy, as growth is: steps too short to separate a slope
 * from noise do not update slopes, the best point is stored, and with one unknown a change of sign gives a bracket that
 * the search never leaves (regula falsi).
 */

/** One unknown and its residual. */
export interface Unknown {
	readonly from: number;
	readonly to: number;
	/** A rough derivative of the residual by the unknown; not 0. */
	readonly slope: number;
}

interface Point {
	readonly at: readonly number[];
	readonly residuals: readonly number[];
}

/** The longest step of an unknown. */
const LONGEST_STEP = 1.2;
/** The shortest step that updates slopes. */
const SHORTEST_STEP = 0.004;
/** The number of points without progress after which the search stops. */
const PATIENCE = 5;
/** Share of a bracket at each end that the next point avoids. */
const INSET = 0.08;

export class Search {
	readonly #unknowns: readonly Unknown[];
	/** Derivatives: residuals by unknowns. */
	readonly #slopes: number[][];
	readonly #seen: Point[] = [];
	#best: Point;
	#idle = 0;

	constructor(unknowns: readonly Unknown[], at: readonly number[], residuals: readonly number[]) {
		this.#unknowns = unknowns;
		this.#slopes = unknowns.map(({ slope }, row) => unknowns.map((_, column) => (row === column ? slope : 0)));
		this.#best = { at, residuals };
		this.#seen.push(this.#best);
	}

	/** The point with the least sum of squared residuals. */
	get best(): Point {
		return this.#best;
	}

	/** Indices of the unknowns at a bound whose root is beyond it. */
	get atLimit(): number[] {
		return this.#unknowns.flatMap((_, i) => (this.#isAtLimit(i) ? [i] : []));
	}

	/** Returns the next point to evaluate; undefined where none is promising. */
	next(): readonly number[] | undefined {
		if (this.#idle >= PATIENCE) return undefined;
		const free = this.#unknowns.flatMap((_, i) => (this.#isAtLimit(i) ? [] : [i]));
		if (free.length === 0) return undefined;
		const { at, residuals } = this.#best;
		const steps = solveLinear(
			free.map((row) => free.map((column) => this.#slopes[row][column])),
			free.map((i) => -residuals[i]),
		);
		const far = this.#reach();
		const next = at.map((value, i) => {
			const place = free.indexOf(i);
			return place < 0 ? value : this.#clampToBounds(i, value + far * clamped(steps?.[place] ?? 0, LONGEST_STEP));
		});
		return this.#unknowns.length === 1 ? [this.#bracketed(next[0])] : next;
	}

	/** Records the residuals at a point, which is the point of `next` or as near to it as possible. */
	record(at: readonly number[], residuals: readonly number[]): void {
		const last = this.#seen[this.#seen.length - 1];
		this.#updateSlopes({ at, residuals }, last === this.#best ? last : this.#best);
		const point = { at, residuals };
		this.#seen.push(point);
		const better = sumOfSquares(residuals) < sumOfSquares(this.#best.residuals);
		this.#idle = better ? 0 : this.#idle + 1;
		if (better) this.#best = point;
	}

	/** Counts the point of `next` as no progress, because it has been evaluated. */
	skip(): void {
		this.#idle++;
	}

	/** Returns whether the point `at`, a value for each lever, has been evaluated. */
	hasSample(at: readonly number[]): boolean {
		return this.#seen.some((point) => point.at.every((value, i) => Math.abs(value - at[i]) < 1e-9));
	}

	/**
	 * Returns the factor of the next step after steps without progress: with one unknown, whose root is beyond all
	 * evaluated points, longer and longer; with several, shorter and to either side, because noise has no slope.
	 */
	#reach(): number {
		if (this.#unknowns.length === 1) return 1 + this.#idle;
		return this.#idle === 0 ? 1 : (this.#idle % 2 === 0 ? 1 : -1) / (1 + this.#idle);
	}

	/** Returns whether the best point has unknown `i` at a bound, and a Newton step would go beyond it. */
	#isAtLimit(i: number): boolean {
		const { from, to, slope } = this.#unknowns[i];
		const { at, residuals } = this.#best;
		const onwards = -residuals[i] / slope;
		return onwards > 0 ? at[i] >= to - 1e-9 : onwards < 0 && at[i] <= from + 1e-9;
	}

	/** Returns a value limited to the bounds of unknown `i`. */
	#clampToBounds(i: number, value: number): number {
		const { from, to } = this.#unknowns[i];
		return Math.min(Math.max(value, from), to);
	}

	/** Updates the slopes by Broyden's rank-one formula; slopes on the diagonal keep their signs. */
	#updateSlopes(to: Point, from: Point): void {
		const step = to.at.map((value, i) => value - from.at[i]);
		const length = sumOfSquares(step);
		if (length < SHORTEST_STEP * SHORTEST_STEP) return;
		for (const [row, slopes] of this.#slopes.entries()) {
			const change = to.residuals[row] - from.residuals[row];
			const miss = change - slopes.reduce((sum, slope, i) => sum + slope * step[i], 0);
			for (const i of slopes.keys()) slopes[i] += (miss * step[i]) / length;
			const { slope } = this.#unknowns[row];
			const share = slopes[row] / slope;
			slopes[row] = slope * Math.min(Math.max(share, 0.15), 6);
		}
	}

	/**
	 * Returns the next value to try for a single unknown: `value`, unless it leaves the interval between the two nearest
	 * samples on both sides of the root or the search makes no progress; then a value within the interval (regula falsi,
	 * or its middle).
	 */
	#bracketed(value: number): number {
		const [{ slope }] = this.#unknowns;
		const side = (sign: number) =>
			this.#seen
				.filter(({ residuals: [residual] }) => Math.sign(residual * slope) === sign)
				.sort((a, b) => Math.abs(a.residuals[0]) - Math.abs(b.residuals[0]))[0];
		const [below, above] = [side(-1), side(1)];
		if (!below || !above) return value;
		const [a, b] = [below.at[0], above.at[0]];
		const [low, high] = [Math.min(a, b), Math.max(a, b)];
		const inset = INSET * (high - low);
		if (value > low + inset && value < high - inset && this.#idle < 2) return value;
		if (this.#idle > 1) return (low + high) / 2;
		const share = Math.abs(below.residuals[0]) / (Math.abs(below.residuals[0]) + Math.abs(above.residuals[0]));
		return a + Math.min(Math.max(share, INSET), 1 - INSET) * (b - a);
	}
}

/** Returns the sum of the squares of values. */
const sumOfSquares = (values: readonly number[]) => values.reduce((sum, value) => sum + value * value, 0);

/** Limits a value to −`most` … `most`. */
const clamped = (value: number, most: number) => Math.min(Math.max(value, -most), most);

/**
 * Solves a small linear system, by elimination with the largest pivots; undefined where there is no solution.
 * @param matrix coefficients, row by row
 * @param right right-hand side
 */
function solveLinear(matrix: number[][], right: number[]): number[] | undefined {
	const rows = matrix.map((row, i) => [...row, right[i]]);
	const count = rows.length;
	for (let column = 0; column < count; column++) {
		const rest = rows.slice(column);
		const pivot =
			column + rest.reduce((best, row, i) => (Math.abs(row[column]) > Math.abs(rest[best][column]) ? i : best), 0);
		if (Math.abs(rows[pivot][column]) < 1e-9) return undefined;
		[rows[column], rows[pivot]] = [rows[pivot], rows[column]];
		for (let row = 0; row < count; row++) {
			if (row === column) continue;
			const share = rows[row][column] / rows[column][column];
			for (let i = column; i <= count; i++) rows[row][i] -= share * rows[column][i];
		}
	}
	return rows.map((row, i) => row[count] / row[i]);
}
