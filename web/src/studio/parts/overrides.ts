import { html, nothing } from "lit";
import type { Studio } from "../studio";

/** Says that the grammar's inputs do not follow the handles, and offers to let them again. */
export function inputsOverride(studio: Studio): unknown {
	const { inputs } = studio.state.specimen;
	if (!inputs) return nothing;
	const { m, n } = inputs;
	const given = [m === undefined ? [] : [`m = ${m}`], n === undefined ? [] : [`n = ${n.join(", ")}`]].flat().join("; ");
	return html`<div class="override">
		<p>Set by the link in place of the profile: ${given}.</p>
		<button class="button" type="button" @click=${() => studio.drop("inputs")}>Follow the profile</button>
	</div>`;
}

/** Says that the bunch has a grammar of its own, shows it, and offers the built-in one. */
export function grammarOverride(studio: Studio): unknown {
	const { grammar } = studio.state.specimen;
	if (grammar === undefined) return nothing;
	return html`<div class="override">
		<p>This bunch brings a grammar of its own.</p>
		<pre tabindex="0" aria-label="Grammar">${grammar}</pre>
		<button class="button" type="button" @click=${() => studio.drop("grammar")}>Use the built-in grammar</button>
	</div>`;
}
