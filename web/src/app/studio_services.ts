import type { PageModel } from "../models/page_model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { OffscreenOptions } from "../ui/editor_context";
import type { UiState } from "./ui_state";

/** The studio's access to the core, the address bar and storage; main.ts provides it. */
export interface StudioServices {
	/** Requests growth for display; the newest request wins. */
	grow(model: PageModel, specimen: Specimen, options: { preview: boolean }): void;
	/** Measures a specimen without showing it. Rejects as growing does, and with the signal's reason. */
	measure(model: PageModel, specimen: Specimen, signal: AbortSignal): Promise<Float32Array>;
	/** Grows a specimen without showing it (EditorContext.growOffscreen). */
	growOffscreen(specimen: Specimen, options: OffscreenOptions): Promise<Plant>;
	/** Cancels the running growths. */
	cancel(): void;
	/** Called when the document is at rest: writes it to the address bar. */
	settled(model: PageModel, specimen: Specimen): void;
	/** Called when the interface state changes: stores the difference. */
	remember(ui: UiState, before: UiState): void;
}
