/** A flat view from above, with the branches that grew behind its grips. */
import type { TrailPlant } from "../../trails";
import { BranchDrawing } from "./branches";
import { FROM_ABOVE } from "./facing";
import type { Frame } from "./frame";
import { GripView } from "./grip_view";

export abstract class AboveView extends GripView {
	static override properties = { ...GripView.properties, grown: { attribute: false }, preview: { attribute: false } };
	declare grown: TrailPlant | undefined;
	/** Whether the plant is on its way to the next. */
	declare preview: boolean;

	readonly #branches = new BranchDrawing(FROM_ABOVE);

	/** How metres about the origin, seen from above, lie in the element. */
	protected abstract ground(): Frame;

	/** In passing it stays as it is, unless a hand is at work here: no frame has time to draw a plant in every view. */
	protected override ink(canvas: HTMLCanvasElement): void {
		if (!this.preview || this.drags.active) this.#branches.show(canvas, this.grown, this.ground());
	}
}
