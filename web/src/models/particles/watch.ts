import type { Plant } from "../../plant/plant";
import type { Specimen } from "../../specimen/specimen";
import type { Table } from "../../specimen/table";
import type { Life } from "../../ui/life";
import type { PlayState } from "../../ui/life_player";
import { lifeTool } from "../../ui/life_tool";
import type { Tool } from "../../ui/tool";

/** A tool that plays the movement of the particles, with a bar below the view. */
export function watching<S extends Specimen, G extends Plant>(
	applies?: (specimen: S) => boolean,
): Tool<S, G, PlayState> {
	return lifeTool<S, G>(LIFE, applies);
}

/**
 * Tools that play the movement of the particles or, where the boundary grows with age, the growth; the bar below the
 * view has the stages of either.
 */
export function watchingEither<S extends Specimen, G extends Plant>(table: Table): Tool<S, G>[] {
	const grows = (specimen: S) => table.option(specimen, "life") === "grow";
	const run = watching<S, G>((specimen) => !grows(specimen));
	return [run, lifeTool<S, G>(GROWTH, grows)] as Tool<S, G>[];
}

/** Stages of the movement: the age is the percentage of the steps until all particles have arrived. */
export const LIFE: Life = {
	parameter: "age",
	label: "Age",
	stages: [
		{ at: 0, name: "Scattered" },
		{ at: 10, from: 1, name: "Setting out" },
		{ at: 40, from: 25, name: "Merging" },
		{ at: 75, from: 60, name: "Arriving" },
		{ at: 100, name: "Grown" },
	],
	end: 100,
	milliseconds: 8000,
	play: "Play from scattered particles to the last arrival",
	steps: ({ counts }) => counts.steps ?? 0,
	help: "0 particles scattered, 100 all trails stand.",
};

/** Stages of growth: the age is the percentage of the boundary's final size. */
export const GROWTH: Life = {
	name: "growth",
	parameter: "age",
	label: "Age",
	stages: [
		{ at: 0, name: "Seed" },
		{ at: 20, from: 1, name: "Seedling" },
		{ at: 50, from: 35, name: "Young" },
		{ at: 75, from: 65, name: "Half grown" },
		{ at: 100, name: "Grown" },
	],
	end: 100,
	milliseconds: 8000,
	play: "Play from the seed to the grown plant",
	help: "0 a seed, 100 as large as the boundary.",
};
