import { type Life, stage } from "../../../ui/life";
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
		stage(0, () => text("age_bud")),
		stage(0.5, () => text("age_opening"), { from: 0.25 }),
		stage(1, () => text("age_open"), { from: 0.85 }),
		stage(1.5, () => text("age_fading"), { from: 1.25 }),
		stage(2, () => text("age_wilted"), { from: 1.8 }),
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
