import { html } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { applying } from "../panel_groups";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";

/** The tools' bars below the 3-D view. */
export class Bars extends StudioPart {
	/** Returns the values whose change redraws the bars. */
	protected override shows({ state: { modelUi, specimen, model } }: Studio): readonly unknown[] {
		return [model, ...applying(modelUi?.tools, specimen)];
	}

	/** Renders the bar of each tool that has one. */
	protected override draw(studio: Studio): unknown {
		const { modelUi, specimen, model } = studio.state;
		return repeat(
			applying(modelUi?.tools, specimen).filter(({ bar }) => bar),
			({ name }) => `${model.name} ${name}`,
			({ bar }) => html`<div role="group" aria-label=${bar?.title ?? ""}>${bar?.draw(studio)}</div>`,
		);
	}
}

customElements.define("panicle-bars", Bars);
