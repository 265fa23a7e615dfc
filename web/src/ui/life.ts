import type { SVGTemplateResult } from "lit";
import type { Plant } from "../plant/plant";

/** The life of a plant as one parameter runs through it, with names for its stages. */

export interface LifeStage {
	/** Typical age of the stage, which its button sets. */
	readonly at: number;
	/** From where on it is called so; from `at` where absent. */
	readonly from?: number;
	readonly name: string;
	/** A line drawing of it (icons.ts), where it is easily overlooked. */
	readonly icon?: SVGTemplateResult;
}

export interface Life {
	/** Of its tool; the parameter's where absent. */
	readonly name?: string;
	/** The parameter that runs. */
	readonly parameter: string;
	/** Label of the parameter: "Age". */
	readonly label: string;
	/** By `at`; the first is at the parameter's least value. */
	readonly stages: readonly LifeStage[];
	/** Where a play ends. */
	readonly end: number;
	/** Where a plant is at its height, if a play that is begun there is to show its whole life and not its decline. */
	readonly height?: number;
	/** How long a play of the whole takes, milliseconds. */
	readonly milliseconds: number;
	/** Description of playing: "Play from flower to ripe bunch". */
	readonly play: string;
	/** Help on the numbers, for screen readers. */
	readonly help: string;
	/** Of a parameter in percent: in how many even steps a plant's life runs from 0 to 100, where it runs in steps: they can then be taken one by one. */
	steps?(plant: Plant): number;
}

/** How fast a life can run. */
export const SPEEDS = [0.25, 0.5, 1, 2, 4] as const;

/** An age in the middle of the step after that one; from the end on, the beginning. */
export function nextStep({ end, stages }: Life, age: number, steps: number): number {
	if (age >= end) return stages[0].at;
	const next = Math.floor((age / 100) * steps) + 1;
	return next >= steps ? end : Math.min(end, Math.ceil((10_000 * (next + 0.25)) / steps) / 100);
}

/** Returns the stage at an age. */
export function stageOf({ stages }: Life, age: number): LifeStage {
	return stages.findLast(({ at, from = at }) => from <= age) ?? stages[0];
}

/** The stage after that age, or before it; the ends stay. */
export function nextStage({ stages }: Life, age: number, direction: 1 | -1): LifeStage {
	return direction > 0
		? (stages.find(({ at }) => at > age) ?? stages[stages.length - 1])
		: (stages.findLast(({ at }) => at < age) ?? stages[0]);
}
