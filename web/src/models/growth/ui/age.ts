import type { Life } from "../../../ui/life";
import { lifeTool } from "../../../ui/life_tool";
import type { GrowthPlant } from "../growth_plant";
import type { GrowthSpecimen } from "../specimen";

/** Age of a tree as its share of growth steps: each step adds shoots and leaves earlier ones unchanged. */
export const LIFE: Life = {
	parameter: "age",
	label: "Age",
	stages: [
		{ at: 0, name: "Seed" },
		{ at: 15, from: 1, name: "Seedling" },
		{ at: 45, from: 30, name: "Young" },
		{ at: 75, from: 60, name: "Half grown" },
		{ at: 100, name: "Grown" },
	],
	end: 100,
	milliseconds: 10_000,
	play: "Play from the seed to the grown tree",
	steps: ({ counts }) => counts.steps ?? 0,
	help: "0 a seed, 100 all its steps.",
};

export const age = lifeTool<GrowthSpecimen, GrowthPlant>(LIFE);
