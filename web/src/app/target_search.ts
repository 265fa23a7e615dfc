/**
 * Searches parameters that give a measure a requested value: the page's side of targets/. Loaded when such a measure is
 * first unfolded.
 */
import { aimed } from "../batch/aimed";
import { growsAlike, sameSpecimen } from "../specimen/same";
import type { Specimen } from "../specimen/specimen";
import type { Aim } from "../targets/aim";
import { MAX_GROWTHS, type Solution } from "../targets/solve";
import { changesInWords, reachedInWords } from "../targets/words";
import type { Stateful } from "../ui/editor_context";
import { text } from "./messages.generated";
import type { Studio } from "./studio";

export interface TargetSearch {
	/** The search that is running. */
	readonly now?: { readonly measure: string; readonly growths: number; cancel(): void };
	/** The last result and its targets: while it is on the controls, the next search meets these targets, too. */
	readonly found?: { readonly specimen: Specimen; readonly aims: readonly Aim[] };
}

/** State of the search of the open model; one search runs at a time. */
export const TARGET_SEARCH: Stateful<TargetSearch> = { name: "asking", initial: {} };

/** Topic of the search's notices: the next notice of the topic, or the next change, removes them. */
const TOPIC = "asked";

/** Returns the targets that the document on the controls meets. */
export function currentAims(studio: Studio): readonly Aim[] {
	const { found } = studio.toolState(TARGET_SEARCH);
	return found && sameSpecimen(found.specimen, studio.state.specimen) ? found.aims : [];
}

/** Searches parameters that give a measure a value, and applies them as one undo step; a notice reports the result. */
export async function searchTarget(studio: Studio, aim: Aim): Promise<void> {
	studio.toolState(TARGET_SEARCH).now?.cancel();
	const { model, specimen: from } = studio.state;
	if (!model.targets) return;
	const aims = [...currentAims(studio).filter(({ measure }) => measure !== aim.measure), aim];
	const ending = new AbortController();
	const cancel = () => ending.abort();
	const report = (growths: number) => {
		// A newer search may have replaced this one.
		if (ending.signal.aborted) return;
		studio.setToolState(TARGET_SEARCH, {
			...studio.toolState(TARGET_SEARCH),
			now: { measure: aim.measure, growths, cancel },
		});
	};
	// The user's own changes end the search.
	const end = studio.subscribe(() => {
		if (studio.state.model !== model || !growsAlike(studio.state.specimen, from)) cancel();
	});
	report(0);
	try {
		const measured = async (specimen: Specimen) => {
			ending.signal.throwIfAborted();
			return { measures: await studio.measure(model, specimen, ending.signal) };
		};
		const answer = await aimed(model, from, aims, measured, report);
		ending.signal.throwIfAborted();
		end();
		take(studio, from, aims, answer);
	} catch (error) {
		end();
		const { now, ...others } = studio.toolState(TARGET_SEARCH);
		if (studio.state.model === model && now?.cancel === cancel) studio.setToolState(TARGET_SEARCH, others);
		if (!ending.signal.aborted) {
			const reason = error instanceof Error ? error.message : String(error);
			studio.notify(text("target_search_failed"), [reason], { topic: TOPIC });
		}
	}
}

/**
 * Sets the found parameters in the current specimen, and notifies of the reached values and the changes.
 * @param from the specimen before the search
 */
function take(studio: Studio, from: Specimen, aims: readonly Aim[], answer: Solution): void {
	const { model, specimen } = studio.state;
	const found = { ...specimen, parameters: answer.specimen.parameters };
	studio.setToolState(TARGET_SEARCH, { found: { specimen: found, aims } });
	studio.replace(found);
	const changes = changesInWords(model, from, found);
	const [title, ...others] = [...answer.reached].reverse().map(reachedInWords);
	const last = changes ? text("target_changes", { changes, tries: answer.growths }) : text("target_no_changes");
	studio.notify(title, [...others, last], { topic: TOPIC, untouched: true });
}

/** Returns the progress of a search, from 0 to 1. */
export const shareDone = ({ growths }: { readonly growths: number }): number => growths / MAX_GROWTHS;
