/**
 * Finds parameters that reach target measures. It knows no model: the model names the parameters that change a measure
 * (Lever), and the caller measures specimens (`measure`).
 */
import type { MeasureInfo } from "../specimen/measures";
import type { Specimen } from "../specimen/specimen";
import type { Table } from "../specimen/table";
import { type Aim, toleranceOf } from "./aim";
import type { Lever, Levers } from "./lever";
import { Search } from "./search";

/** The most growths for one solution. */
export const MAX_GROWTHS = 15;

export interface TargetProblem<S extends Specimen = Specimen> {
	readonly table: Table;
	readonly from: S;
	/** Each for a different measure. */
	readonly aims: readonly Aim[];
	readonly levers: Levers<S>;
}

export interface SolverCallbacks<S extends Specimen = Specimen> {
	/** Grows a specimen and returns its measures, in the table's order. An error ends the search. */
	measure(specimen: S): Promise<Float32Array>;
	/** Called after each growth. */
	progress?(growths: number): void;
}

/** The result for one target. */
export interface AimResult extends Aim {
	readonly info: MeasureInfo;
	/** The measure of the found specimen; NaN where it has no such measure. */
	readonly measured: number;
	/** Whether that is the target value, except for invisible differences, or within its range. */
	readonly isReached: boolean;
	/** Whether a parameter changes the measure. */
	readonly hasLever: boolean;
	/** Whether its parameters are at their limits, so that no nearer value is possible. */
	readonly isAtLimit: boolean;
}

export interface Solution<S extends Specimen = Specimen> {
	/** The specimen nearest to the targets; `from` itself where none is nearer. */
	readonly specimen: S;
	readonly reached: readonly AimResult[];
	readonly growths: number;
}

/** A target, and the index of its measure. */
interface AimedMeasure extends Aim {
	readonly info: MeasureInfo;
	readonly index: number;
	readonly tolerance: number;
}

/** A target with its remaining levers; the first is in use. */
interface Task<S extends Specimen> extends AimedMeasure {
	levers: readonly Lever<S>[];
}

interface Sample<S> {
	readonly specimen: S;
	readonly values: Float32Array;
}

/** Solves for all targets at once. */
export async function solve<S extends Specimen>(
	question: TargetProblem<S>,
	means: SolverCallbacks<S>,
): Promise<Solution<S>> {
	return new Solver(question, means).run();
}

class Solver<S extends Specimen> {
	readonly #means: SolverCallbacks<S>;
	readonly #from: S;
	readonly #tasks: readonly Task<S>[];
	/** Reachable targets: the plant has the measure, and a lever changes it. The others do not count as misses. */
	#sought: readonly Task<S>[] = [];
	#best: Sample<S> | undefined;
	#growths = 0;

