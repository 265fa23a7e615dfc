import type { Life } from "../../../ui/life";
import { lifeTool } from "../../../ui/life_tool";
import type { FlowerPlant } from "../flower_plant";
import { text } from "../messages.generated";
import type { FlowerSpecimen } from "../specimen";
import { usesAge } from "../texts";

/** Stages of a flower's life. In most texts the age changes only positions, so that the same map is placed again. */
export const LIFE: Life = {
	parameter: "age",
	get label() {
		return text("age");
	},
	stages: [
		{
			at: 0,
			get name() {
				return text("age_bud");
			},
		},
		{
			at: 0.5,
			from: 0.25,
			get name() {
				return text("age_opening");
			},
		},
		{
			at: 1,
			from: 0.85,
			get name() {
				return text("age_open");
			},
		},
		{
			at: 1.5,
			from: 1.25,
			get name() {
				return text("age_fading");
			},
		},
		{
			at: 2,
			from: 1.8,
			get name() {
				return text("age_wilted");
			},
		},
	],
	end: 2,
	bestAge: 1,
	milliseconds: 10_000,
	get play() {
		return text("age_play");
	},
	get help() {
		return text("age_help");
	},
};

/** Not shown for texts that do not depend on the age. */
export const age = lifeTool<FlowerSpecimen, FlowerPlant>(LIFE, usesAge);
