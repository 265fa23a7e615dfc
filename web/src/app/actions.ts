/** The page's actions: its keyboard shortcuts, their list and the command palette take them from here. */
import { canRedo, canUndo } from "../specimen/history";
import { sameSpecimen } from "../specimen/same";
import type { IconName } from "../ui/icons";
import { copyLink } from "./copy_link";
import { text } from "./messages.generated";
import { BROWSE, DOWNLOADS, HELP, PALETTE, SAVED, SHARE, SHORTCUTS } from "./parts/late_parts";
import { openPart } from "./parts/open_part";
import { offersRoom, openRoom } from "./parts/open_room";
import type { Studio } from "./studio";
import type { StudioState } from "./studio_state";

/** Keys that are pressed together. */
export interface KeyCombination {
	/** As events name it, in lower case: "z", "?", "f1". */
	readonly key: string;
	/** Whether Ctrl, or ⌘, is held. */
	readonly ctrl?: boolean;
	readonly shift?: boolean;
}

export interface PageAction {
	/** Names it among the actions: "undo". */
	readonly key: string;
	readonly icon?: IconName;
	title(state: Pick<StudioState, "dark">): string;
	/** Description in the list of shortcuts, if the title is not sufficient. */
	description?(): string;
	readonly shortcuts?: readonly KeyCombination[];
	/** The group in the list of shortcuts; absent: "general". */
	readonly group?: "view";
	/** Whether its shortcuts work in text fields, too. */
	readonly everywhere?: boolean;
	/** Whether it can be run now; absent: always. */
	isAvailable?(studio: Studio): boolean;
	run(studio: Studio): void;
}

/** All actions, in the order of lists. */
export const ACTIONS: readonly PageAction[] = [
	{
		key: "undo",
		icon: "undo",
		title: () => text("undo"),
		shortcuts: [{ key: "z", ctrl: true }],
		isAvailable: ({ state }) => canUndo(state.history),
		run: (studio) => studio.undo(),
	},
	{
		key: "redo",
		icon: "redo",
		title: () => text("redo"),
		shortcuts: [
			{ key: "z", ctrl: true, shift: true },
			{ key: "y", ctrl: true },
		],
		isAvailable: ({ state }) => canRedo(state.history),
		run: (studio) => studio.redo(),
	},
	{
		key: "palette",
		icon: "search",
		title: () => text("palette"),
		shortcuts: [{ key: "k", ctrl: true }],
		everywhere: true,
		run: (studio) => void openPart(studio, PALETTE),
	},
	{
		key: "browse",
		icon: "search",
		title: () => text("browse"),
		shortcuts: [{ key: "/" }],
		run: (studio) => void openPart(studio, BROWSE),
	},
	{
		key: "saved",
		icon: "saved",
		title: () => text("saved"),
		description: () => text("shortcut_saved"),
		shortcuts: [{ key: "s", ctrl: true }],
		run: (studio) => void openPart(studio, SAVED),
	},
	{
		key: "variation",
		icon: "again",
		title: () => text("variation_new"),
		shortcuts: [{ key: "n" }],
		run: (studio) => studio.newVariation(),
	},
	{
		key: "reset",
		icon: "reset",
		title: () => text("reset_title"),
		isAvailable: (studio) => !sameSpecimen(studio.state.specimen, studio.preset),
		run: (studio) => studio.reset(),
	},
	{
		key: "open",
		icon: "open",
		title: () => text("open"),
		// The bar has the field; a file may be chosen within the user's key press or click only.
		run: () => document.querySelector<HTMLElement>("panicle-share input[type=file]")?.click(),
	},
	{
		key: "link",
		icon: "share",
		title: () => text("copy_link"),
		run: (studio) => void copyLink(studio),
	},
	{
		key: "share",
		icon: "share",
		title: () => text("share"),
		run: (studio) => void openPart(studio, SHARE),
	},
	{
		key: "download",
		icon: "download",
		title: () => text("download"),
		isAvailable: ({ state }) => state.shown !== undefined,
		run: (studio) => void openPart(studio, DOWNLOADS),
	},
	{
		key: "view",
		icon: "frame",
		title: () => text("stage_reset"),
		isAvailable: ({ state }) => state.view !== undefined,
		run: ({ state }) => state.view?.reset(),
	},
	{
		key: "wind",
		icon: "wind",
		title: () => text("stage_wind"),
		isAvailable: ({ state }) => state.view?.canBlow ?? false,
		run: ({ state: { view } }) => {
			if (view) view.wind = !view.wind;
		},
	},
	{
		key: "outdoors",
		icon: "outdoors",
		title: () => text("stage_outdoors"),
		isAvailable: ({ state }) => state.view !== undefined && state.model.outdoors === true,
		run: (studio) => studio.setUi({ outdoors: !studio.state.ui.outdoors }),
	},
	{
		key: "measure",
		icon: "tape",
		title: () => text("stage_measure"),
		description: () => text("shortcut_measure"),
		group: "view",
		shortcuts: [{ key: "m" }],
		isAvailable: ({ state }) => state.view !== undefined && state.shown !== undefined,
		run: (studio) => studio.toggleAid("tape"),
	},
	{
		key: "presentation",
		icon: "presentation",
		title: () => text("stage_present"),
		description: () => text("shortcut_present"),
		group: "view",
		shortcuts: [{ key: "f" }],
		isAvailable: ({ state }) => state.view !== undefined && state.shown !== undefined,
		run: (studio) => studio.toggleAid("presentation"),
	},
	{
		key: "room",
		icon: "room",
		title: () => text("room"),
		isAvailable: offersRoom,
		run: openRoom,
	},
	{
		key: "scale",
		icon: "scale",
		title: () => text("stage_scale"),
		isAvailable: ({ state }) => state.view !== undefined,
		run: (studio) => studio.setUi({ scaleBar: !(studio.state.ui.scaleBar ?? true) }),
	},
	{
		key: "names",
		icon: "names",
		title: () => text("stage_names"),
		isAvailable: ({ state }) => state.view !== undefined,
		run: (studio) => studio.setUi({ toolNames: !studio.state.ui.toolNames }),
	},
	{
		key: "theme",
		icon: "dark",
		title: ({ dark }) => text(dark ? "theme_light" : "theme_dark"),
		run: (studio) => studio.setUi({ theme: studio.state.dark ? "light" : "dark" }),
	},
	{
		key: "help",
		icon: "help",
		title: () => text("help"),
		shortcuts: [{ key: "f1" }],
		everywhere: true,
		run: (studio) => void openPart(studio, HELP),
	},
	{
		key: "shortcuts",
		icon: "keyboard",
		title: () => text("shortcuts"),
		shortcuts: [{ key: "?" }],
		run: (studio) => void openPart(studio, SHORTCUTS),
	},
];

/** Writes keys as lists show them: "Ctrl+Shift+Z". */
export const keysInWords = ({ key, ctrl, shift }: KeyCombination): string =>
	[...(ctrl ? ["Ctrl"] : []), ...(shift ? ["Shift"] : []), key.toUpperCase()].join("+");

/** Returns whether a shortcut is a single letter or sign, which the user can turn off. */
export const isLetter = ({ key, ctrl = false }: KeyCombination): boolean => !ctrl && key.length === 1;
