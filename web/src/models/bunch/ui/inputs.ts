import { html } from "lit";
import { text } from "../messages.generated";
import type { BunchContext, BunchTool } from "./context";

/**
 * Shows that the grammar's inputs, m and n of the paper (section 4.2: rachis segments, and segments of each axis), are
 * fixed by the link and do not follow the profile's handles, with a button that makes them follow again.
 */
export const inputs: BunchTool = {
	name: "inputs",
	initial: undefined,
	applies: (specimen) => specimen.inputs !== undefined,
	panel: { group: "shape", place: "above", draw },
};

/** Renders the inputs that replace those of the profile, and a button that removes them. */
function draw(context: BunchContext): unknown {
	const { m, n } = context.state.specimen.inputs ?? {};
	const fixedInputs: string[] = [];
	if (m !== undefined) fixedInputs.push(`m = ${m}`);
	if (n !== undefined) fixedInputs.push(`n = ${n.join(", ")}`);
	return html`<div class="override">
		<p>${text("inputs_from_link", { inputs: fixedInputs.join("; ") })}</p>
		<button class="button" type="button" @click=${() => removeInputs(context)}>${text("follow_profile")}</button>
	</div>`;
}

/** Removes the inputs from the specimen, so that they follow the profile again. */
function removeInputs(context: BunchContext): void {
	const { inputs: _, ...specimen } = context.state.specimen;
	context.replace(specimen);
}
