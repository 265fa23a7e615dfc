/** The editor of the outer and the inner boundary, seen from the front. */

import { html } from "lit";
import { guard } from "lit/directives/guard.js";
import type { EditorContext } from "../../../ui/editor_context";
import type { Tool } from "../../../ui/tool";
import { text } from "../messages.generated";
import { ACTIVE_GRIP } from "./active_grip";
import { boundaryButtons } from "./boundary_buttons";
import type { BoundedSpecimen } from "./bounded";
import { type BoundaryLayout, layoutInputs, loopsIn } from "./editor/boundary_layout";
import { boundaryPose } from "./editor/boundary_pose";
import type { BoundaryScene } from "./editor/boundary_view";
import { FROM_FRONT } from "./editor/facing";
import type { GripEvent } from "./editor/grip";
import { contourOf } from "./editor/mesh_outline";
import { targetsIn } from "./editor/target_grips";
import { wallsOf } from "./editor/walls";
import type { WoodenPlant } from "./wooden_plant";
import "./editor/boundary_view";

/**
 * Creates the tool.
 * @param layout how the model's parameters describe the boundary
 * @param group the group of the panel in which its buttons are
 */
export function boundaryTool<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	group: string,
): Tool<S, WoodenPlant> {
	return {
		name: "boundary",
		initial: undefined,
		editor: {
			get title() {
				return text("boundary");
			},
			draw: (context) => draw(context, layout),
		},
		panel: { group, place: "below", draw: (context) => boundaryButtons(context, layout) },
		keys: [
			{
				keys: ["Insert"],
				get description() {
					return text("key_insert");
				},
			},
			{
				keys: ["Delete"],
				get description() {
					return text("key_delete");
				},
			},
		],
	};
}

/**
 * Renders the view from the front. Pose and scene are computed only when their inputs change, not with each grown
 * plant.
 */
function draw<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>, layout: BoundaryLayout<S>): unknown {
	const { specimen, grown } = context.state;
	const inputs = layoutInputs(context);
	return html`<panicle-boundary
		.pose=${guard(inputs, () => boundaryPose(layout, specimen, context.preset))} .scene=${guard(inputs, () => sceneOf(layout, specimen))}
		.grown=${grown}
		@grip-input=${({ detail }: GripEvent) => context.edit(detail)} @grip-change=${() => context.settle()}
		@grip-focus=${({ detail }: CustomEvent<string>) => context.setToolState(ACTIVE_GRIP, detail)}
	></panicle-boundary>`;
}

/** Returns the shapes that the view draws, in metres; outlines are in shares of the box. */
function sceneOf<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): BoundaryScene {
	return {
		box: layout.box(specimen),
		axes: layout.axes(specimen),
		loops: loopsIn(layout, specimen),
		inner: specimen.parameters.inner,
		...(specimen.hollow ? { innerLoops: contourOf(specimen.hollow, FROM_FRONT.up) } : {}),
		bareAbout: layout.bareAbout(layout.box(specimen)),
		walls: wallsOf(specimen),
		rounds: wallsOf(specimen, "rounds"),
		targets: targetsIn(layout, specimen),
	};
}
