/** The flat view of outer and inner boundary from in front. */
import { html } from "lit";
import { guard } from "lit/directives/guard.js";
import type { EditorContext } from "../../../ui/editor_context";
import type { Tool } from "../../../ui/tool";
import { boundaryButtons } from "./boundary_buttons";
import type { BoundedSpecimen } from "./bounded";
import { boundaryPose } from "./editor/boundary_pose";
import type { BoundaryScene } from "./editor/boundary_view";
import { FROM_FRONT } from "./editor/facing";
import { feetOf } from "./editor/feet";
import type { GripEvent } from "./editor/grip";
import { type Lay, layingOut, loopsIn } from "./editor/lay";
import { contourOf } from "./editor/mesh_outline";
import { wallsOf } from "./editor/walls";
import { MEANT } from "./meant";
import type { WoodenPlant } from "./wooden_plant";
import "./editor/boundary_view";

export function boundaryTool<S extends BoundedSpecimen>(lay: Lay<S>, group: string): Tool<S, WoodenPlant> {
	return {
		name: "boundary",
		initial: undefined,
		editor: { title: "Boundary", draw: (context) => draw(context, lay) },
		panel: { group, place: "below", draw: (context) => boundaryButtons(context, lay) },
		keys: [
			{ keys: ["Insert"], does: "On a point of the boundary: one more after it" },
			{ keys: ["Delete"], does: "On a point of the boundary, a target or an obstacle: takes it out" },
		],
	};
}

function draw<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>, lay: Lay<S>): unknown {
	const { specimen, grown } = context.state;
	const laidBy = layingOut(context);
	return html`<panicle-boundary
		.pose=${guard(laidBy, () => boundaryPose(lay, specimen, context.preset))} .scene=${guard(laidBy, () => sceneOf(lay, specimen))}
		.grown=${grown}
		@grip-input=${({ detail }: GripEvent) => context.edit(detail)} @grip-change=${() => context.settle()}
		@grip-focus=${({ detail }: CustomEvent<string>) => context.setToolState(MEANT, detail)}
	></panicle-boundary>`;
}

function sceneOf<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): BoundaryScene {
	return {
		box: lay.box(specimen),
		axes: lay.axes(specimen),
		loops: loopsIn(lay, specimen),
		inner: specimen.parameters.inner,
		...(specimen.hollow ? { innerLoops: contourOf(specimen.hollow, FROM_FRONT.up) } : {}),
		bareAbout: lay.bareAbout(lay.box(specimen)),
		walls: wallsOf(specimen),
		rounds: wallsOf(specimen, "rounds"),
		targets: feetOf(lay, specimen),
	};
}
