import { html } from "lit";
import type { Studio } from "../studio";
import type { View } from "../types";
import { StudioElement } from "./studio_element";

const VIEWS: readonly [View, string][] = [
	["front", "Front"],
	["side", "Side"],
	["solid", "3-D"],
];

/** A phone shows one view at a time; this chooses which. */
export class ViewSwitch extends StudioElement {
	protected override draw(studio: Studio): unknown {
		const { view } = studio.state.ui;
		return html`<fieldset class="switch">
			<legend class="unseen">View</legend>
			${VIEWS.map(
				([key, words]) => html`<label>
					<input type="radio" name="view" .checked=${key === view} @change=${() => studio.setUi({ view: key })}>${words}
				</label>`,
			)}
		</fieldset>`;
	}

	protected override updated(): void {
		this.closest<HTMLElement>(".studio")?.setAttribute("data-view", this.studio.state.ui.view);
	}
}

customElements.define("panicle-view-switch", ViewSwitch);