	/** @param problem.levers by measure, in the order in which they are tried */
	constructor({ table, aims, levers, from }: TargetProblem<S>, means: SolverCallbacks<S>) {
		this.#means = means;
		this.#from = from;
		const { measures } = table;
		this.#tasks = aims.flatMap((aim) => {
			const index = measures.findIndex(({ key }) => key === aim.measure);
			const info = measures[index];
			if (!info) return [];
			return [{ ...aim, info, index, tolerance: toleranceOf(info, aim.value), levers: levers[aim.measure] ?? [] }];
		});
	}

	/**
	 * Searches until all targets are reached, no lever is left, or MAX_GROWTHS specimens have been grown. Where a lever
	 * reaches its limit, the measure's next lever is used.
	 */
	async run(): Promise<Solution<S>> {
		const first = await this.#grow(this.#from);
		this.#sought = this.#tasks.filter(({ levers, index }) => levers.length > 0 && Number.isFinite(first.values[index]));
		this.#best = first;
		let atLimit: readonly number[] = [];
		while (this.#growths < MAX_GROWTHS && !this.#areAimsReached()) {
			atLimit = await this.#searchOnce(this.#best);
			const further = atLimit.filter((i) => this.#tasks[i].levers.length > 1);
			if (further.length === 0) break;
			for (const i of further) this.#tasks[i].levers = this.#tasks[i].levers.slice(1);
		}
		const { specimen, values } = this.#best;
		const reached = this.#tasks.map((task, i) => {
			const { measure, value, within, info, index, levers } = task;
			const isReached = isAimReached(task, values) || isWithin(task, values);
			return {
				...{ measure, value, info, ...(within && { within }) },
				measured: values[index],
				isReached,
				hasLever: levers.length > 0,
				isAtLimit: !isReached && atLimit.includes(i),
			};
		});
		return { specimen, reached, growths: this.#growths };
	}

	/**
	 * Searches from a specimen with the first lever of each target.
	 * @returns the tasks whose levers reached their limits
	 */
	async #searchOnce(start: Sample<S>): Promise<readonly number[]> {
		const active = this.#tasks.flatMap(({ levers, index }, i) =>
			levers.length > 0 && Number.isFinite(start.values[index]) ? [i] : [],
		);
		const tasks = active.map((i) => this.#tasks[i]);
		const levers = tasks.map(({ levers: [lever] }) => lever);
		const first = levers.every((lever) => lever.of(start.specimen) > 0)
			? start
			: await this.#grow(setUnsetLevers(start.specimen, tasks));
		const at = (specimen: S) => levers.map((lever) => Math.log(lever.of(specimen)));
		const residuals = ({ values }: Sample<S>) => tasks.map((task) => residualOf(task, values));
		const unknowns = levers.map(({ from, to, power }) => ({ from: Math.log(from), to: Math.log(to), slope: power }));
		const search = new Search(unknowns, at(first.specimen), residuals(first));
		while (this.#growths < MAX_GROWTHS && !this.#areAimsReached()) {
			if (search.atLimit.some((i) => tasks[i].levers.length > 1)) break;
			const next = search.next();
			if (!next) break;
			const wanted = next.reduce((done, value, i) => levers[i].set(done, Math.exp(value)), first.specimen);
			const place = at(wanted);
			if (search.hasSample(place)) search.skip();
			else search.record(place, residuals(await this.#grow(wanted)));
		}
		return search.atLimit.map((i) => active[i]);
	}

	/** Grows and measures a specimen, and notes it if it is the best so far. */
	async #grow(specimen: S): Promise<Sample<S>> {
		const sample = { specimen, values: await this.#means.measure(specimen) };
		this.#growths++;
		this.#means.progress?.(this.#growths);
		if (!this.#best || this.#missOf(sample.values) < this.#missOf(this.#best.values)) this.#best = sample;
		return sample;
	}

	/** Returns whether the best specimen reaches all targets that can be reached. */
	#areAimsReached(): boolean {
		const values = this.#best?.values;
		return values !== undefined && this.#sought.every((task) => isAimReached(task, values));
	}

	/** Returns how far measures miss the targets: the sum of squared residuals. */
	#missOf(values: Float32Array): number {
		return this.#sought.reduce((sum, task) => sum + residualOf(task, values) ** 2, 0);
	}
}

/** Sets levers that are 0 to the target: they are in the measure's unit. */
function setUnsetLevers<S extends Specimen>(specimen: S, tasks: readonly Task<S>[]): S {
	return tasks.reduce(
		(done, { levers: [lever], value }) => (lever.of(done) > 0 ? done : lever.set(done, value)),
		specimen,
	);
}

/** Returns whether a measure is its target value, except for invisible differences. */
const isAimReached = ({ index, value, tolerance }: AimedMeasure, values: Float32Array) =>
	Math.abs(values[index] - value) <= tolerance;

/**
 * Returns whether a measure is within its target's range. The search aims at one value of the range, so that plants of
 * a series are spread over it; any other is as good.
 */
const isWithin = ({ index, within, tolerance }: AimedMeasure, values: Float32Array) =>
	within !== undefined && values[index] >= within[0] - tolerance && values[index] <= within[1] + tolerance;

/**
 * Returns the difference of a measure from its target, scaled by asinh: a difference of logarithms where the measure is
 * large, since lengths, volumes and weights grow by powers; linear near 0. Infinite where the measure does not apply.
 */
function residualOf({ index, value, tolerance }: AimedMeasure, values: Float32Array): number {
	const scaled = (measure: number) => Math.asinh(measure / (2 * tolerance));
	return Number.isFinite(values[index]) ? scaled(values[index]) - scaled(value) : Number.POSITIVE_INFINITY;
}
