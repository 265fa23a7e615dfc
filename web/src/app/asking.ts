/** Asking for numbers: the page's side of targets/. Loaded when a measure that can be asked for is first unfolded. */
import { aimed } from "../batch/aimed";
import { growsAlike, sameSpecimen } from "../specimen/same";
import type { Specimen } from "../specimen/specimen";
import type { Aim } from "../targets/aim";
import { type Answer, MOST_GROWTHS } from "../targets/solve";
import { changesInWords, growthsInWords, reachedInWords } from "../targets/words";
import type { Stateful } from "../ui/editor_context";
import type { Studio } from "./studio";

export interface Asking {
	/** What is being looked for. */
	readonly now?: { readonly measure: string; readonly growths: number; cancel(): void };
	/** What was found last, and where: while that is what is on the controls, what is asked next holds it too. */
	readonly found?: { readonly specimen: Specimen; readonly aims: readonly Aim[] };
}

/** One at a time, of the model that is open. */
export const ASKING: Stateful<Asking> = { name: "asking", initial: {} };

/** What its notices are about: the next one takes them back, and so does the next change. */
const ASKED = "asked";

/** What is held of the document on the controls. */
export function heldAims(studio: Studio): readonly Aim[] {
	const { found } = studio.toolState(ASKING);
	return found && sameSpecimen(found.specimen, studio.state.specimen) ? found.aims : [];
}

/** Looks for parameters that give a measure a value, and takes them as one step; a notice says what came of it. */
export async function askFor(studio: Studio, aim: Aim): Promise<void> {
	studio.toolState(ASKING).now?.cancel();
	const { model, specimen: from } = studio.state;
	if (!model.targets) return;
	const aims = [...heldAims(studio).filter(({ measure }) => measure !== aim.measure), aim];
	const ending = new AbortController();
	const cancel = () => ending.abort();
	const say = (growths: number) => {
		// Another may have taken its place.
		if (ending.signal.aborted) return;
		studio.setToolState(ASKING, { ...studio.toolState(ASKING), now: { measure: aim.measure, growths, cancel } });
	};
	// What a hand does meanwhile goes before.
	const end = studio.subscribe(() => {
		if (studio.state.model !== model || !growsAlike(studio.state.specimen, from)) cancel();
	});
	say(0);
	try {
		const measured = async (specimen: Specimen) => {
			ending.signal.throwIfAborted();
			return { measures: await studio.measure(model, specimen, ending.signal) };
		};
		const answer = await aimed(model, from, aims, measured, say);
		ending.signal.throwIfAborted();
		end();
		take(studio, from, aims, answer);
	} catch (error) {
		end();
		const { now, ...others } = studio.toolState(ASKING);
		if (studio.state.model === model && now?.cancel === cancel) studio.setToolState(ASKING, others);
		if (!ending.signal.aborted) {
			const text = error instanceof Error ? error.message : String(error);
			studio.notify("What was asked for could not be looked for", [text], { topic: ASKED });
		}
	}
}

function take(studio: Studio, from: Specimen, aims: readonly Aim[], answer: Answer): void {
	const { model, specimen } = studio.state;
	const found = { ...specimen, parameters: answer.specimen.parameters };
	studio.setToolState(ASKING, { found: { specimen: found, aims } });
	studio.replace(found);
	const changes = changesInWords(model, from, found);
	const [title, ...others] = [...answer.reached].reverse().map(reachedInWords);
	studio.notify(title, [...others, changes ? `${changes}; ${growthsInWords(answer)}.` : "Nothing comes nearer."], {
		topic: ASKED,
		untouched: true,
	});
}

/** How far a search is, from 0 to 1. */
export const shareDone = ({ growths }: { readonly growths: number }): number => growths / MOST_GROWTHS;
