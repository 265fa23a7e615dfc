/** Turns the core's codes into sentences: of errors, a plant's notes and its derivation's trace. */
import { coreMessage, coreText, holdsMessage, loadCoreMessages } from "../core/core_message";
import { CoreError } from "../core/errors";
import type { Message } from "../locale/texts";
import type { DerivationTrace, TraceEntry } from "../plant/derivation_trace";
import type { Plant } from "../plant/plant";

/** Returns the plant with readable notes and a readable trace. */
export async function readablePlant<P extends Plant>(plant: P): Promise<P> {
	const { notes, trace } = plant;
	if (!trace && !notes.some(holdsMessage)) return plant;
	await loadCoreMessages();
	const noteMessages = notes.flatMap(messageOf);
	return { ...plant, notes: notes.map(coreText), noteMessages, ...(trace ? { trace: readableTrace(trace) } : {}) };
}

/**
 * Returns the code and arguments of a note that begins with a message, with the text of the whole note; else nothing.
 */
function messageOf(note: string): Message[] {
	const message = coreMessage(note);
	return message ? [{ ...message, text: coreText(note) }] : [];
}

/** Returns the trace with readable reasons; call it after `loadCoreMessages`. */
export function readableTrace(trace: DerivationTrace): DerivationTrace {
	return { ...trace, modules: trace.modules.map(readableEntry) };
}

/** Returns one module of a trace with readable answers and refusals. */
function readableEntry(entry: TraceEntry): TraceEntry {
	const { answer, refusals } = entry;
	if (!answer?.words && !refusals) return entry;
	return {
		...entry,
		...(answer?.words ? { answer: { ...answer, words: coreText(answer.words) } } : {}),
		...(refusals ? { refusals: refusals.map((each) => ({ ...each, why: coreText(each.why) })) } : {}),
	};
}

/**
 * Returns whether a note is about a line of the plant's own text.
 * @param note as the core sends it
 */
export const isOnLine = (note: string): boolean =>
	coreMessage(note)?.code.startsWith("core.expression.at_line") ?? false;

/** Runs requests with errors that can be read. */
export const readable =
	<Args extends unknown[], Result>(run: (...args: Args) => Promise<Result>) =>
	(...args: Args): Promise<Result> =>
		run(...args).catch(async (error: unknown) => {
			throw await readableError(error);
		});

/** Returns the error with a readable message, its code and its arguments; other errors as they are. */
async function readableError(error: unknown): Promise<unknown> {
	if (!(error instanceof CoreError) || !holdsMessage(error.message)) return error;
	await loadCoreMessages();
	const message = coreMessage(error.message) ?? coreText(error.message);
	return new CoreError(error.reason, message, error.line, error.column);
}
