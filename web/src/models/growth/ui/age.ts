import { type Life, stage } from "../../../ui/life";
import { lifeTool } from "../../../ui/life_tool";
import type { GrowthPlant } from "../growth_plant";
import { text } from "../messages.generated";
import type { GrowthSpecimen } from "../specimen";

/** Age of a tree as its share of growth steps: each step adds shoots and leaves earlier ones unchanged. */
export const LIFE: Life = {
	parameter: "age",
	get label() {
		return text("age");
	},
	stages: [
		stage(0, () => text("stage_seed")),
		stage(15, () => text("stage_seedling"), { from: 1 }),
		stage(45, () => text("stage_young"), { from: 30 }),
		stage(75, () => text("stage_half_grown"), { from: 60 }),
		stage(100, () => text("stage_grown")),
	],
	end: 100,
	milliseconds: 10_000,
	get play() {
		return text("age_play");
	},
	steps: ({ counts }) => counts.steps ?? 0,
	get help() {
		return text("age_help");
	},
};

export const age = lifeTool<GrowthSpecimen, GrowthPlant>(LIFE);
