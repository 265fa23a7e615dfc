/** The entries of the command palette: plants, settings of the shown plant, actions and pages of the help. */
import { type SVGTemplateResult, svg } from "lit";
import { displayedText, displayScaleOf } from "../../specimen/lengths";
import type { Group, ParameterEntry } from "../../specimen/table";
import { valueIn } from "../../specimen/table";
import { optionInWords } from "../../specimen/translated_tables";
import type { IconName } from "../../ui/icons";
import { isQuantity } from "../../ui/quantity";
import type { Tool } from "../../ui/tool";
import { ACTIONS, isLetter, keysInWords, type PageAction } from "../actions";
import { applying, groupsFor } from "../panel_groups";
import { type PlacedPreset, placeInWords } from "../preset_search";
import type { SearchTexts } from "../search/text_index";
import type { Studio } from "../studio";
import { text } from "./messages.generated";
import { showBar, showControl, showGroup } from "./show_control";

/** The groups of entries, in their order where they match equally well. */
export const GROUPS = ["plants", "settings", "actions", "help"] as const;
export type EntryGroup = (typeof GROUPS)[number];

export interface PaletteEntry {
	/** Names it among all entries, also on a later visit: "action:undo", "plant:growth/oak". */
	readonly key: string;
	readonly group: EntryGroup;
	readonly title: string;
	/** Where it belongs, and its value. */
	readonly about: string;
	/** The shortcut, as lists show it. */
	readonly keys?: string;
	readonly icon?: IconName | SVGTemplateResult;
	/** The address of its picture. */
	readonly picture?: string;
	readonly texts: SearchTexts;
	run(): void | Promise<void>;
	/** The result that is announced after it has run; absent where the page shows it otherwise. */
	done?(): string;
}

const SLIDERS = svg`<path d="M3 6h6M13 6h4M3 14h3M10 14h7"/><circle cx="11" cy="6" r="2"/><circle cx="8" cy="14" r="2"/>`;

/** Returns the address of a preset's picture. */
const pictureOf = (model: string, preset: string, dark: boolean): string =>
	`${import.meta.env.BASE_URL}gallery/${model}/${preset}-${dark ? "dark" : "light"}.webp`;

/** Returns the entry of a preset; choosing it is one undo step. */
export function plantEntry(studio: Studio, { model, kind, preset }: PlacedPreset): PaletteEntry {
	const { title, name } = preset;
	return {
		key: `plant:${model.name}/${name}`,
		group: "plants",
		title,
		about: placeInWords({ model, kind, preset }),
		...(model.pictures === false ? {} : { picture: pictureOf(model.name, name, studio.state.dark) }),
		texts: { title },
		run: () => studio.choosePreset(name, model),
		done: () => text("done_plant", { title }),
	};
}

/**
 * Returns the entries of the settings that the panel shows for the plant, those of bars below the view, and the panel's
 * groups.
 */
export function settingEntries(studio: Studio): readonly PaletteEntry[] {
	const { model, specimen, modelUi } = studio.state;
	const tools = applying(modelUi?.tools, specimen);
	const groups = groupsFor(model.table, specimen, tools);
	const barOf = (entry: ParameterEntry) =>
		tools.find(({ bar, parameters = [] }) => bar !== undefined && parameters.includes(entry.key));
	const inBars = model.table.entries.filter((entry) => model.table.isActive(specimen, entry) && barOf(entry));
	const titles = new Map(model.table.groups.map(({ key, title }) => [key, title]));
	return [
		...inBars.map((entry) =>
			settingEntry(studio, entry, titles.get(entry.group) ?? "", () => showBar(barOf(entry)?.bar?.title ?? "")),
		),
		...groups.flatMap(({ group, entries }) =>
			entries.map((entry) => settingEntry(studio, entry, group.title, () => showControl(studio, group.key, entry.key))),
		),
		...groups.map(({ group }) => groupEntry(studio, group)),
	];
}

/**
 * Returns the entry of a parameter, with its present value.
 * @param group title of its group
 * @param show moves the focus to its control; resolves to whether the page shows it
 */
function settingEntry(
	studio: Studio,
	entry: ParameterEntry,
	group: string,
	show: () => Promise<boolean>,
): PaletteEntry {
	const { model, ui } = studio.state;
	const { key, label, symbol, link, help } = entry;
	return {
		key: `setting:${model.name}/${key}`,
		group: "settings",
		title: symbol === "" || !ui.symbols ? label : `${label} (${symbol})`,
		about: text("setting_about", { group, value: valueInWords(studio, entry) }),
		icon: SLIDERS,
		texts: {
			title: label,
			names: [key, link, symbol],
			shelves: [group],
			descriptions: [help, ...(entry.kind === "choice" ? (entry.labels ?? entry.options) : [])],
		},
		run: () => showOrReport(studio, label, show),
	};
}

