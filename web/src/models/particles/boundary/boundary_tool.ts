/** The tools that trees and roots share, made for a model's own lay-out: the boundary's view, walls, a mesh of one's own. */
import { html, nothing } from "lit";
import type { Desk } from "../../../controls/desk";
import type { Tool } from "../../../controls/tool";
import type { BoundedSpecimen } from "./bounded";
import { MOST_OBSTACLES } from "./details/places";
import { asProfile, boundaryPose, withKnot, withoutKnot } from "./editor/boundary_pose";
import type { BoundaryScene } from "./editor/boundary_view";
import { feetOf } from "./editor/feet";
import type { GripEvent } from "./editor/grip";
import { footprintIn, type Lay, loopsIn } from "./editor/lay";
import { planPose } from "./editor/plan_pose";
import type { PlanScene } from "./editor/plan_view";
import { countOfWalls, wallsOf, withoutWall, withRound, withWall } from "./editor/walls";
import type { WoodenPlant } from "./wooden_plant";
import "./editor/boundary_view";
import "./editor/plan_view";

/** Grip that was last touched: the one that the buttons mean. */
type Meant = string;

/** The flat view of outer and inner boundary. */
export function boundaryTool<S extends BoundedSpecimen>(lay: Lay<S>, group: string): Tool<S, WoodenPlant, Meant> {
	type Own = Desk<S, WoodenPlant>;
	const tool: Tool<S, WoodenPlant, Meant> = {
		name: "boundary",
		initial: "",
		editor: { title: "Boundary", draw: (desk) => draw(desk) },
		panel: { group, place: "below", draw: (desk) => buttons(desk) },
		keys: [
			{
				keys: ["Insert", "Delete"],
				does: "On a point of the boundary: one more after it, or one fewer; on a target: one fewer",
			},
		],
	};
	const draw = (desk: Own) => html`<panicle-boundary
		.pose=${boundaryPose(lay, desk.state.specimen, desk.preset)} .scene=${sceneOf(lay, desk.state.specimen)}
		.grown=${desk.state.grown}
		@grip-input=${({ detail }: GripEvent) => desk.edit(detail)} @grip-change=${() => desk.settle()}
		@grip-focus=${({ detail }: CustomEvent<string>) => desk.setToolState(tool, detail)}
	></panicle-boundary>`;
	const buttons = (desk: Own) => {
		const { specimen } = desk.state;
		const meant = desk.toolState(tool);
		const spline = lay.form(specimen) === "spline";
		const [added, removed] = [withKnot(lay, specimen, meant), withoutKnot(lay, specimen, meant)];
		return html`<div class="actions">
			${
				spline
					? html`<button class="button" type="button" ?disabled=${!added} @click=${() => added && desk.set(added)}>Add a point</button>
						<button class="button" type="button" ?disabled=${!removed} @click=${() => removed && desk.set(removed)}>Remove the point</button>`
					: html`<button class="button" type="button" @click=${() => shapeByHand(desk)}>Shape by hand</button>`
			}
			<button
				class="button" type="button" ?disabled=${countOfWalls(specimen) >= MOST_OBSTACLES}
				@click=${() => desk.set(wallBeside(lay, specimen))}
			>Add an obstacle</button>
			<button
				class="button" type="button" ?disabled=${countOfWalls(specimen) >= MOST_OBSTACLES}
				@click=${() => desk.set(roundBeside(lay, specimen))}
			>Add a round one</button>
			${
				specimen.obstacles || specimen.rounds
					? html`<button class="button" type="button" @click=${() => desk.set(withoutWall(specimen))}>Remove an obstacle</button>`
					: nothing
			}
		</div>`;
	};
	const shapeByHand = (desk: Own) => {
		const { specimen, model } = desk.state;
		const entry = model.table.entry("shape");
		const shape = entry?.kind === "choice" ? entry.options.indexOf("spline") : -1;
		desk.set({ parameters: { shape }, details: { profile: asProfile(lay, specimen) } });
	};
	return tool;
}

function wallBeside<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S) {
	const { halfWidth, low, high } = lay.box(specimen);
	const axis = lay.axes(specimen).at(-1) ?? 0;
	const reach = high > 0 ? high : low;
	const walls = wallsOf(specimen).length;
	return withWall(specimen, { x: axis + halfWidth * (0.4 + 0.2 * walls), y: reach }, 2 * halfWidth);
}

/** Such as a neighbour's crown: as large as the own boundary, and a little into it. */
function roundBeside<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S) {
	const box = lay.box(specimen);
	const axis = lay.axes(specimen).at(-1) ?? 0;
	const rounds = wallsOf(specimen, "rounds").length;
	return withRound(specimen, axis + box.halfWidth * (0.6 + 2 * rounds), box, 2 * box.halfWidth);
}

export function sceneOf<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): BoundaryScene {
	return {
		box: lay.box(specimen),
		axes: lay.axes(specimen),
		loops: loopsIn(lay, specimen),
		inner: specimen.parameters.inner,
		bareAbout: lay.bareAbout(lay.box(specimen)),
		walls: wallsOf(specimen),
		rounds: wallsOf(specimen, "rounds"),
		targets: feetOf(lay, specimen),
	};
}

/** The flat view from above: depth of the boundary, obstacles, targets. */
export function planTool<S extends BoundedSpecimen>(lay: Lay<S>): Tool<S, WoodenPlant> {
	return {
		name: "plan",
		initial: undefined,
		editor: {
			title: "Plan",
			draw: (desk) => html`<panicle-plan
				.pose=${planPose(lay, desk.state.specimen, desk.preset)} .scene=${planOf(lay, desk.state.specimen)}
				@grip-input=${({ detail }: GripEvent) => desk.edit(detail)} @grip-change=${() => desk.settle()}
			></panicle-plan>`,
		},
	};
}

export function planOf<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): PlanScene {
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
