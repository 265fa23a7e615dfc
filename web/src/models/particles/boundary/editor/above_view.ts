/** A flat view from above, with the plant's branches behind its grips. */
import type { TrailPlant } from "../../trails";
import { BranchDrawing } from "./branches";
import { FROM_ABOVE } from "./facing";
import type { BoundaryFrame } from "./frame";
import { GripView } from "./grip_view";

export abstract class AboveView extends GripView {
	static override properties = { ...GripView.properties, grown: { attribute: false }, preview: { attribute: false } };
	declare grown: TrailPlant | undefined;
	/** Whether the plant is a preview that the next one replaces soon. */
	declare preview: boolean;

	readonly #branches = new BranchDrawing(FROM_ABOVE);

	/** The frame that maps metres, seen from above, to the element. */
	protected abstract ground(): BoundaryFrame;

	/** Skips previews, except while the user drags here: drawing branches in every view would take too long. */
	protected override ink(canvas: HTMLCanvasElement): void {
		if (!this.preview || this.drags.active) this.#branches.show(canvas, this.grown, this.ground());
	}
}
