/** List of the edits of branches in the panel, each with its place and a button that removes it. */
import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { text } from "../messages.generated";
import { type BranchEdit, cutShare } from "./branch_edit";
import { branchesOf } from "./branches";
import { branchInWords, changeOf, choose, type EditContext, editing, enter, USUAL_CUT } from "./edit_state";

/** Draws the list; nothing where there are no edits and the tool is off. */
export function drawEdits(context: EditContext): unknown {
	const { edits } = context.state.specimen;
	if (edits.length === 0) return context.toolState(editing).on ? html`<p>${text("branch_usage")}</p>` : nothing;
	return html`<h3>${text("branch_edits")}</h3>
		<ol class="branch-edits" aria-label=${text("branch_edits")}>
			${edits.map((edit, i) => html`<li>${drawEdit(context, edit, i)}</li>`)}
		</ol>
		<div class="actions">
			<button class="button" type="button" @click=${() => context.set(changeOf([]))}>${text("branch_edits_remove")}</button>
		</div>`;
}

/** Draws one edit: its branch, the place of a cut, and the button that removes it. */
function drawEdit(context: EditContext, edit: BranchEdit, index: number): unknown {
	const { grown, specimen } = context.state;
	const branch = grown && branchesOf(grown).byAddress.get(edit.shoot);
	const name = text("branch_edit_named", {
		kind: text(`branch_edit_${edit.kind}`),
		branch: grown && branch ? branchInWords(grown, branch) : text("branch_missing"),
	});
	const others = specimen.edits.filter((_, i) => i !== index);
	return html`<button class="button" type="button" ?disabled=${!branch} @click=${() => show(context, edit)}>${name}</button>
		${
			"at" in edit
				? html`<label>${text("branch_cut_at")} <input type="number" min="1" max="99" .value=${live(String(Math.round(100 * edit.at)))}
					@change=${({ target }: Event) => moveCut(context, index, Number((target as HTMLInputElement).value))}> %</label>`
				: nothing
		}
		<button class="button" type="button" aria-label=${text("branch_edit_remove_named", { name })}
			@click=${() => context.set(changeOf(others))}>${text("branch_edit_remove")}</button>`;
}

/** Turns the tool on with the edit's branch chosen. */
function show(context: EditContext, edit: BranchEdit): void {
	if (!context.toolState(editing).on) enter(context);
	choose(context, { address: edit.shoot, at: "at" in edit ? edit.at : USUAL_CUT });
}

/** Moves a cut to a share of its branch in percent; any other number changes nothing. */
function moveCut(context: EditContext, index: number, percent: number): void {
	const { edits } = context.state.specimen;
	if (!(percent >= 1 && percent <= 99)) context.setToolState(editing, { ...context.toolState(editing) });
	else
		context.set(
			changeOf(edits.map((each, i) => (i === index && "at" in each ? { ...each, at: cutShare(percent / 100) } : each))),
		);
}
