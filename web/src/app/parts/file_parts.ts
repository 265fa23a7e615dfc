/** Dialogs that the share and download sheets open. */
import { text } from "../messages.generated";
import type { LatePart } from "./open_part";

export const BATCH: LatePart = {
	tag: "panicle-batch",
	load: () => import("./batch_dialog"),
	failed: () => text("batch_failed"),
};
export const EMBED: LatePart = {
	tag: "panicle-embed",
	load: () => import("./embed_dialog"),
	failed: () => text("embed_failed"),
};
