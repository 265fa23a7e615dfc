/** What fingers press for what keys do to grips: points, obstacles and targets come and go. */
import { html, nothing } from "lit";
import type { Change, EditorContext } from "../../../ui/editor_context";
import type { BoundedSpecimen } from "./bounded";
import { MOST_OBSTACLES, MOST_TARGETS } from "./details/places";
import { boundaryPose } from "./editor/boundary_pose";
import { feetOf } from "./editor/feet";
import { gripIn } from "./editor/grip";
import { asProfile } from "./editor/knot_grips";
import { axisOf, type Lay } from "./editor/lay";
import { countOfWalls, wallsOf, withRound, withWall } from "./editor/walls";
import { MEANT } from "./meant";
import type { WoodenPlant } from "./wooden_plant";

export function boundaryButtons<S extends BoundedSpecimen>(
	context: EditorContext<S, WoodenPlant>,
	lay: Lay<S>,
): unknown {
	const { specimen } = context.state;
	const meant = gripIn(boundaryPose(lay, specimen, context.preset), context.toolState(MEANT));
	const button = (words: string, change: (() => Change) | undefined) => html`<button
		class="button" type="button" ?disabled=${!change} @click=${() => change && context.set(change())}
	>${words}</button>`;
	const room = countOfWalls(specimen) < MOST_OBSTACLES;
	return html`<div class="actions">
			${
				lay.form(specimen) === "spline"
					? button("Add a point", meant?.add)
					: button("Shape by hand", () => shapedByHand(context, lay))
			}
			${button("Add an obstacle", room ? () => wallBeside(lay, specimen) : undefined)}
			${button("Add a round one", room ? () => roundBeside(lay, specimen) : undefined)}
			${button(meant?.remove ? `Remove ${meant.label.toLowerCase()}` : "Remove what is chosen", meant?.remove)}
		</div>
		${targetsInWords(context, lay)}`;
}

/** Why numbers or hands do nothing to the targets, and the way out. */
function targetsInWords<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>, lay: Lay<S>): unknown {
	const { specimen } = context.state;
	const them = `${lay.target.toLowerCase()}s`;
	if (specimen.targets) {
		return html`<div class="override">
			<p>The ${them} stand where hands have put them, whatever the numbers say.</p>
			<button class="button" type="button" @click=${() => context.set({ details: { targets: undefined } })}>
				${lay.target}s by number again</button>
		</div>`;
	}
	return feetOf(lay, specimen).length > MOST_TARGETS
		? html`<div class="override"><p>More than ${MOST_TARGETS} ${them} are placed by number alone.</p></div>`
		: nothing;
}

function shapedByHand<S extends BoundedSpecimen>({ state }: EditorContext<S, WoodenPlant>, lay: Lay<S>): Change {
	const entry = state.model.table.entry("shape");
	const shape = entry?.kind === "choice" ? entry.options.indexOf("spline") : -1;
	return { parameters: { shape }, details: { profile: asProfile(lay, state.specimen) } };
}

function wallBeside<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): Change {
	const { halfWidth, low, high } = lay.box(specimen);
	const reach = high > 0 ? high : low;
	const walls = wallsOf(specimen).length;
	const x = axisOf(lay, specimen) + halfWidth * (0.7 + 0.2 * walls);
	return withWall(specimen, { x, y: 0.6 * reach }, halfWidth);
}

/** Such as a neighbour's crown: as large as the own boundary, and a little into it. */
function roundBeside<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): Change {
	const box = lay.box(specimen);
	const rounds = wallsOf(specimen, "rounds").length;
	return withRound(specimen, axisOf(lay, specimen) + box.halfWidth * (0.6 + 2 * rounds), box, 2 * box.halfWidth);
}
