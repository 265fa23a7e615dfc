import { languageOf } from "../locale/locale";

/** The interface state that the page remembers between visits; not part of the document. */
export interface UiState {
	theme: "system" | "light" | "dark";
	/** The tag of the chosen language; "" follows the browser's. */
	language: string;
	/** Whether single-letter keyboard shortcuts are enabled. */
	letters: boolean;
	/** Whether the names of the tools are shown beside their icons on the 3-D view. */
	toolNames: boolean;
	/** Whether the panel shows the symbols of the papers beside names. */
	symbols: boolean;
	/** Whether the 3-D view shows trees outdoors instead of on paper. */
	outdoors: boolean;
	/** Whether the 3-D view shows a scale bar; undefined, unless the user chose: in the studio, but not in presentations. */
	scaleBar: boolean | undefined;
	/** The view that a phone shows: `SOLID`, or the name of a model's flat view. */
	view: string;
	/** Presets that the user has marked, oldest first, as "growth/oak" (preset_cards.ts). */
	favourites: readonly string[];
	/** The presets used last, newest first, written in the same way. */
	recentPresets: readonly string[];
	/** Groups of the panel that the user has opened or closed, by key; the others follow the table. */
	groups: Readonly<Record<string, boolean>>;
	/** States that models' tools remember, by model and tool. */
	tools: Readonly<Record<string, Readonly<Record<string, unknown>>>>;
}

/** The 3-D view. */
export const SOLID = "solid";

export const STORAGE_KEY = "panicle.ui";

/** The most favourites and the most recent presets that are stored. */
export const MAX_FAVOURITES = 200;
export const MAX_RECENT_PRESETS = 12;

export const FIRST_VISIT: UiState = {
	theme: "system",
	language: "",
	letters: true,
	toolNames: false,
	symbols: false,
	outdoors: true,
	scaleBar: undefined,
	view: SOLID,
	favourites: [],
	recentPresets: [],
	groups: {},
	tools: {},
};

/** Reads the stored state. Missing or unreadable parts get the defaults of a first visit. */
export function loadUi(storage: Pick<Storage, "getItem">): UiState {
	try {
		const stored: unknown = JSON.parse(storage.getItem(STORAGE_KEY) ?? "{}");
		return restoreUi(stored);
	} catch {
		return FIRST_VISIT;
	}
}

/**
 * Stores the changed parts; the rest of the stored state stays, since another tab may have changed it. Does nothing
 * where storage is full or forbidden.
 */
export function saveUi(storage: Pick<Storage, "getItem" | "setItem">, ui: UiState, before: UiState): void {
	try {
		const stored = loadUi(storage);
		const models = Object.entries(ui.tools).map(
			([model, tools]) => [model, merged(stored.tools[model], tools, before.tools[model])] as const,
		);
		const next = {
			...merged<unknown>(pageOf(stored), pageOf(ui), pageOf(before)),
			groups: merged(stored.groups, ui.groups, before.groups),
			tools: { ...stored.tools, ...Object.fromEntries(models) },
		};
		storage.setItem(STORAGE_KEY, JSON.stringify(next));
	} catch {
		// Private windows may forbid storage: the page works without.
	}
}

/** Returns the parts that all tabs share; of the rest each tab has its own, so that no layout shifts during use. */
export function pageOf({
	theme,
	language,
	letters,
	toolNames,
	symbols,
	outdoors,
	scaleBar,
	favourites,
	recentPresets,
}: UiState): Pick<
	UiState,
	"theme" | "language" | "letters" | "toolNames" | "symbols" | "outdoors" | "scaleBar" | "favourites" | "recentPresets"
> {
	return { theme, language, letters, toolNames, symbols, outdoors, scaleBar, favourites, recentPresets };
}

/** Returns the stored entries, updated by those that have changed since `before`. */
function merged<T>(
	stored: Readonly<Record<string, T>> = {},
	now: Readonly<Record<string, T>>,
	before: Readonly<Record<string, T>> = {},
): Record<string, T> {
	return { ...stored, ...Object.fromEntries(Object.entries(now).filter(([key, value]) => value !== before[key])) };
}

/** Reads stored state, which may come from another version: unusable values are replaced by those of a first visit. */
function restoreUi(stored: unknown): UiState {
	const { theme, language, letters, toolNames, symbols, outdoors, scaleBar, favourites, recentPresets, groups, tools } =
		recordOf(stored);
	return {
		...FIRST_VISIT,
		theme: theme === "light" || theme === "dark" ? theme : "system",
		language: typeof language === "string" && languageOf(language) ? language : "",
		letters: letters !== false,
		toolNames: toolNames === true,
		symbols: symbols === true,
		outdoors: outdoors !== false,
		scaleBar: typeof scaleBar === "boolean" ? scaleBar : undefined,
		favourites: presetKeysIn(favourites, MAX_FAVOURITES),
		recentPresets: presetKeysIn(recentPresets, MAX_RECENT_PRESETS),
		groups: Object.fromEntries(
			Object.entries(recordOf(groups)).filter((group): group is [string, boolean] => typeof group[1] === "boolean"),
		),
		// Tools validate their own states (`recall`).
		tools: Object.fromEntries(Object.entries(recordOf(tools)).map(([model, each]) => [model, recordOf(each)])),
	};
}

/** Returns the valid keys of presets in a stored list, each once. */
function presetKeysIn(stored: unknown, max: number): readonly string[] {
	if (!Array.isArray(stored)) return [];
	const keys = stored.filter((key): key is string => typeof key === "string" && /^[\w-]{1,40}\/[\w-]{1,80}$/.test(key));
	return [...new Set(keys)].slice(0, max);
}

/** Returns a copy of a stored record; an empty one for other values. */
function recordOf(value: unknown): Readonly<Record<string, unknown>> {
	return typeof value === "object" && value !== null && !Array.isArray(value) ? { ...value } : {};
}
