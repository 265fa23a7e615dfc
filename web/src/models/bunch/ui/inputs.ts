import { html } from "lit";
import type { BunchContext, BunchTool } from "./context";

/** Shows that the grammar's inputs do not follow the handles, with a button to reset them. */
export const inputs: BunchTool = {
	name: "inputs",
	initial: undefined,
	applies: (specimen) => specimen.inputs !== undefined,
	panel: { group: "shape", place: "above", draw },
};

function draw(context: BunchContext): unknown {
	const { m, n } = context.state.specimen.inputs ?? {};
	const given = [m === undefined ? [] : [`m = ${m}`], n === undefined ? [] : [`n = ${n.join(", ")}`]].flat().join("; ");
	return html`<div class="override">
		<p>Set by the link in place of the profile: ${given}.</p>
		<button class="button" type="button" @click=${() => follow(context)}>Follow the profile</button>
	</div>`;
}

function follow(context: BunchContext): void {
	const { inputs: _, ...specimen } = context.state.specimen;
	context.replace(specimen);
}
