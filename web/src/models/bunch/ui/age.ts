import type { Life } from "../../../ui/life";
import { lifeTool } from "../../../ui/life_tool";
import { FRUIT_SET } from "../words";
import { isNatural } from "./context";
import { FLOWER } from "./icons";

/** Stages of a bunch's life. Past ripe, a bunch is named after the next stage. */
export const LIFE: Life = {
	parameter: "age",
	label: "Age",
	stages: [
		{ at: 0, name: "Flowering", icon: FLOWER },
		{ at: FRUIT_SET, name: "Fruit set" },
		{ at: 30, name: "Green" },
		{ at: 60, name: "Colouring" },
		{ at: 100, name: "Ripe" },
		{ at: 125, from: 110, name: "Shrivelled" },
	],
	end: 100,
	milliseconds: 9000,
	play: "Play from flower to ripe bunch",
	help: "0 first flowers open, 10 fruit set, 60 colouring begins, 100 ripe, 125 shrivelled.",
};

export const age = lifeTool(LIFE, isNatural);
