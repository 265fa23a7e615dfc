/** User interface of the model, loaded with its first tree. */
import { html } from "lit";
import { gestureTool } from "../../../grammar_editor/gesture_tool";
import { grammarTools } from "../../../grammar_editor/grammar_tool";
import type { ModelUi, Tool } from "../../../ui/tool";
import type { GrowthPlant } from "../growth_plant";
import type { GrowthSpecimen } from "../specimen";
import { volumeTools } from "../volumes/volume_tool";
import { age } from "./age";
import { neighbours } from "./neighbours";
import { source } from "./text";

export const modelUi: ModelUi<GrowthSpecimen, GrowthPlant> = {
	tools: [
		...grammarTools<GrowthSpecimen, GrowthPlant>(source),
		...volumeTools,
		age as Tool<GrowthSpecimen, GrowthPlant>,
		neighbours as Tool<GrowthSpecimen, GrowthPlant>,
		gestureTool<GrowthSpecimen, GrowthPlant>(source),
	],
	about: html`<p>
			A text says how many branches and leaves a tree gets at each step, by divisor functions, and in which growth volumes it
			stands. Drag a volume’s handles: the text follows.
		</p>
		<p>
			After J. Kim, D. Kim and H. Cho, “Procedural modeling of trees based on convolution sums of divisor functions for
			real-time virtual ecosystems”, <i>Computer Animation and Virtual Worlds</i> (2013).
		</p>`,
};
