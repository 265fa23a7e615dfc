import type { Life } from "../../../ui/life";
import { lifeTool } from "../../../ui/life_tool";
import type { FlowerPlant } from "../flower_plant";
import type { FlowerSpecimen } from "../specimen";
import { usesAge } from "../texts";

/** Stages of a flower's life. In most texts the age changes only positions, so that the same map is placed again. */
export const LIFE: Life = {
	parameter: "age",
	label: "Age",
	stages: [
		{ at: 0, name: "Bud" },
		{ at: 0.5, from: 0.25, name: "Opening" },
		{ at: 1, from: 0.85, name: "Open" },
		{ at: 1.5, from: 1.25, name: "Fading" },
		{ at: 2, from: 1.8, name: "Wilted" },
	],
	end: 2,
	height: 1,
	milliseconds: 10_000,
	play: "Play from bud to wilted flower",
	help: "0 a bud, 1 open, 2 wilted.",
};

/** Not shown for texts that do not depend on the age. */
export const age = lifeTool<FlowerSpecimen, FlowerPlant>(LIFE, usesAge);
