/** Parts that are loaded on demand and opened from anywhere on the page. */
import { text } from "../messages.generated";
import type { LatePart } from "./open_part";

export const HELP: LatePart = {
	tag: "panicle-help",
	load: () => import("../help/help"),
	failed: () => text("help_failed"),
};
export const HINTS: LatePart = {
	tag: "panicle-hints",
	load: () => import("../hints/hints"),
	failed: () => text("hints_failed"),
};
export const SHORTCUTS: LatePart = {
	tag: "panicle-shortcuts",
	load: () => import("../help/shortcut_sheet"),
	failed: () => text("shortcuts_failed"),
};
export const BROWSE: LatePart = {
	tag: "panicle-browse",
	load: () => import("./browse_dialog"),
	failed: () => text("browse_failed"),
};
export const SAVED: LatePart = {
	tag: "panicle-saved",
	load: () => import("./saved_dialog"),
	failed: () => text("saved_failed"),
};
export const SHARE: LatePart = {
	tag: "panicle-share-sheet",
	load: () => import("./share_sheet"),
	failed: () => text("share_failed"),
};
export const DOWNLOADS: LatePart = {
	tag: "panicle-downloads",
	load: () => import("./download_sheet"),
	failed: () => text("download_failed"),
};
export const PALETTE: LatePart = {
	tag: "panicle-palette",
	load: () => import("../palette/palette"),
	failed: () => text("palette_failed"),
};
