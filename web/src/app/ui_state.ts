/** The interface state that the page remembers between visits; not part of the document. */
export interface UiState {
	theme: "system" | "light" | "dark";
	/** Whether single-letter keyboard shortcuts are enabled. */
	letters: boolean;
	/** The view that a phone shows: `SOLID`, or the name of a model's flat view. */
	view: string;
	/** Groups of the panel that the user has opened or closed, by key; the others follow the table. */
	groups: Readonly<Record<string, boolean>>;
	/** States that models' tools remember, by model and tool. */
	tools: Readonly<Record<string, Readonly<Record<string, unknown>>>>;
}

/** The 3-D view. */
export const SOLID = "solid";

export const STORAGE_KEY = "panicle.ui";

export const FIRST_VISIT: UiState = { theme: "system", letters: true, view: SOLID, groups: {}, tools: {} };

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
 * Stores the changed parts; the rest of the stored state stays, since another tab may have changed it. Does nothing where storage is
 * full or forbidden.
 */
export function saveUi(storage: Pick<Storage, "getItem" | "setItem">, ui: UiState, before: UiState): void {
	try {
		const stored = loadUi(storage);
		const models = Object.entries(ui.tools).map(
			([model, tools]) => [model, merged(stored.tools[model], tools, before.tools[model])] as const,
		);
		const next = {
			...merged({ theme: stored.theme, letters: stored.letters }, pageOf(ui), pageOf(before)),
			groups: merged(stored.groups, ui.groups, before.groups),
			tools: { ...stored.tools, ...Object.fromEntries(models) },
		};
		storage.setItem(STORAGE_KEY, JSON.stringify(next));
	} catch {
		// Private windows may forbid storage: the page works without.
	}
}

/** The parts that all tabs share; of the rest each tab has its own, so that no layout shifts during use. */
export function pageOf({ theme, letters }: UiState): Pick<UiState, "theme" | "letters"> {
	return { theme, letters };
}

/** The stored entries, updated by those that have changed. */
function merged<T>(
	stored: Readonly<Record<string, T>> = {},
	now: Readonly<Record<string, T>>,
	before: Readonly<Record<string, T>> = {},
): Record<string, T> {
	return { ...stored, ...Object.fromEntries(Object.entries(now).filter(([key, value]) => value !== before[key])) };
}

function restoreUi(stored: unknown): UiState {
	const { theme, letters, groups, tools } = recordOf(stored);
	return {
		...FIRST_VISIT,
		theme: theme === "light" || theme === "dark" ? theme : "system",
		letters: letters !== false,
		groups: Object.fromEntries(
			Object.entries(recordOf(groups)).filter((group): group is [string, boolean] => typeof group[1] === "boolean"),
		),
		// Tools validate their own states (`recall`).
		tools: Object.fromEntries(Object.entries(recordOf(tools)).map(([model, each]) => [model, recordOf(each)])),
	};
}

function recordOf(value: unknown): Readonly<Record<string, unknown>> {
	return typeof value === "object" && value !== null && !Array.isArray(value) ? { ...value } : {};
}
