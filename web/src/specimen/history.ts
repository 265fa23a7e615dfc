/** Undo and redo: a list of specimens, as plain data. Every function returns a new history. */
import { sameSpecimen } from "./same";
import type { Specimen } from "./specimen";

export interface SpecimenHistory<S extends Specimen = Specimen> {
	/** Oldest first. */
	readonly past: readonly S[];
	readonly present: S;
	/**
	 * Nearest first. During a drag it holds the specimens from before the drag, so that a drag which ends where it
	 * began loses nothing.
	 */
	readonly future: readonly S[];
	/** The drag that made the present, while it lasts. */
	readonly gesture?: string | undefined;
	/**
	 * The run of key presses that made the present, even when it has ended: the next press of the run extends the same
	 * step.
	 */
	readonly run?: string | undefined;
}

/** The most steps that can be undone; the oldest are dropped. */
export const LONGEST_HISTORY = 200;

/** Returns a history without steps. */
export function startHistory<S extends Specimen>(present: S): SpecimenHistory<S> {
	return { past: [], present, future: [] };
}

/**
 * Sets another specimen as the present.
 * @param gesture names a drag; consecutive changes of one gesture are one step. Without it every change is a step.
 * @param run names a sequence that spans several gestures
 */
export function change<S extends Specimen>(
	history: SpecimenHistory<S>,
	next: S,
	gesture?: string,
	run?: string,
): SpecimenHistory<S> {
	if (gesture !== undefined && gesture === history.gesture) return { ...history, present: next, run };
	const settled = settle(history);
	if (run !== undefined && run === settled.run) return { ...settled, present: next, gesture };
	if (sameSpecimen(settled.present, next)) return settled;
	const past = [...settled.past, settled.present].slice(-LONGEST_HISTORY);
	return { past, present: next, future: gesture === undefined ? [] : settled.future, gesture, run };
}

/** Ends a drag: the next change is a new step. A drag that ended where it began leaves none. */
export function settle<S extends Specimen>(history: SpecimenHistory<S>): SpecimenHistory<S> {
	if (history.gesture === undefined) return history;
	const { past, present, future, run } = history;
	const before = past.at(-1);
	if (before && sameSpecimen(before, present)) return { past: past.slice(0, -1), present: before, future };
	return { past, present, future: [], run };
}

/** Returns whether there is a step to undo; a drag that ended where it began is none. */
export function canUndo(history: SpecimenHistory): boolean {
	return settle(history).past.length > 0;
}

/** Returns whether there is a step to redo. */
export function canRedo(history: SpecimenHistory): boolean {
	return settle(history).future.length > 0;
}

/** Goes one step back; returns an equal history at its beginning. */
export function undo<S extends Specimen>(history: SpecimenHistory<S>): SpecimenHistory<S> {
	const { past, present, future } = settle(history);
	const before = past.at(-1);
	return before
		? { past: past.slice(0, -1), present: before, future: [present, ...future] }
		: { past, present, future };
}

/** Goes one step forward; returns an equal history at its end. */
export function redo<S extends Specimen>(history: SpecimenHistory<S>): SpecimenHistory<S> {
	const { past, present, future } = settle(history);
	const [next, ...rest] = future;
	return next ? { past: [...past, present], present: next, future: rest } : { past, present, future };
}

/** Returns the specimen at which a history began, as long as no step has been dropped. */
export function beginningOf<S extends Specimen>({ past, present }: SpecimenHistory<S>): S {
	return past[0] ?? present;
}

/**
 * Adds the steps of an earlier history that ended at the specimen where this one began. Its redo steps are added only if
 * nothing has been changed since.
 * @param earlier its present replaces the specimen where this one began, which may lack parts
 */
export function continued<S extends Specimen>(
	history: SpecimenHistory<S>,
	earlier: Pick<SpecimenHistory<S>, "past" | "present" | "future">,
): SpecimenHistory<S> {
	const { past, present, future, gesture } = history;
	// A drag in progress is a step that may yet be dropped.
	const isFirst = past.length === (gesture === undefined ? 0 : 1) && future.length === 0;
	const steps = past.length > 0 ? [...earlier.past, earlier.present, ...past.slice(1)] : earlier.past;
	return {
		...history,
		past: steps.slice(-LONGEST_HISTORY),
		present: past.length > 0 ? present : earlier.present,
		future: isFirst ? earlier.future : future,
	};
}
