/** The leaf's user interface: loaded with the first leaf, only in a page. */

import { html } from "lit";
import { term } from "../../../ui/term";
import type { ModelUi } from "../../../ui/tool";
import { watching } from "../../particles/watch";
import type { Leaf } from "../grown";
import { text } from "../messages.generated";
import type { LeafSpecimen } from "../specimen";
import { outline } from "./outline";
import { trace } from "./trace";

export const face: ModelUi<LeafSpecimen, Leaf> = {
	tools: [outline, trace, watching<LeafSpecimen, Leaf>()],
	readout: ({ counts }) => html`<h3>${text("particles")}</h3>
		<dl>
			${term(text("started"), counts.particles)} ${term(text("merged"), counts.merges)} ${term(text("steps"), counts.steps)}
			${term(text("vein_segments"), counts.segments)}
		</dl>`,
	get about() {
		return html`<p>${text("about_usage")}</p><p>${text("about_paper")}</p>`;
	},
};
