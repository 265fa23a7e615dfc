import type { PageModel } from "../models/page_model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { OffscreenOptions } from "../ui/editor_context";
import type { UiState } from "./ui_state";

/** What the studio does outside itself; main.ts wires it. */
export interface StudioServices {
	/** Asks for growth, measured or not; the newest request wins. */
	grow(model: PageModel, specimen: Specimen, options: { preview: boolean }): void;
	/** What a specimen measures, without showing it; rejects as growing does, and with the signal's reason. */
	measure(model: PageModel, specimen: Specimen, signal: AbortSignal): Promise<Float32Array>;
	/** Grows a specimen without showing it (EditorContext.growOffscreen). */
	growOffscreen(specimen: Specimen, options: OffscreenOptions): Promise<Plant>;
	/** Ends a long growth. */
	cancel(): void;
	/** The document came to rest: the address bar is to hold it. */
	settled(model: PageModel, specimen: Specimen): void;
	/** The interface changed: remember in what. */
	remember(ui: UiState, before: UiState): void;
}
