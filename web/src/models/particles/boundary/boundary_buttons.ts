/** Buttons for touch screens: they add and remove points, obstacles and targets, as the keys do on grips. */
import { html, nothing } from "lit";
import type { Change, EditorContext } from "../../../ui/editor_context";
import { ACTIVE_GRIP } from "./active_grip";
import type { BoundedSpecimen } from "./bounded";
import { MOST_OBSTACLES, MOST_TARGETS } from "./details/places";
import { axisOf, type BoundaryLayout } from "./editor/boundary_layout";
import { boundaryPose } from "./editor/boundary_pose";
import { gripIn } from "./editor/grip";
import { asProfile } from "./editor/knot_grips";
import { targetsIn } from "./editor/target_grips";
import { countOfWalls, wallsOf, withRound, withWall } from "./editor/walls";
import type { WoodenPlant } from "./wooden_plant";

export function boundaryButtons<S extends BoundedSpecimen>(
	context: EditorContext<S, WoodenPlant>,
	layout: BoundaryLayout<S>,
): unknown {
	const { specimen } = context.state;
	const active = gripIn(boundaryPose(layout, specimen, context.preset), context.toolState(ACTIVE_GRIP));
	const button = (words: string, change: (() => Change) | undefined) => html`<button
		class="button" type="button" ?disabled=${!change} @click=${() => change && context.set(change())}
	>${words}</button>`;
	const room = countOfWalls(specimen) < MOST_OBSTACLES;
	return html`<div class="actions">
			${
				layout.form(specimen) === "spline"
					? button("Add a point", active?.add)
					: button("Shape by hand", () => shapedByHand(context, layout))
			}
			${button("Add an obstacle", room ? () => wallBeside(layout, specimen) : undefined)}
			${button("Add a round one", room ? () => roundBeside(layout, specimen) : undefined)}
			${button(active?.remove ? `Remove ${active.label.toLowerCase()}` : "Remove what is chosen", active?.remove)}
		</div>
		${targetsInWords(context, layout)}`;
}

/** Note on why dragging or the parameters have no effect on the targets, with a button that restores the parameters. */
function targetsInWords<S extends BoundedSpecimen>(
	context: EditorContext<S, WoodenPlant>,
	layout: BoundaryLayout<S>,
): unknown {
	const { specimen } = context.state;
	const them = `${layout.target.toLowerCase()}s`;
	if (specimen.targets) {
		return html`<div class="override">
			<p>The ${them} stand where hands have put them, whatever the numbers say.</p>
			<button class="button" type="button" @click=${() => context.set({ details: { targets: undefined } })}>
				${layout.target}s by number again</button>
		</div>`;
	}
	return targetsIn(layout, specimen).length > MOST_TARGETS
		? html`<div class="override"><p>More than ${MOST_TARGETS} ${them} are placed by number alone.</p></div>`
		: nothing;
}

function shapedByHand<S extends BoundedSpecimen>(
	{ state }: EditorContext<S, WoodenPlant>,
	layout: BoundaryLayout<S>,
): Change {
	const entry = state.model.table.entry("shape");
	const shape = entry?.kind === "choice" ? entry.options.indexOf("spline") : -1;
	return { parameters: { shape }, details: { profile: asProfile(layout, state.specimen) } };
}

function wallBeside<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): Change {
	const { halfWidth, low, high } = layout.box(specimen);
	const reach = high > 0 ? high : low;
	const walls = wallsOf(specimen).length;
	const x = axisOf(layout, specimen) + halfWidth * (0.7 + 0.2 * walls);
	return withWall(specimen, { x, y: 0.6 * reach }, halfWidth);
}

/** Such as a neighbour's crown: as large as the own boundary, and a little into it. */
function roundBeside<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): Change {
	const box = layout.box(specimen);
	const rounds = wallsOf(specimen, "rounds").length;
	return withRound(specimen, axisOf(layout, specimen) + box.halfWidth * (0.6 + 2 * rounds), box, 2 * box.halfWidth);
}
