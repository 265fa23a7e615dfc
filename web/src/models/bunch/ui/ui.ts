/** User interface of the bunch, loaded with the first bunch. */

import { html } from "lit";
import { steppedScene } from "../../../grammar_editor/derivation_tool";
import { grammarTools } from "../../../grammar_editor/grammar_tool";
import type { ModelUi } from "../../../ui/tool";
import type { BunchPlant } from "../bunch_plant";
import { text } from "../messages.generated";
import type { BunchSpecimen } from "../specimen";
import { bunchInWords, stemsInWords } from "../words";
import { age } from "./age";
import { asPrinted } from "./as_printed";
import { cane } from "./cane";
import { derivation } from "./derivation";
import { grammar } from "./grammar";
import { inputs } from "./inputs";
import { octahedron } from "./octahedron";
import { photo } from "./photo";
import { pixels } from "./pixels";
import { front, side } from "./profile";
import { readout, skinRow } from "./readout";
import { sides } from "./sides";
import { stems } from "./stems";
import { thinning } from "./thinning";
import "./thinning_panel";

export const modelUi: ModelUi<BunchSpecimen, BunchPlant> = {
	tools: [
		front,
		side,
		cane,
		stems,
		octahedron,
		thinning,
		age,
		inputs,
		sides,
		pixels,
		photo,
		asPrinted,
		...grammarTools(grammar, derivation),
	],
	readout,
	rows: (specimen) => [skinRow(specimen)],
	/** Returns the words below the view: of the shown derivation step, of the stems alone, or of the bunch. */
	caption: (grown, context) => {
		const { grownFrom, specimen } = context.state;
		const stepped = steppedScene(context);
		if (stepped)
			return text("after_step", {
				step: stepped.step,
				plant: bunchInWords(stepped.grown as BunchPlant, grownFrom ?? specimen),
			});
		return context.toolState(stems) ? stemsInWords(grown) : bunchInWords(grown, grownFrom ?? specimen);
	},
	get about() {
		return html`<p>${text("about_usage")}</p>
			<p>${text.pieces("about_paper", { journal: html`<i>Computers &amp; Graphics</i>` })}</p>`;
	},
};
