import type { Life } from "../../../ui/life";
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
		{
			at: 0,
			get name() {
				return text("stage_seed");
			},
		},
		{
			at: 15,
			from: 1,
			get name() {
				return text("stage_seedling");
			},
		},
		{
			at: 45,
			from: 30,
			get name() {
				return text("stage_young");
			},
		},
		{
			at: 75,
			from: 60,
			get name() {
				return text("stage_half_grown");
			},
		},
		{
			at: 100,
			get name() {
				return text("stage_grown");
			},
		},
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
