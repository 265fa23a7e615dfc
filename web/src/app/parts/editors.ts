import { html } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { allBut } from "../../specimen/all_but";
import type { Tool } from "../../ui/tool";
import { applying, runningBy } from "../panel_groups";
import type { Studio } from "../studio";
import type { StudioState } from "../studio_state";
import { SOLID } from "../ui_state";
import { StudioPart } from "./studio_part";

/** The tools that have a flat view for this specimen. */
export function editorsOf({ modelUi, specimen }: Pick<StudioState, "modelUi" | "specimen">): readonly Tool[] {
	return applying(modelUi?.tools, specimen).filter(({ editor }) => editor);
}

/** The view that a phone shows. */
export function viewOf(state: Pick<StudioState, "modelUi" | "specimen" | "ui">): string {
	const { view } = state.ui;
	return editorsOf(state).some(({ name }) => name === view) ? view : SOLID;
}

/** The model's flat views with their handles, at the left of the 3-D view; on a phone one of them replaces it. */
export class Editors extends StudioPart {
	protected override shows({ state }: Studio): readonly unknown[] {
		const { model, modelUi, tools, grown, grownFrom } = state;
		return [
			model,
			modelUi,
			tools,
			grown,
			grownFrom,
			viewOf(state),
			...allBut(state.specimen, runningBy(modelUi?.tools)),
		];
	}

	protected override draw(studio: Studio): unknown {
		const view = viewOf(studio.state);
		const { model } = studio.state;
		return repeat(
			editorsOf(studio.state),
			({ name }) => `${model.name} ${name}`,
			({ name, editor }) => html`<section
				class="editor" data-editor=${name} ?data-shown=${name === view} aria-label="${editor?.title} view"
			>
				<h2>${editor?.title}</h2>
				${editor?.draw(studio)}
			</section>`,
		);
	}
}

customElements.define("panicle-editors", Editors);
