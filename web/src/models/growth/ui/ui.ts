/** User interface of the model, loaded with its first tree. */

import { html } from "lit";
import { gestureTool } from "../../../grammar_editor/gesture_tool";
import { grammarTools } from "../../../grammar_editor/grammar_tool";
import type { ModelUi, Tool } from "../../../ui/tool";
import { editTool } from "../edits/edit_tool";
import type { GrowthPlant } from "../growth_plant";
import { text } from "../messages.generated";
import type { GrowthSpecimen } from "../specimen";
import { VOLUME_SIZES } from "../volumes/volume_size";
import { volumeTools } from "../volumes/volume_tool";
import { age } from "./age";
import { neighbours } from "./neighbours";
import { source } from "./text";

export const modelUi: ModelUi<GrowthSpecimen, GrowthPlant> = {
	tools: [
		...grammarTools<GrowthSpecimen, GrowthPlant>(source),
		...volumeTools,
		{ name: "volume-sizes", initial: undefined, quantities: () => VOLUME_SIZES },
		editTool as Tool<GrowthSpecimen, GrowthPlant>,
		age as Tool<GrowthSpecimen, GrowthPlant>,
		neighbours as Tool<GrowthSpecimen, GrowthPlant>,
		gestureTool<GrowthSpecimen, GrowthPlant>(source),
	],
	get about() {
		return html`<p>${text("about_usage")}</p>
			<p>${text.pieces("about_paper", { journal: html`<i>Computer Animation and Virtual Worlds</i>` })}</p>`;
	},
};
