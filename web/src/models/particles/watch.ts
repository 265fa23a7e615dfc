import type { Life } from "../../controls/life";
import type { PlayState } from "../../controls/life_player";
import { lifeTool } from "../../controls/life_tool";
import type { Tool } from "../../controls/tool";
import type { Plant } from "../../plant/plant";
import type { Specimen } from "../../specimen/specimen";

/** Watching particles run: the bar below the view, for leaf, tree and root. */
export function watching<S extends Specimen, G extends Plant>(): Tool<S, G, PlayState> {
	return lifeTool<S, G>(LIFE);
}

/** How far the particles have run: the share of the steps in which all arrive. */
export const LIFE: Life = {
	parameter: "age",
	label: "Age",
	stages: [
		{ at: 0, name: "Scattered" },
		{ at: 10, from: 1, name: "Setting out" },
		{ at: 40, from: 25, name: "Merging" },
		{ at: 75, from: 60, name: "Arriving" },
		{ at: 100, name: "Grown" },
	],
	end: 100,
	milliseconds: 8000,
	play: "Play from scattered particles to the last arrival",
	steps: ({ counts }) => counts.steps ?? 0,
	help: "0 particles scattered, 100 all trails stand.",
};
