/** User interface of the model, loaded with its first plant. */

import { html } from "lit";
import { steppedScene } from "../../../grammar_editor/derivation_tool";
import { gestureTool } from "../../../grammar_editor/gesture_tool";
import { grammarTools } from "../../../grammar_editor/grammar_tool";
import type { ModelUi } from "../../../ui/tool";
import { areaPanel } from "../areas/area_panel";
import { areaTools } from "../areas/area_tool";
import type { GrammarPlant } from "../grammar_plant";
import { text } from "../messages.generated";
import type { GrammarSpecimen } from "../specimen";
import { grammarInWords } from "../words";
import { derivation } from "./derivation";
import { readout } from "./readout";
import { stepCount } from "./step_count";
import { source } from "./text";
import { warningsOf } from "./warnings";

export const modelUi: ModelUi<GrammarSpecimen, GrammarPlant> = {
	tools: [
		stepCount,
		areaPanel,
		...grammarTools(source, derivation),
		...areaTools,
		gestureTool<GrammarSpecimen, GrammarPlant>(source),
	],
	caption: (grown, context) => {
		const stepped = steppedScene(context);
		return stepped
			? text("after_step", { step: stepped.step, plant: grammarInWords(stepped.grown as GrammarPlant) })
			: grammarInWords(grown);
	},
	readout,
	warnings: warningsOf,
	get about() {
		return html`<p>${text("about_usage")}</p><p>${text("about_paper")}</p>`;
	},
};
