/** The editor of the boundary's depth, the obstacles and the targets, seen from above. */

import { html } from "lit";
import { guard } from "lit/directives/guard.js";
import type { EditorContext } from "../../../ui/editor_context";
import type { Tool } from "../../../ui/tool";
import { text } from "../messages.generated";
import { ACTIVE_GRIP } from "./active_grip";
import type { BoundedSpecimen } from "./bounded";
import { type BoundaryLayout, footprintIn, layoutInputs } from "./editor/boundary_layout";
import type { GripEvent } from "./editor/grip";
import { planPose } from "./editor/plan_pose";
import type { PlanScene } from "./editor/plan_view";
import { targetsIn } from "./editor/target_grips";
import { wallsOf } from "./editor/walls";
import type { WoodenPlant } from "./wooden_plant";
import "./editor/plan_view";

/** Creates the tool that shows the editor seen from above. */
export function planTool<S extends BoundedSpecimen>(layout: BoundaryLayout<S>): Tool<S, WoodenPlant> {
	return {
		name: "plan",
		initial: undefined,
		editor: {
			get title() {
				return text("plan");
			},
			draw: (context) => draw(context, layout),
		},
	};
}

/** Renders the view from above. Pose and scene are computed only when their inputs change. */
function draw<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>, layout: BoundaryLayout<S>): unknown {
	const { specimen, grown, held } = context.state;
	const inputs = layoutInputs(context);
	return html`<panicle-plan
		.pose=${guard(inputs, () => planPose(layout, specimen, context.preset))} .scene=${guard(inputs, () => sceneOf(layout, specimen))}
		.grown=${grown} .preview=${held}
		@grip-input=${({ detail }: GripEvent) => context.edit(detail)} @grip-change=${() => context.settle()}
		@grip-focus=${({ detail }: CustomEvent<string>) => context.setToolState(ACTIVE_GRIP, detail)}
	></panicle-plan>`;
}

/** Returns the shapes that the view draws, in metres; outlines are in shares of the boundary's half-widths. */
function sceneOf<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): PlanScene {
	return {
		halfWidth: layout.box(specimen).halfWidth,
		halfDepth: layout.halfDepth(specimen),
		axes: layout.axes(specimen),
		loops: footprintIn(layout, specimen),
		walls: wallsOf(specimen),
		rounds: wallsOf(specimen, "rounds"),
		targets: targetsIn(layout, specimen),
	};
}
