import type { Specimen } from "../../specimen/specimen";

/** What the bar and the handles do to an element's specimen. */
export interface CanvasInteraction {
	/** While a hand still moves: the plant regrows, `input` is told. */
	edit(change: (now: Specimen) => Specimen): void;
	/** The hand rests: `change` is told, and what was left out of growing meanwhile follows. */
	settle(): void;
}
