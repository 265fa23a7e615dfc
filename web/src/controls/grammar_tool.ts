import { html } from "lit";
import type { Plant } from "../plant/plant";
import type { WithGrammar } from "../specimen/grammar_text";
import type { Specimen } from "../specimen/specimen";
import type { Desk } from "./desk";
import type { Tool } from "./tool";

/** Says that the plant has a grammar of its own, shows it, and offers the built-in one. */
export function grammarTool<S extends Specimen & WithGrammar, G extends Plant>(
	group: string,
	noun: string,
): Tool<S, G> {
	const drop = (desk: Desk<S, G>) => {
		const { grammar: _, ...specimen } = desk.state.specimen;
		desk.replace(specimen as S);
	};
	return {
		name: "grammar",
		initial: undefined,
		applies: ({ grammar }) => grammar !== undefined,
		panel: {
			group,
			place: "above",
			draw: (desk) => html`<div class="override">
				<p>This ${noun} brings a grammar of its own.</p>
				<pre tabindex="0" aria-label="Grammar">${desk.state.specimen.grammar}</pre>
				<button class="button" type="button" @click=${() => drop(desk)}>Use the built-in grammar</button>
			</div>`,
		},
		remedy: { words: "Use the built-in grammar", press: drop },
	};
}
