import type { Life } from "../../../ui/life";
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
		{
			at: 0,
			get name() {
				return text("age_flowering");
			},
			icon: FLOWER,
		},
		{
			at: FRUIT_SET,
			get name() {
				return text("age_fruit_set");
			},
		},
		{
			at: 30,
			get name() {
				return text("age_green");
			},
		},
		{
			at: 60,
			get name() {
				return text("age_colouring");
			},
		},
		{
			at: 100,
			get name() {
				return text("age_ripe");
			},
		},
		{
			at: 125,
			from: 110,
			get name() {
				return text("age_shrivelled");
			},
		},
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
