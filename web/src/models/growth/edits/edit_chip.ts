/** Card over the 3-D view with the chosen branch and the actions on it. */
import { html, nothing } from "lit";
import { text } from "../messages.generated";
import { branchesOf, neighbourOf, siblingsOf } from "./branches";
import {
	act,
	branchInWords,
	canShape,
	choose,
	chosenBranch,
	type EditContext,
	editing,
	hasEdit,
	reset,
	USUAL_CUT,
} from "./edit_state";

/** Draws the chooser and, with a chosen branch, its actions; nothing while the tool is off. */
export function drawChip(context: EditContext): unknown {
	const state = context.toolState(editing);
	const { grown, specimen } = context.state;
	if (!state.on || !grown) return nothing;
	const branch = chosenBranch(context);
	const words = branch ? branchInWords(grown, branch) : text("branch_none");
	const siblings = branch ? siblingsOf(branchesOf(grown), branch) : [];
	const number = branch ? siblings.indexOf(branch.address) + 1 : 0;
	const shaped = branch !== undefined && canShape(specimen, branch.address);
	return html`<span class="branch-chooser" role="spinbutton" tabindex="0" aria-label=${text("branch")}
			aria-valuemin=${branch ? 1 : 0} aria-valuemax=${siblings.length} aria-valuenow=${number} aria-valuetext=${words}
			@keydown=${(event: KeyboardEvent) => pressed(context, event)}
		>${words}</span>
		${
			branch
				? html`<span class="branch-actions">
			${action(text("branch_prune"), () => act(context, "prune"))}
			${action(text("branch_break"), () => act(context, "break"))}
			${action(text("branch_dead"), () => act(context, "dead"), { pressed: hasEdit(specimen.edits, branch.address, "dead") })}
			${action(text("branch_draw"), () => context.setToolState(editing, { ...state, drawing: !state.drawing }), { pressed: state.drawing, disabled: !shaped })}
			${action(text("branch_reset"), () => reset(context), { disabled: !hasEdit(specimen.edits, branch.address) })}
		</span>`
				: nothing
		}`;
}

/** Draws a button of an action. */
function action(
	label: string,
	run: () => void,
	{ pressed, disabled = false }: { pressed?: boolean; disabled?: boolean } = {},
): unknown {
	return html`<button class="button" type="button" aria-pressed=${pressed ?? nothing} ?disabled=${disabled} @click=${run}>${label}</button>`;
}

const DIRECTIONS = { ArrowRight: "next", ArrowLeft: "previous", ArrowUp: "child", ArrowDown: "parent" } as const;

/** Handles a key on the chooser: arrows go to another branch, letters act on it. */
function pressed(context: EditContext, event: KeyboardEvent): void {
	const { key, ctrlKey, metaKey, altKey } = event;
	const { grown } = context.state;
	if (ctrlKey || metaKey || altKey || !grown) return;
	if (key in DIRECTIONS) {
		const { chosen } = context.toolState(editing);
		const address = neighbourOf(branchesOf(grown), chosen?.address, DIRECTIONS[key as keyof typeof DIRECTIONS]);
		if (address !== undefined) choose(context, { address, at: USUAL_CUT });
	} else if (key === "p" || key === "Delete") act(context, "prune");
	else if (key === "b") act(context, "break");
	else if (key === "d") act(context, "dead");
	else if (key === "r" || key === "Backspace") reset(context);
	else return;
	event.preventDefault();
	event.stopPropagation();
}
