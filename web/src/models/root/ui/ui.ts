/** The root's user interface: loaded with the first root, only in a page. */

import { html } from "lit";
import type { ModelUi } from "../../../ui/tool";
import { boundaryTool } from "../../particles/boundary/boundary_tool";
import { meshTool } from "../../particles/boundary/mesh_tool";
import { planTool } from "../../particles/boundary/plan_tool";
import { readout } from "../../particles/boundary/readout";
import { boundaryShellTool } from "../../particles/boundary/shell_tool";
import type { WoodenPlant } from "../../particles/boundary/wooden_plant";
import { text as particles } from "../../particles/messages.generated";
import { watchingEither } from "../../particles/watch";
import { rootLayout } from "../layout";
import { text } from "../messages.generated";
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
	get about() {
		return html`<p>${text("about_usage")}</p>
			<p>${particles.pieces("about_paper", { book: html`<i>Plant Growth Modeling and Applications</i>` })}</p>`;
	},
};
