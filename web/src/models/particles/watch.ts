import type { Plant } from "../../plant/plant";
import type { Specimen } from "../../specimen/specimen";
import type { Table } from "../../specimen/table";
import type { Life } from "../../ui/life";
import type { PlayState } from "../../ui/life_player";
import { lifeTool } from "../../ui/life_tool";
import type { Tool } from "../../ui/tool";
import { text } from "./messages.generated";

/**
 * Creates a tool that plays the movement of the particles, with a bar below the view.
 * @param applies whether a specimen has the tool; absent for all
 */
export function watching<S extends Specimen, G extends Plant>(
	applies?: (specimen: S) => boolean,
): Tool<S, G, PlayState> {
	return lifeTool<S, G>(LIFE, applies);
}

/**
 * Creates the tools that play the movement of the particles or, where the boundary grows with age, the growth; the bar
 * below the view has the stages of either.
 */
export function watchingEither<S extends Specimen, G extends Plant>(table: Table): Tool<S, G>[] {
	const grows = (specimen: S) => table.option(specimen, "life") === "grow";
	const run = watching<S, G>((specimen) => !grows(specimen));
	return [run, lifeTool<S, G>(GROWTH, grows)] as Tool<S, G>[];
}

/** Stages of the movement: the age is the percentage of the steps until all particles have arrived. */
export const LIFE: Life = {
	parameter: "age",
	get label() {
		return text("age");
	},
	stages: [
		{
			at: 0,
			get name() {
				return text("stage_scattered");
			},
		},
		{
			at: 10,
			from: 1,
			get name() {
				return text("stage_starting");
			},
		},
		{
			at: 40,
			from: 25,
			get name() {
				return text("stage_merging");
			},
		},
		{
			at: 75,
			from: 60,
			get name() {
				return text("stage_arriving");
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
	milliseconds: 8000,
	get play() {
		return text("run_play");
	},
	steps: ({ counts }) => counts.steps ?? 0,
	get help() {
		return text("run_help");
	},
};

/** Stages of growth: the age is the percentage of the boundary's final size. */
export const GROWTH: Life = {
	name: "growth",
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
			at: 20,
			from: 1,
			get name() {
				return text("stage_seedling");
			},
		},
		{
			at: 50,
			from: 35,
			get name() {
				return text("stage_young");
			},
		},
		{
			at: 75,
			from: 65,
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
	milliseconds: 8000,
	get play() {
		return text("growth_play");
	},
	get help() {
		return text("growth_help");
	},
};
