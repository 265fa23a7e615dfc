import type { Locks, View } from "./types";

/** What the page remembers between visits; nothing of it is part of the document. */
export interface UiState {
	theme: "system" | "light" | "dark";
	/** The one view that a phone shows. */
	view: View;
	/** Keys of the panel's groups that are closed. */
	closed: readonly string[];
	locks: Locks;
	/** Whether the 3-D view shows the octahedron with its handles. */
	octahedron: boolean;
	/** Whether the 3-D view leaves the berries away and marks withered pedicels. */
	stems: boolean;
	/** Whether a click in the 3-D view takes a berry off. */
	thinning: boolean;
}

const STORAGE_KEY = "panicle.ui";

/** A first visit: what most people touch is open, the grammar's constants wait. */
export const FIRST_VISIT: UiState = {
	theme: "system",
	view: "solid",
	closed: ["wing", "look", "procedure", "interaction", "branching", "rates", "between"],
	locks: { leftRight: false, frontBack: false },
	octahedron: false,
	stems: false,
	thinning: false,
};

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
		const { theme, closed, locks } = ui;
		storage.setItem(STORAGE_KEY, JSON.stringify({ theme, closed, locks }));
	} catch {
		// Private windows may forbid it: the page works, it only forgets.
	}
}

function restoreUi(kept: unknown): UiState {
	if (typeof kept !== "object" || kept === null) return FIRST_VISIT;
	const { theme, closed, locks } = kept as Record<string, unknown>;
	return {
		...FIRST_VISIT,
		theme: theme === "light" || theme === "dark" ? theme : "system",
		closed: Array.isArray(closed) ? closed.filter((key) => typeof key === "string") : FIRST_VISIT.closed,
		locks: restoreLocks(locks),
	};
}

function restoreLocks(kept: unknown): Locks {
	if (typeof kept !== "object" || kept === null) return FIRST_VISIT.locks;
	const { leftRight, frontBack } = kept as Record<string, unknown>;
	return { leftRight: leftRight === true, frontBack: frontBack === true };
}
