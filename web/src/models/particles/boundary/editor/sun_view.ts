/** `<panicle-sun>`: the sky from above with the sun, over the tree's branches. */

import { svg, type TemplateResult } from "lit";
import { text } from "../../messages.generated";
import type { TrailPlant } from "../../trails";
import { AboveView } from "./above_view";
import { type BoundaryFrame, frameAbout, toScreen } from "./frame";

/** Elevations of the rings, degrees. */
const RINGS = [0, 30, 60];
const WORDS = [
	["front", 0, -1],
	["back", 0, 1],
] as const;

/** Radius of the tree in the drawing, as a share of the sky's radius. */
const REACH = 0.5;

export class SunView extends AboveView {
	protected readonly heading = text("sun_view");
	protected readonly help = text("sun_help");

	/** Returns the frame of the sky: a disc of radius 1 with some room. */
	protected fit(): BoundaryFrame {
		return frameAbout({ halfWidth: 1.12, low: -1.12, high: 1.12 }, this.size.width, this.size.height);
	}

	/** Draws circles of equal height above the horizon, the direction of the light, and the cardinal points. */
	protected drawing(frame: BoundaryFrame): TemplateResult {
		const middle = toScreen(frame, { x: 0, y: 0 });
		const sun = this.pose && toScreen(frame, this.pose.grips[0].at);
		return svg`${RINGS.map((height) => svg`<circle class=${height === 0 ? "outer" : "ring"} cx=${middle.x} cy=${middle.y} r=${frame.scale * (1 - height / 90)}></circle>`)}
			${sun ? svg`<line class="ray" x1=${sun.x} y1=${sun.y} x2=${middle.x} y2=${middle.y}></line>` : ""}
			<circle class="target" cx=${middle.x} cy=${middle.y} r="3"></circle>
			${WORDS.map(([word, x, y]) => {
				const at = toScreen(frame, { x, y: 1.1 * y });
				return svg`<text x=${at.x} y=${at.y + 3} text-anchor="middle">${text(word)}</text>`;
			})}`;
	}

	/** Returns the frame of the branches, scaled so that the tree takes REACH of the sky's radius. */
	protected ground(): BoundaryFrame {
		const { grown, frame } = this;
		return { ...frame, scale: (REACH * frame.scale) / (grown ? reachOf(grown) : 1) };
	}
}

/** Returns the largest horizontal distance of the branches from the axis, metres; 1 without branches. */
function reachOf({ segments: { ends } }: TrailPlant): number {
	let square = 0;
	for (let at = 0; at < ends.length; at += 3) square = Math.max(square, ends[at] ** 2 + ends[at + 2] ** 2);
	return Math.sqrt(square) || 1;
}

customElements.define("panicle-sun", SunView);
