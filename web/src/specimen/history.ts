/** Undo and redo: a list of specimens, as plain data. Every function gives a new history. */
import { sameSpecimen } from "./same";
import type { Specimen } from "./specimen";

export interface History {
	/** Oldest first. */
	readonly past: readonly Specimen[];
	readonly present: Specimen;
	/** Nearest first. While a drag lasts, what there was before it: a drag that ends where it began loses nothing. */
	readonly future: readonly Specimen[];
	/** The drag that made the present, while it lasts. */
	readonly gesture?: string | undefined;
}

/** Steps that can be undone; the oldest are forgotten. */
export const LONGEST_HISTORY = 200;

export function startHistory(present: Specimen): History {
	return { past: [], present, future: [] };
}

/**
 * Goes on to another specimen.
 * @param gesture names a drag; all changes of one gesture in a row are one step. Without it every change is a step.
 */
export function change(history: History, next: Specimen, gesture?: string): History {
	if (gesture !== undefined && gesture === history.gesture) return { ...history, present: next };
	const settled = settle(history);
	if (sameSpecimen(settled.present, next)) return settled;
	const past = [...settled.past, settled.present].slice(-LONGEST_HISTORY);
	return { past, present: next, future: gesture === undefined ? [] : settled.future, gesture };
}

/** Ends a drag: what follows is a new step. A drag that ended where it began leaves none. */
export function settle(history: History): History {
	if (history.gesture === undefined) return history;
	const { past, present, future } = history;
	const before = past.at(-1);
	if (before && sameSpecimen(before, present)) return { past: past.slice(0, -1), present: before, future };
	return { past, present, future: [] };
}

export function canUndo(history: History): boolean {
	return settle(history).past.length > 0;
}

export function canRedo(history: History): boolean {
	return settle(history).future.length > 0;
}

/** One step back, or the same history at its beginning. */
export function undo(history: History): History {
	const { past, present, future } = settle(history);
	const before = past.at(-1);
	return before
		? { past: past.slice(0, -1), present: before, future: [present, ...future] }
		: { past, present, future };
}

/** One step forward, or the same history at its end. */
export function redo(history: History): History {
	const { past, present, future } = settle(history);
	const [next, ...rest] = future;
	return next ? { past: [...past, present], present: next, future: rest } : { past, present, future };
}
