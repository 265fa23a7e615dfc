import { html } from "lit";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { Life } from "./life";
import { LifePlayer, type PlayState } from "./life_player";
import { text } from "./messages.generated";
import type { Tool } from "./tool";
import "./life_bar";

/** Returns the tool of a model with a life: the bar below the view, and the key K. */
export function lifeTool<S extends Specimen, G extends Plant>(
	life: Life,
	applies?: (specimen: S) => boolean,
): Tool<S, G, PlayState> {
	const tool: Tool<S, G, PlayState> = {
		name: life.name ?? life.parameter,
		initial: { playing: false },
		applies,
		parameters: [life.parameter],
		press: (context) =>
			context.setToolState(tool, { ...context.toolState(tool), playing: !context.toolState(tool).playing }),
		key: {
			letter: "k",
			get description() {
				return text("play_or_pause", { action: life.play });
			},
		},
		keys: [
			{
				keys: ["Page ↑", "Page ↓"],
				get description() {
					return text("stage_keys");
				},
			},
		],
		bar: {
			title: life.label,
			draw: (context) => html`<panicle-life .context=${context} .life=${life} .play=${tool}></panicle-life>`,
		},
		rest: (context) => context.setToolState(tool, { ...context.toolState(tool), playing: false }),
		start: (context) => {
			const player = new LifePlayer(context, life, tool);
			return () => player.dispose();
		},
	};
	return tool;
}
