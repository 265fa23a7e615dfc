import { html } from "lit";
import { guard } from "lit/directives/guard.js";
import type { Tool } from "../../../ui/tool";
import { layoutInputs } from "../../particles/boundary/editor/boundary_layout";
import type { GripEvent } from "../../particles/boundary/editor/grip";
import { sunPose } from "../../particles/boundary/editor/sun_pose";
import type { WoodenPlant } from "../../particles/boundary/wooden_plant";
import { text } from "../messages.generated";
import type { TreeSpecimen } from "../specimen";
import "../../particles/boundary/editor/sun_view";

/** The editor of the sun's direction. */
export const sun: Tool<TreeSpecimen, WoodenPlant> = {
	name: "sun",
	initial: undefined,
	editor: {
		get title() {
			return text("sun");
		},
		draw: (context) => html`<panicle-sun
			.pose=${guard(layoutInputs(context), () => sunPose(context.state.specimen, context.preset))}
			.grown=${context.state.grown} .preview=${context.state.held}
			@grip-input=${({ detail }: GripEvent) => context.edit(detail)} @grip-change=${() => context.settle()}
		></panicle-sun>`,
	},
};
