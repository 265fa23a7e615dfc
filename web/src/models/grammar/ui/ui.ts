/** User interface of the model, loaded with its first plant. */
import { html } from "lit";
import { steppedScene } from "../../../grammar_editor/derivation_tool";
import { gestureTool } from "../../../grammar_editor/gesture_tool";
import { grammarTools } from "../../../grammar_editor/grammar_tool";
import type { ModelUi } from "../../../ui/tool";
import { areaPanel } from "../areas/area_panel";
import { areaTools } from "../areas/area_tool";
import type { GrammarPlant } from "../grammar_plant";
import type { GrammarSpecimen } from "../specimen";
import { grammarInWords } from "../words";
import { derivation } from "./derivation";
import { readout } from "./readout";
import { source } from "./text";
import { warningsOf } from "./warnings";

export const modelUi: ModelUi<GrammarSpecimen, GrammarPlant> = {
	tools: [
		areaPanel,
		...grammarTools(source, derivation),
		...areaTools,
		gestureTool<GrammarSpecimen, GrammarPlant>(source),
	],
	caption: (grown, context) => {
		const stepped = steppedScene(context);
		return stepped
			? `After step ${stepped.step}: ${grammarInWords(stepped.grown as GrammarPlant)}`
			: grammarInWords(grown);
	},
	readout,
	warnings: warningsOf,
	about: html`<p>
			A text grows as a plant: an axiom, and productions that rewrite it. Topiary grows in volumes that you move, turn and
			widen by their handles; the main branch passes from one to the next.
		</p>
		<p>
			After S. Seo, Y. Kim and H. Lee, “Interactive fractal tree generation method having multiple clipping volumes” (2014).
		</p>`,
};
