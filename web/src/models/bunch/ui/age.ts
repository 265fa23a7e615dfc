import { type Life, stage } from "../../../ui/life";
import { lifeTool } from "../../../ui/life_tool";
import { text } from "../messages.generated";
import { FRUIT_SET } from "../words";
import { isNatural } from "./context";
import { FLOWER } from "./icons";

/** Stages of a bunch's life. Past ripe, a bunch is named after the next stage. */
export const LIFE: Life = {
	parameter: "age",
	get label() {
		return text("age");
	},
	stages: [
		stage(0, () => text("age_flowering"), { icon: FLOWER }),
		stage(FRUIT_SET, () => text("age_fruit_set")),
		stage(30, () => text("age_green")),
		stage(60, () => text("age_colouring")),
		stage(100, () => text("age_ripe")),
		stage(125, () => text("age_shrivelled"), { from: 110 }),
	],
	end: 100,
	milliseconds: 9000,
	get play() {
		return text("age_play");
	},
	get help() {
		return text("age_help");
	},
};

export const age = lifeTool(LIFE, isNatural);
