/** Buttons for touch screens: they add and remove points, obstacles and targets, as the keys do on grips. */

import { html, nothing } from "lit";
import type { Change, EditorContext } from "../../../ui/editor_context";
import { text } from "../messages.generated";
import { ACTIVE_GRIP } from "./active_grip";
import type { BoundedSpecimen } from "./bounded";
import { MAX_OBSTACLES, MAX_TARGETS } from "./details/places";
import { axisOf, type BoundaryLayout } from "./editor/boundary_layout";
import { boundaryPose } from "./editor/boundary_pose";
import { gripIn } from "./editor/grip";
import { asProfile } from "./editor/knot_grips";
import { targetsIn } from "./editor/target_grips";
import { countOfWalls, wallsOf, withRound, withWall } from "./editor/walls";
import type { WoodenPlant } from "./wooden_plant";

/** Renders the buttons; those without an effect on the active grip are disabled. */
export function boundaryButtons<S extends BoundedSpecimen>(
	context: EditorContext<S, WoodenPlant>,
	layout: BoundaryLayout<S>,
): unknown {
	const { specimen } = context.state;
	const active = gripIn(boundaryPose(layout, specimen, context.preset), context.toolState(ACTIVE_GRIP));
	const button = (label: string, change: (() => Change) | undefined) => html`<button
		class="button" type="button" ?disabled=${!change} @click=${() => change && context.set(change())}
	>${label}</button>`;
	const room = countOfWalls(specimen) < MAX_OBSTACLES;
	return html`<div class="actions">
			${
				layout.form(specimen) === "spline"
					? button(text("add_point"), active?.add)
					: button(text("edit_outline"), () => toSpline(context, layout))
			}
			${button(text("add_obstacle"), room ? () => addWall(layout, specimen) : undefined)}
			${button(text("add_round_obstacle"), room ? () => addRound(layout, specimen) : undefined)}
			${button(text("delete_selection"), active?.remove)}
		</div>
		${targetsInWords(context, layout)}`;
}

/**
 * Renders a note on why dragging or the parameters have no effect on the targets, with a button that restores the
 * parameters.
 */
function targetsInWords<S extends BoundedSpecimen>(
	context: EditorContext<S, WoodenPlant>,
	layout: BoundaryLayout<S>,
): unknown {
	const { specimen } = context.state;
	const kind = layout.target;
	if (specimen.targets) {
		return html`<div class="override">
			<p>${text("targets_by_hand", { kind })}</p>
			<button class="button" type="button" @click=${() => context.set({ details: { targets: undefined } })}>
				${text("targets_reset", { kind })}</button>
		</div>`;
	}
	return targetsIn(layout, specimen).length > MAX_TARGETS
		? html`<div class="override"><p>${text("targets_too_many", { kind, most: MAX_TARGETS })}</p></div>`
		: nothing;
}

/** Returns the change that makes the outline a spline of the same shape, which can be edited point by point. */
function toSpline<S extends BoundedSpecimen>(
	{ state }: EditorContext<S, WoodenPlant>,
	layout: BoundaryLayout<S>,
): Change {
	const entry = state.model.table.entry("shape");
	const shape = entry?.kind === "choice" ? entry.options.indexOf("spline") : -1;
	return { parameters: { shape }, details: { profile: asProfile(layout, state.specimen) } };
}

/** Returns the change that adds a box obstacle beside the boundary, farther out than the existing ones. */
function addWall<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): Change {
	const { halfWidth, low, high } = layout.box(specimen);
	const end = high > 0 ? high : low;
	const walls = wallsOf(specimen).length;
	const x = axisOf(layout, specimen) + halfWidth * (0.7 + 0.2 * walls);
	return withWall(specimen, { x, y: 0.6 * end }, halfWidth);
}

/**
 * Returns the change that adds an ellipsoid beside the boundary, such as a neighbour's crown: as large as the boundary,
 * and a little into it.
 */
function addRound<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): Change {
	const box = layout.box(specimen);
	const rounds = wallsOf(specimen, "rounds").length;
	return withRound(specimen, axisOf(layout, specimen) + box.halfWidth * (0.6 + 2 * rounds), box, 2 * box.halfWidth);
}
