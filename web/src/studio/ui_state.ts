/** What the page remembers between visits; nothing of it is part of the document. */
export interface UiState {
	theme: "system" | "light" | "dark";
	/** The one view that a phone shows: `SOLID`, or the name of a model's flat view. */
	view: string;
	/** Groups of the panel that a person has opened or closed, by key; the others are as the table says. */
	groups: Readonly<Record<string, boolean>>;
	/** What models' tools remember, by model and tool, as they left it. */
	tools: Readonly<Record<string, Readonly<Record<string, unknown>>>>;
}

/** The 3-D view. */
export const SOLID = "solid";

const STORAGE_KEY = "panicle.ui";

export const FIRST_VISIT: UiState = { theme: "system", view: SOLID, groups: {}, tools: {} };

/** Reads what was remembered. Anything missing, foreign or unreadable gives the first visit's value. */
export function loadUi(storage: Pick<Storage, "getItem">): UiState {
	try {
		const kept: unknown = JSON.parse(storage.getItem(STORAGE_KEY) ?? "{}");
		return restoreUi(kept);
	} catch {
		return FIRST_VISIT;
	}
}

/** Remembers; a full or forbidden storage is no reason to stop. */
export function saveUi(storage: Pick<Storage, "setItem">, ui: UiState): void {
	try {
		const { theme, groups, tools } = ui;
		storage.setItem(STORAGE_KEY, JSON.stringify({ theme, groups, tools }));
	} catch {
		// Private windows may forbid it: the page works, it only forgets.
	}
}

function restoreUi(kept: unknown): UiState {
	const { theme, groups, tools } = recordOf(kept);
	return {
		...FIRST_VISIT,
		theme: theme === "light" || theme === "dark" ? theme : "system",
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
