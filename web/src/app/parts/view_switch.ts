import { html, nothing } from "lit";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import { SOLID } from "../ui_state";
import { editorsOf, viewOf } from "./editors";
import { StudioPart } from "./studio_part";

/** Chooses the view that a phone shows. */
export class ViewSwitch extends StudioPart {
	/** Returns the values whose change redraws the switch. */
	protected override shows({ state }: Studio): readonly unknown[] {
		return [state.modelUi, viewOf(state), ...editorsOf(state)];
	}

	/** Renders the choice between the flat editors and the 3-D view; nothing for models without editors. */
	protected override draw(studio: Studio): unknown {
		const editors = editorsOf(studio.state);
		if (editors.length === 0) return nothing;
		const shown = viewOf(studio.state);
		const views = [
			...editors.map(({ name, editor }) => [name, editor?.title] as const),
			[SOLID, text("view_3d")] as const,
		];
		return html`<fieldset class="switch">
			<legend class="unseen">${text("view")}</legend>
			${views.map(
				([name, words]) => html`<label>
					<input
						type="radio" name=${this.idOf("view")} .checked=${name === shown} @change=${() => studio.setUi({ view: name })}
					>${words}
				</label>`,
			)}
		</fieldset>`;
	}

	/** Marks the page with the view that a phone shows. */
	protected override updated(): void {
		const { state } = this.context;
		const page = this.closest<HTMLElement>(".studio");
		page?.setAttribute("data-view", viewOf(state));
		// Until the tools are loaded, reserve the space for flat views.
		page?.toggleAttribute("data-one-view", state.modelUi !== undefined && editorsOf(state).length === 0);
	}
}

customElements.define("panicle-view-switch", ViewSwitch);
