import { nothing } from "lit";
import { allBut } from "../../specimen/all_but";
import type { Tool } from "../../ui/tool";
import { applying, runningBy } from "../panel_groups";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";

/** Returns the tool whose pane is open; undefined where none is. At most one is open. */
function openIn(studio: Studio): Tool | undefined {
	const { modelUi, specimen } = studio.state;
	return applying(modelUi?.tools, specimen).find(({ pane }) => pane?.open(studio));
}

/** The open pane of a tool, beside the plant. */
export class Pane extends StudioPart {
	/** Returns the values whose change redraws the pane. */
	protected override shows(studio: Studio): readonly unknown[] {
		const { model, modelUi, tools, specimen } = studio.state;
		return [model, tools, openIn(studio), ...allBut(specimen, runningBy(modelUi?.tools))];
	}

	/** Renders the open pane. */
	protected override draw(studio: Studio): unknown {
		return openIn(studio)?.pane?.draw(studio) ?? nothing;
	}

	/** Marks the page while a pane is open. */
	protected override updated(): void {
		this.closest(".studio")?.toggleAttribute("data-pane", openIn(this.context) !== undefined);
	}
}

customElements.define("panicle-pane", Pane);
