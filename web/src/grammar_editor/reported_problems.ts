/** Problems of a grammar as the core reports them: the fault that prevents growth, and remarks on the last plant. */
import type { Message } from "../locale/texts";
import { isOnText } from "../plant/text_notes";
import type { Fault } from "../ui/editor_context";

/** Error or remark with a place in the text. */
export interface Problem {
	readonly severity: "error" | "remark";
	/** From 1; columns count characters. */
	readonly line: number;
	readonly column: number;
	readonly message: string;
}

/** Returns whether two lists have the same problems in the same places. */
export function sameProblems(some: readonly Problem[], others: readonly Problem[]): boolean {
	const alike = (a: Problem, b: Problem) =>
		a.line === b.line && a.column === b.column && a.severity === b.severity && a.message === b.message;
	return some.length === others.length && some.every((each, i) => alike(each, others[i]));
}

/**
 * Returns the problems that have a place in the text.
 * @param notes the plant's notes with codes
 */
export function problemsOf(fault: Fault | undefined, notes: readonly Message[]): Problem[] {
	if (fault) return fault.line > 0 ? [{ severity: "error", ...fault }] : [];
	return notes.filter(isOnText).map(({ args: { line, column = 1, problem } }) => ({
		severity: "remark",
		line: Number(line),
		column: Number(column),
		message: String(problem),
	}));
}
