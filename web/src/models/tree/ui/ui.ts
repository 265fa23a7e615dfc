/** The tree's user interface: loaded with the first tree, only in a page. */

import { html } from "lit";
import type { ModelUi } from "../../../ui/tool";
import { boundaryTool } from "../../particles/boundary/boundary_tool";
import { meshTool } from "../../particles/boundary/mesh_tool";
import { planTool } from "../../particles/boundary/plan_tool";
import { readout } from "../../particles/boundary/readout";
import { boundaryShellTool } from "../../particles/boundary/shell_tool";
import { text as particles } from "../../particles/messages.generated";
import { watchingEither } from "../../particles/watch";
import { treeLayout } from "../layout";
import { lightTool } from "../light/light_tool";
import { text } from "../messages.generated";
import type { TreeSpecimen } from "../specimen";
import { TREE_TABLE } from "../table";
import type { TreePlant } from "../tree_plant";
import { sun } from "./sun";

export const face: ModelUi<TreeSpecimen, TreePlant> = {
	tools: [
		boundaryTool(treeLayout, "crown"),
		planTool(treeLayout),
		boundaryShellTool(treeLayout),
		sun,
		lightTool,
		meshTool("crown", "height"),
		...watchingEither<TreeSpecimen, TreePlant>(TREE_TABLE),
	],
	readout,
	get about() {
		return html`<p>${text("about_usage")}</p>
			<p>${particles.pieces("about_paper", { book: html`<i>Plant Growth Modeling and Applications</i>` })}</p>`;
	},
};
