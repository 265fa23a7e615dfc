import type { Plant } from "../../plant/plant";
import type { Specimen } from "../../specimen/specimen";
import type { Table } from "../../specimen/table";
import { type Life, stage } from "../../ui/life";
import type { PlayState } from "../../ui/life_player";
import { lifeTool } from "../../ui/life_tool";
import type { Tool } from "../../ui/tool";
import { text } from "./messages.generated";

/**
 * Creates a tool that plays the movement of the particles, with a bar below the view.
 * @param applies whether a specimen has the tool; absent for all
 */
export function watching<S extends Specimen, G extends Plant>(
	applies?: (specimen: S) => boolean,
): Tool<S, G, PlayState> {
	return lifeTool<S, G>(LIFE, applies);
}

/**
 * Creates the tools that play the movement of the particles or, where the boundary grows with age, the growth; the bar
 * below the view has the stages of either.
 */
export function watchingEither<S extends Specimen, G extends Plant>(table: Table): Tool<S, G>[] {
	const grows = (specimen: S) => table.option(specimen, "life") === "grow";
	const run = watching<S, G>((specimen) => !grows(specimen));
	return [run, lifeTool<S, G>(GROWTH, grows)] as Tool<S, G>[];
}

/** Stages of the movement: the age is the percentage of the steps until all particles have arrived. */
export const LIFE: Life = {
	parameter: "age",
	get label() {
		return text("age");
	},
	stages: [
		stage(0, () => text("stage_scattered")),
		stage(10, () => text("stage_starting"), { from: 1 }),
		stage(40, () => text("stage_merging"), { from: 25 }),
		stage(75, () => text("stage_arriving"), { from: 60 }),
		stage(100, () => text("stage_grown")),
	],
	end: 100,
	milliseconds: 8000,
	get play() {
		return text("run_play");
	},
	steps: ({ counts }) => counts.steps ?? 0,
	get help() {
		return text("run_help");
	},
};

/** Stages of growth: the age is the percentage of the boundary's final size. */
export const GROWTH: Life = {
	name: "growth",
	parameter: "age",
	get label() {
		return text("age");
	},
	stages: [
		stage(0, () => text("stage_seed")),
		stage(20, () => text("stage_seedling"), { from: 1 }),
		stage(50, () => text("stage_young"), { from: 35 }),
		stage(75, () => text("stage_half_grown"), { from: 65 }),
		stage(100, () => text("stage_grown")),
	],
	end: 100,
	milliseconds: 8000,
	get play() {
		return text("growth_play");
	},
	get help() {
		return text("growth_help");
	},
};
