/**
 * The undo history of this tab: stored when the page is left, and added again after it has been loaded again with the
 * same plant. Nothing waits for it, and every failure leaves the page without it.
 */
import { isModel, modelNamed } from "../../models/index";
import type { PageModel } from "../../models/page_model";
import { beginningOf, type SpecimenHistory, settle } from "../../specimen/history";
import { modelInQuery } from "../../specimen/link";
import type { Specimen } from "../../specimen/specimen";
import type { Studio } from "../studio";
import { LONGEST_TEXT, readHistory, writeHistory } from "./history_text";
import { type StoredSpecimen, specimenOf, storedSpecimen } from "./stored_specimen";

export type TabStorage = Pick<Storage, "getItem" | "setItem" | "removeItem">;

/** The key of the history in the tab's storage. */
const KEY = "panicle.undo";
/** Steps that are restored before the page may handle events. */
const STEPS_AT_ONCE = 10;

/** Stored forms of specimens, which are never modified. */
const stored = new WeakMap<Specimen, StoredSpecimen>();

/**
 * Stores the studio's history. One without steps is not stored, and leaves the stored one, which belongs to another
 * plant of this tab.
 */
export function storeHistory(studio: Studio, storage: TabStorage): void {
	const { past, present, future } = settle(studio.state.history);
	if (past.length + future.length === 0) return;
	try {
		const [now, before, after] = [[present], past.toReversed(), future].map((steps) => storedSteps(studio, steps));
		if (now.length === 0) return;
		const history = { present: now[0], past: before, future: after };
		if (!put(storage, writeHistory(history)) && !put(storage, writeHistory(history, LONGEST_TEXT / 10)))
			storage.removeItem(KEY);
	} catch {
		// Storage is forbidden.
	}
}

/** Returns the stored forms of steps, up to the first whose model is not loaded. */
function storedSteps(studio: Studio, steps: readonly Specimen[]): StoredSpecimen[] {
	const found: StoredSpecimen[] = [];
	for (const specimen of steps) {
		const model = studio.modelOf(specimen);
		if (!model) break;
		const form = stored.get(specimen) ?? storedSpecimen(model, specimen);
		stored.set(specimen, form);
		found.push(form);
	}
	return found;
}

/** Writes a text. @returns whether there is one, and the storage has room for it */
function put(storage: TabStorage, text: string | undefined): boolean {
	try {
		if (text !== undefined) storage.setItem(KEY, text);
		return text !== undefined;
	} catch {
		return false;
	}
}

/** Adds the stored history to the studio's, if its present is the plant with which the studio's began. */
export async function restoreHistory(studio: Studio, storage: TabStorage): Promise<void> {
	const before = storedHistory(storage);
	const opened = beginningOf(studio.state.history);
	const model = studio.modelOf(opened);
	if (!before || !model || !haveSameLink(storedSpecimen(model, opened), before.present)) return;
	const { extra } = before.present;
	const models = new Set<PageModel>();
	const earlier = {
		past: (await restoreSteps(before.past, models)).reverse(),
		present: extra === undefined ? opened : specimenOf(model, before.present),
		future: await restoreSteps(before.future, models),
	} satisfies SpecimenHistory;
	// Another plant may have been opened meanwhile.
	if (beginningOf(studio.state.history) === opened) studio.continueHistory(earlier, models);
}

/** Reads the stored history; undefined where there is none or it cannot be read. */
function storedHistory(storage: TabStorage): ReturnType<typeof readHistory> {
	try {
		return readHistory(storage.getItem(KEY) ?? "");
	} catch {
		return undefined;
	}
}

/** Returns whether two specimens have the same link. */
function haveSameLink(one: StoredSpecimen, other: StoredSpecimen): boolean {
	const [a, b] = [one, other].map(({ texts }) => Object.entries(texts));
	return one.query === other.query && a.length === b.length && a.every(([key, text]) => other.texts[key] === text);
}

/**
 * Restores the specimens of steps, up to the first whose model is unknown or cannot be loaded.
 * @param models receives their models
 */
async function restoreSteps(steps: readonly StoredSpecimen[], models: Set<PageModel>): Promise<Specimen[]> {
	const found: Specimen[] = [];
	for (const step of steps) {
		const name = modelInQuery(step.query);
		if (name !== undefined && !isModel(name)) break;
		const model = await modelNamed(name).catch(() => undefined);
		if (!model) break;
		models.add(model);
		const specimen = specimenOf(model, step);
		stored.set(specimen, step);
		found.push(specimen);
		if (found.length % STEPS_AT_ONCE === 0) await new Promise((resolve) => setTimeout(resolve));
	}
	return found;
}
