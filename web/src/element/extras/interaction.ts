import type { Specimen } from "../../specimen/specimen";

/** Changes that the bar and the handles make to an element's specimen. */
export interface CanvasInteraction {
	/** Changes the specimen during a drag: grows a preview and dispatches `input`. */
	edit(change: (now: Specimen) => Specimen): void;
	/** Ends a drag: grows the full plant and dispatches `change`. */
	settle(): void;
}
