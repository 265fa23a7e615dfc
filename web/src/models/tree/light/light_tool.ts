/** A switch that shows the light in a tree's crown, cell by cell (Rodkaew et al. 2003, figure 8). */

import { html, nothing, svg } from "lit";
import { LazyInteraction } from "../../../ui/handles/lazy_interaction";
import type { Tool } from "../../../ui/tool";
import { text } from "../messages.generated";
import type { TreeSpecimen } from "../specimen";
import type { TreePlant } from "../tree_plant";

export type LightTool = Tool<TreeSpecimen, TreePlant, boolean>;

const ICON = svg`<path d="M3.5 3.5h13v13h-13zM3.5 7.800h13M3.5 12.200h13M7.800 3.500v13M12.200 3.500v13"/>`;

/** The tool that shows how much light reaches the places of a crown. */
export const lightTool: LightTool = {
	name: "light",
	initial: false,
	press: (context) => context.setToolState(lightTool, !context.toolState(lightTool)),
	button: {
		slot: "view",
		icon: ICON,
		get label() {
			return text("light");
		},
		pressed: (context) => context.toolState(lightTool),
	},
	/** The legend of the cells, as text: colours alone are not sufficient. */
	chip: {
		get title() {
			return text("light");
		},
		draw: (context) => (context.toolState(lightTool) ? html`<span>${text("light_legend")}</span>` : nothing),
	},
	interaction: (view, context) =>
		new LazyInteraction<TreeSpecimen, TreePlant>({
			context,
			wanted: () => context.toolState(lightTool),
			fetch: async () => new (await import("./light_interaction")).LightHands(view, context, lightTool),
			onFetchFailed: () => context.setToolState(lightTool, false),
		}),
};
