/** The stand's user interface: loaded with the first stand, only in a page. */

import { html } from "lit";
import { grammarTools } from "../../../grammar_editor/grammar_tool";
import type { ModelUi } from "../../../ui/tool";
import { text } from "../messages.generated";
import type { StandSpecimen } from "../specimen";
import type { StandPlant } from "../stand_plant";
import { map } from "./map";
import { source } from "./text";
import { walk } from "./walk";

export const face: ModelUi<StandSpecimen, StandPlant> = {
	tools: [...grammarTools<StandSpecimen, StandPlant>(source), walk, map],
	get about() {
		return html`<p>${text("about_usage")}</p>
			<p>${text.pieces("about_paper", { journal: html`<i>Computer Animation and Virtual Worlds</i>` })}</p>`;
	},
};
