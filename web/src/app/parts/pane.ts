import { nothing } from "lit";
import { allBut } from "../../specimen/all_but";
import type { Tool } from "../../ui/tool";
import { applying, runningBy } from "../panel_groups";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";

/** The tool whose pane is open; at most one. */
function openIn(studio: Studio): Tool | undefined {
	const { modelUi, specimen } = studio.state;
	return applying(modelUi?.tools, specimen).find(({ pane }) => pane?.open(studio));
}

/** The open pane of a tool, beside the plant. */
export class Pane extends StudioPart {
	protected override shows(studio: Studio): readonly unknown[] {
		const { model, modelUi, tools, specimen } = studio.state;
		return [model, tools, openIn(studio), ...allBut(specimen, runningBy(modelUi?.tools))];
	}

	protected override draw(studio: Studio): unknown {
		return openIn(studio)?.pane?.draw(studio) ?? nothing;
	}

	protected override updated(): void {
		this.closest(".studio")?.toggleAttribute("data-pane", openIn(this.context) !== undefined);
	}
}

customElements.define("panicle-pane", Pane);
