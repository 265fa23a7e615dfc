import { html } from "lit";
import { canRedo, canUndo } from "../../specimen/history";
import { sameSpecimen } from "../../specimen/same";
import { icon } from "../../ui/icons";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";

/** The buttons Undo, Redo and Reset. */
export class HistoryBar extends StudioPart {
	protected override shows(studio: Studio): readonly unknown[] {
		const { history, specimen } = studio.state;
		return [canUndo(history), canRedo(history), sameSpecimen(specimen, studio.preset)];
	}

	protected override draw(studio: Studio): unknown {
		const { history, specimen } = studio.state;
		return html`<button
				class="button quiet icon" type="button" aria-label="Undo" title="Undo (Ctrl+Z)"
				?disabled=${!canUndo(history)} @click=${() => studio.undo()}
			>${icon("undo")}</button>
			<button
				class="button quiet icon" type="button" aria-label="Redo" title="Redo (Ctrl+Shift+Z)"
				?disabled=${!canRedo(history)} @click=${() => studio.redo()}
			>${icon("redo")}</button>
			<button
				class="button quiet icon" type="button" aria-label="Reset" title="Back to the preset as published"
				?disabled=${sameSpecimen(specimen, studio.preset)} @click=${() => studio.reset()}
			>${icon("reset")}</button>`;
	}
}

customElements.define("panicle-history", HistoryBar);
