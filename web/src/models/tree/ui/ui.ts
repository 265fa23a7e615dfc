/** The tree's user interface: loaded with the first tree, only in a page. */
import { html } from "lit";
import type { ModelUi } from "../../../ui/tool";
import { boundaryTool } from "../../particles/boundary/boundary_tool";
import { meshTool } from "../../particles/boundary/mesh_tool";
import { planTool } from "../../particles/boundary/plan_tool";
import { readout } from "../../particles/boundary/readout";
import { boundaryShellTool } from "../../particles/boundary/shell_tool";
import { watchingEither } from "../../particles/watch";
import { treeLayout } from "../layout";
import { lightTool } from "../light/light_tool";
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
	about: html`<p>
			Particles scattered between an outer and an inner boundary run together on their way to the ground; their trails are
			the branches. Drag the boundary's points, or the sun: where it is light, there are more.
		</p>
		<p>
			After Y. Rodkaew, P. Chongstitvatana, S. Siripant and C. Lursinsap, “Particle systems for plant modeling”, <i>Plant
			Growth Modeling and Applications</i> (2003).
		</p>`,
};
