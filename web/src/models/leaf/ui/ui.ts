/** The leaf's user interface: loaded with the first leaf, only in a page. */
import { html } from "lit";
import { term } from "../../../ui/term";
import type { ModelUi } from "../../../ui/tool";
import { watching } from "../../particles/watch";
import type { Leaf } from "../grown";
import type { LeafSpecimen } from "../specimen";
import { outline } from "./outline";
import { trace } from "./trace";

export const face: ModelUi<LeafSpecimen, Leaf> = {
	tools: [outline, trace, watching<LeafSpecimen, Leaf>()],
	readout: ({ counts }) => html`<h3>Particles</h3>
		<dl>
			${term("Started", counts.particles)} ${term("Merged", counts.merges)} ${term("Steps", counts.steps)}
			${term("Pieces of vein", counts.segments)}
		</dl>`,
	about: html`<p>
			Drag the points of a leaf’s outline and particles run from all over the blade to the petiole; their trails are its
			veins. A double click on the margin puts a point in, one on a point changes its kind; or trace a picture.
		</p>
		<p>
			After Y. Rodkaew, P. Chongstitvatana, S. Siripant and C. Lursinsap, “Particle systems for plant modeling” (2003).
		</p>`,
};
