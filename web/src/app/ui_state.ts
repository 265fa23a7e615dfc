/** What the page remembers between visits; nothing of it is part of the document. */
export interface UiState {
	theme: "system" | "light" | "dark";
	/** Whether single letters are keys for the whole page. */
	letters: boolean;
	/** The one view that a phone shows: `SOLID`, or the name of a model's flat view. */
	view: string;
	/** Groups of the panel that a person has opened or closed, by key; the others are as the table says. */
	groups: Readonly<Record<string, boolean>>;
	/** What models' tools remember, by model and tool, as they left it. */
	tools: Readonly<Record<string, Readonly<Record<string, unknown>>>>;
}

/** The 3-D view. */
export const SOLID = "solid";

export const STORAGE_KEY = "panicle.ui";

export const FIRST_VISIT: UiState = { theme: "system", letters: true, view: SOLID, groups: {}, tools: {} };

/** Reads what was remembered. Anything missing, foreign or unreadable gives the first visit's value. */
export function loadUi(storage: Pick<Storage, "getItem">): UiState {
	try {
		const stored: unknown = JSON.parse(storage.getItem(STORAGE_KEY) ?? "{}");
		return restoreUi(stored);
	} catch {
		return FIRST_VISIT;
	}
}

/**
 * Remembers what has changed, and leaves the rest as it is kept: another tab may have changed that. A full or forbidden
 * storage is no reason to stop.
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
		// Private windows may forbid it: the page works, it only forgets.
	}
}

/** What is the same in every tab: of the rest each tab keeps its own, so that nothing moves under a hand. */
export function pageOf({ theme, letters }: UiState): Pick<UiState, "theme" | "letters"> {
	return { theme, letters };
}

/** What is kept, with what has changed since before. */
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
		// What is in them is for the tools to judge.
		tools: Object.fromEntries(Object.entries(recordOf(tools)).map(([model, each]) => [model, recordOf(each)])),
	};
}

function recordOf(value: unknown): Readonly<Record<string, unknown>> {
	return typeof value === "object" && value !== null && !Array.isArray(value) ? { ...value } : {};
}