/** Returns the entry of a group of the panel. */
function groupEntry(studio: Studio, { key, title, help }: Group): PaletteEntry {
	return {
		key: `group:${studio.state.model.name}/${key}`,
		group: "settings",
		title,
		about: text("setting_group"),
		icon: SLIDERS,
		texts: { title, names: [key], descriptions: [help] },
		run: () => showOrReport(studio, title, () => showGroup(studio, key)),
	};
}

/** Moves the focus to a control; reports it if the page does not show it. */
async function showOrReport(studio: Studio, setting: string, show: () => Promise<boolean>): Promise<void> {
	if (!(await show())) studio.notify(text("not_shown", { setting }), [], { topic: "palette", brief: true });
}

/** Returns the value of a parameter as its control shows it, with its unit. */
function valueInWords({ state: { model, specimen, grown } }: Studio, entry: ParameterEntry): string {
	const value = isQuantity(entry) ? entry.read(specimen, grown) : valueIn(specimen, entry);
	if (entry.kind === "colour") return String(value);
	if (entry.kind === "choice") return entry.labels?.[Number(value)] ?? optionInWords(entry.options[Number(value)]);
	const scale = displayScaleOf(model, specimen, entry);
	return `${displayedText(entry, scale, Number(value))} ${scale.unit}`.trim();
}

/** Returns the entries of the page's actions that can be run now, except opening the palette. */
export function actionEntries(studio: Studio): readonly PaletteEntry[] {
	const available = ACTIONS.filter(({ key, isAvailable }) => key !== "palette" && (isAvailable?.(studio) ?? true));
	return available.map((action) => actionEntry(studio, action));
}

/** Returns the entry of an action of the page. */
function actionEntry(studio: Studio, action: PageAction): PaletteEntry {
	const { key, icon, shortcuts = [] } = action;
	const { letters } = studio.state.ui;
	const [first] = shortcuts.filter((each) => letters || !isLetter(each));
	const title = action.title(studio.state);
	const description = action.description?.();
	const done = DONE[key];
	return {
		key: `action:${key}`,
		group: "actions",
		title,
		about: "",
		...(icon ? { icon } : {}),
		...(first ? { keys: keysInWords(first) } : {}),
		texts: { title, names: [key], ...(description ? { descriptions: [description] } : {}) },
		run: () => action.run(studio),
		...(done ? { done: () => done(studio) } : {}),
	};
}

/** The results of actions that are announced. */
const DONE: Readonly<Record<string, (studio: Studio) => string>> = {
	undo: () => text("done_undo"),
	redo: () => text("done_redo"),
	reset: () => text("done_reset"),
	variation: ({ state }) => text("done_variation", { seed: `${state.specimen.seed}` }),
	view: () => text("done_view"),
	wind: ({ state }) => text("done_wind", { state: state.view?.wind ? "on" : "off" }),
	outdoors: ({ state }) => text("done_outdoors", { state: state.ui.outdoors ? "on" : "off" }),
	theme: ({ state }) => text("done_theme", { theme: state.dark ? "dark" : "light" }),
};

/** Returns the entries of the buttons and keys of the model's tools, such as opening the grammar. */
export function toolEntries(studio: Studio): readonly PaletteEntry[] {
	const { model, modelUi, specimen, view } = studio.state;
	return applying(modelUi?.tools, specimen)
		.filter(({ press, interaction }) => press && (view || !interaction))
		.flatMap((tool) => toolEntry(studio, model.name, tool) ?? []);
}

/** Returns the entry of a tool; undefined for a tool without button and key. */
function toolEntry(studio: Studio, model: string, tool: Tool): PaletteEntry | undefined {
	const { name, button, key } = tool;
	const title = button?.label ?? key?.description;
	if (title === undefined) return undefined;
	const isOn = () => button?.pressed?.(studio) ?? false;
	return {
		key: `tool:${model}/${name}`,
		group: "actions",
		title,
		about: isOn() ? text("switched_on") : "",
		...(button ? { icon: button.icon } : {}),
		...(key && studio.state.ui.letters ? { keys: key.letter.toUpperCase() } : {}),
		texts: { title, names: [name], ...(key ? { descriptions: [key.description] } : {}) },
		run: () => tool.press?.(studio),
		...(button?.pressed ? { done: () => text("done_tool", { tool: title, state: isOn() ? "on" : "off" }) } : {}),
	};
}
