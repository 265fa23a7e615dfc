/** User interface of the model, loaded with the first flower. */
import { html } from "lit";
import { gestureTool } from "../../../grammar_editor/gesture_tool";
import { grammarTools } from "../../../grammar_editor/grammar_tool";
import type { ModelUi, Tool } from "../../../ui/tool";
import type { FlowerPlant } from "../flower_plant";
import type { FlowerSpecimen } from "../specimen";
import { age } from "./age";
import { beginTool, designTools } from "./design/design_tool";
import { source } from "./text";
import { volumeTool } from "./volume_tool";

export const modelUi: ModelUi<FlowerSpecimen, FlowerPlant> = {
	tools: [
		...designTools,
		volumeTool as Tool<FlowerSpecimen, FlowerPlant>,
		age as Tool<FlowerSpecimen, FlowerPlant>,
		beginTool,
		...grammarTools<FlowerSpecimen, FlowerPlant>(source),
		gestureTool<FlowerSpecimen, FlowerPlant>(source),
	],
	about: html`<p>
			A flower is made of volumes that grow on each other’s faces, are glued and split, as its text says; organs are modules of
			it.
		</p>
		<p>After O. Petrenko, <i>Simulation of flowering plants</i> (thesis, University of Limoges, 2014).</p>`,
};
