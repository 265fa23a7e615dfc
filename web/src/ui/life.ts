import type { SVGTemplateResult } from "lit";
import type { Plant } from "../plant/plant";

/** The life of a plant as one parameter advances, with named stages. */

export interface LifeStage {
	/** Typical age of the stage, which its button sets. */
	readonly at: number;
	/** Age at which the stage begins; `at` if absent. */
	readonly from?: number;
	readonly name: string;
	/** A line drawing (icons.ts), for stages that are easily overlooked. */
	readonly icon?: SVGTemplateResult;
}

/**
 * Creates a stage.
 * @param name returns its name in the language of the page
 */
export const stage = (at: number, name: () => string, options: Pick<LifeStage, "from" | "icon"> = {}): LifeStage => ({
	...options,
	at,
	get name() {
		return name();
	},
});

export interface Life {
	/** Name of the tool; defaults to the parameter's. */
	readonly name?: string;
	/** Key of the parameter that advances. */
	readonly parameter: string;
	/** Label of the parameter: "Age". */
	readonly label: string;
	/** Stages sorted by `at`; the first is at the parameter's least value. */
	readonly stages: readonly LifeStage[];
	/** Age at which playing ends. */
	readonly end: number;
	/** Age at which a plant is at its best: playing from there shows the whole life, and not only its decline. */
	readonly bestAge?: number;
	/** Duration of playing the whole life, milliseconds. */
	readonly milliseconds: number;
	/** Description of playing: "Play from flower to ripe bunch". */
	readonly play: string;
	/** Help on the numbers, for screen readers. */
	readonly help: string;
	/**
	 * For a parameter in percent whose life proceeds in steps: number of equal steps from 0 to 100, which can be taken
	 * one by one.
	 */
	steps?(plant: Plant): number;
}

/** Factors of the playing speed. */
export const SPEEDS = [0.25, 0.5, 1, 2, 4] as const;

/** Returns an age in the middle of the next step; from the end on, the beginning. */
export function nextStep({ end, stages }: Life, age: number, steps: number): number {
	if (age >= end) return stages[0].at;
	const next = Math.floor((age / 100) * steps) + 1;
	return next >= steps ? end : Math.min(end, Math.ceil((10_000 * (next + 0.25)) / steps) / 100);
}

/** Returns the stage at an age. */
export function stageOf({ stages }: Life, age: number): LifeStage {
	return stages.findLast(({ at, from = at }) => from <= age) ?? stages[0];
}

/** Returns the stage after an age, or before it; the first and last stages stay. */
export function nextStage({ stages }: Life, age: number, direction: 1 | -1): LifeStage {
	return direction > 0
		? (stages.find(({ at }) => at > age) ?? stages[stages.length - 1])
		: (stages.findLast(({ at }) => at < age) ?? stages[0]);
}
