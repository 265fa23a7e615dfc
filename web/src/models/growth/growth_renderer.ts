/** Renders a tree on the ground. */
import { footingOf } from "../../plant/footing";
import { swayOf } from "../../plant/sway";
import { standingRenderer } from "../../render/outdoor/standing_renderer";
import type { GrowthPlant } from "./growth_plant";
import { growthParts } from "./parts";
import type { GrowthSpecimen } from "./specimen";

export const growthRenderer = standingRenderer<GrowthSpecimen, GrowthPlant>({
	parts: growthParts,
	footing: footingOf,
	sway: swayOf,
});
