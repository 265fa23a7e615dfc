/** The flat view from above: depth of the boundary, obstacles, targets. */
import { html } from "lit";
import { guard } from "lit/directives/guard.js";
import type { EditorContext } from "../../../ui/editor_context";
import type { Tool } from "../../../ui/tool";
import type { BoundedSpecimen } from "./bounded";
import { feetOf } from "./editor/feet";
import type { GripEvent } from "./editor/grip";
import { footprintIn, type Lay, layingOut } from "./editor/lay";
import { planPose } from "./editor/plan_pose";
import type { PlanScene } from "./editor/plan_view";
import { wallsOf } from "./editor/walls";
import { MEANT } from "./meant";
import type { WoodenPlant } from "./wooden_plant";
import "./editor/plan_view";

export function planTool<S extends BoundedSpecimen>(lay: Lay<S>): Tool<S, WoodenPlant> {
	return { name: "plan", initial: undefined, editor: { title: "Plan", draw: (context) => draw(context, lay) } };
}

function draw<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>, lay: Lay<S>): unknown {
	const { specimen, grown, held } = context.state;
	const laidBy = layingOut(context);
	return html`<panicle-plan
		.pose=${guard(laidBy, () => planPose(lay, specimen, context.preset))} .scene=${guard(laidBy, () => sceneOf(lay, specimen))}
		.grown=${grown} .preview=${held}
		@grip-input=${({ detail }: GripEvent) => context.edit(detail)} @grip-change=${() => context.settle()}
		@grip-focus=${({ detail }: CustomEvent<string>) => context.setToolState(MEANT, detail)}
	></panicle-plan>`;
}

function sceneOf<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): PlanScene {
	return {
		halfWidth: lay.box(specimen).halfWidth,
		halfDepth: lay.halfDepth(specimen),
		axes: lay.axes(specimen),
		loops: footprintIn(lay, specimen),
		walls: wallsOf(specimen),
		rounds: wallsOf(specimen, "rounds"),
		targets: feetOf(lay, specimen),
	};
}
