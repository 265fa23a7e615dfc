/** Shows that a tree from a stand grows among neighbours, with a button to grow it without them. */

import { html } from "lit";
import type { Tool } from "../../../ui/tool";
import type { GrowthPlant } from "../growth_plant";
import { text } from "../messages.generated";
import type { GrowthSpecimen } from "../specimen";

export const neighbours: Tool<GrowthSpecimen, GrowthPlant> = {
	name: "neighbours",
	initial: undefined,
	applies: ({ surroundings }) => surroundings !== undefined,
	panel: {
		group: "life",
		place: "below",
		draw: (context) => html`<p>${text("neighbours")}</p>
			<div class="actions">
				<button class="button" type="button" @click=${() => context.set({ details: { surroundings: undefined } })}>${text("neighbours_remove")}</button>
			</div>`,
	},
};
