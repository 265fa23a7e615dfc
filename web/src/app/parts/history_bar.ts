import { html } from "lit";
import { canRedo, canUndo } from "../../specimen/history";
import { sameSpecimen } from "../../specimen/same";
import { icon } from "../../ui/icons";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";

/** The buttons Undo, Redo and Reset. */
export class HistoryBar extends StudioPart {
	/** Returns the values whose change redraws the buttons. */
	protected override shows(studio: Studio): readonly unknown[] {
		const { history, specimen } = studio.state;
		return [canUndo(history), canRedo(history), sameSpecimen(specimen, studio.preset)];
	}

	/** Renders buttons for undo, redo and the preset's own values. */
	protected override draw(studio: Studio): unknown {
		const { history, specimen } = studio.state;
		return html`<button
				class="button quiet icon" type="button" aria-label=${text("undo")} title=${text("undo_title")}
				?disabled=${!canUndo(history)} @click=${() => studio.undo()}
			>${icon("undo")}</button>
			<button
				class="button quiet icon" type="button" aria-label=${text("redo")} title=${text("redo_title")}
				?disabled=${!canRedo(history)} @click=${() => studio.redo()}
			>${icon("redo")}</button>
			<button
				class="button quiet icon" type="button" aria-label=${text("reset")} title=${text("reset_title")}
				?disabled=${sameSpecimen(specimen, studio.preset)} @click=${() => studio.reset()}
			>${icon("reset")}</button>`;
	}
}

customElements.define("panicle-history", HistoryBar);
