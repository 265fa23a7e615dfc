/** The root's user interface: loaded with the first root, only in a page. */
import { html } from "lit";
import type { ModelUi } from "../../../ui/tool";
import { boundaryTool } from "../../particles/boundary/boundary_tool";
import { meshTool } from "../../particles/boundary/mesh_tool";
import { planTool } from "../../particles/boundary/plan_tool";
import { readout } from "../../particles/boundary/readout";
import { boundaryShellTool } from "../../particles/boundary/shell_tool";
import type { WoodenPlant } from "../../particles/boundary/wooden_plant";
import { watchingEither } from "../../particles/watch";
import { rootLayout } from "../layout";
import type { RootSpecimen } from "../specimen";
import { ROOT_TABLE } from "../table";

export const face: ModelUi<RootSpecimen, WoodenPlant> = {
	tools: [
		boundaryTool(rootLayout, "volume"),
		planTool(rootLayout),
		boundaryShellTool(rootLayout),
		meshTool("volume", "reach"),
		...watchingEither<RootSpecimen, WoodenPlant>(ROOT_TABLE),
	],
	readout,
	about: html`<p>
			Particles scattered in a volume below ground run together on their way up to the collar; their trails are the roots.
			They are seen in a pit of which the near wall is left away. Drag the points of the volume.
		</p>
		<p>
			After Y. Rodkaew, P. Chongstitvatana, S. Siripant and C. Lursinsap, “Particle systems for plant modeling”, <i>Plant
			Growth Modeling and Applications</i> (2003).
		</p>`,
};
