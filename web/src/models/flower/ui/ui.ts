/** User interface of the model, loaded with the first flower. */

import { html } from "lit";
import { gestureTool } from "../../../grammar_editor/gesture_tool";
import { grammarTools } from "../../../grammar_editor/grammar_tool";
import type { GrammarSource } from "../../../grammar_editor/source";
import type { ModelUi, Tool } from "../../../ui/tool";
import type { FlowerPlant } from "../flower_plant";
import { text } from "../messages.generated";
import type { FlowerSpecimen } from "../specimen";
import { age } from "./age";
import { beginTool, designTools, isDesigned } from "./design/design_tool";
import { source } from "./text";
import { volumeTool } from "./volume_tool";

/** The text with some of its constants among the basics; a designed flower has fields of its organs there instead. */
export const basicFlowerConstants: GrammarSource<FlowerSpecimen> = {
	...source,
	basics: (specimen) => (isDesigned(specimen) ? 0 : 4),
	label: constantLabel,
};

/** Returns the label of a constant that flowers have among the basics. */
function constantLabel(name: string): { label: string; unit?: string } | undefined {
	switch (name) {
		case "length":
			return { label: text("constant_length") };
		case "bend":
			return { label: text("constant_bend") };
		case "bow":
			return { label: text("constant_bow") };
		case "scale":
			return { label: text("constant_scale"), unit: "×" };
		case "across":
			return { label: text("constant_across") };
		case "flowers":
			return { label: text("constant_flowers"), unit: "×" };
		case "height":
			return { label: text("constant_height"), unit: "×" };
		case "wind":
			return { label: text("constant_wind") };
		default:
			return undefined;
	}
}

export const modelUi: ModelUi<FlowerSpecimen, FlowerPlant> = {
	tools: [
		...designTools,
		volumeTool as Tool<FlowerSpecimen, FlowerPlant>,
		age as Tool<FlowerSpecimen, FlowerPlant>,
		beginTool,
		...grammarTools<FlowerSpecimen, FlowerPlant>(basicFlowerConstants),
		gestureTool<FlowerSpecimen, FlowerPlant>(source),
	],
	get about() {
		return html`<p>${text("about_usage")}</p>
			<p>${text.pieces("about_paper", { thesis: html`<i>Simulation of flowering plants</i>` })}</p>`;
	},
};
