/** The stand's user interface: loaded with the first stand, only in a page. */
import { html } from "lit";
import { grammarTools } from "../../../grammar_editor/grammar_tool";
import type { ModelUi } from "../../../ui/tool";
import type { StandSpecimen } from "../specimen";
import type { StandPlant } from "../stand_plant";
import { map } from "./map";
import { source } from "./text";
import { walk } from "./walk";

export const face: ModelUi<StandSpecimen, StandPlant> = {
	tools: [...grammarTools<StandSpecimen, StandPlant>(source), walk, map],
	about: html`<p>
			A plan says what ground there is, how many plants stand on it and how, and what they are: specimens of any model, each grown
			from a seed of its own. Neighbours know of each other’s crowns, and leave each other light and room.
		</p>
		<p>
			After J. Kim, D. Kim and H. Cho, “Procedural modeling of trees based on convolution sums of divisor functions for
			real-time virtual ecosystems”, <i>Computer Animation and Virtual Worlds</i> (2013).
		</p>`,
};
