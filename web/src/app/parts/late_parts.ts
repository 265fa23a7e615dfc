/** Parts that are loaded on demand and opened from anywhere on the page. */
import type { LatePart } from "./open_part";

export const HELP: LatePart = {
	tag: "panicle-help",
	load: () => import("./help"),
	failed: "The help could not be fetched",
};
export const SAVED: LatePart = {
	tag: "panicle-saved",
	load: () => import("./saved_dialog"),
	failed: "What is saved could not be shown",
};
