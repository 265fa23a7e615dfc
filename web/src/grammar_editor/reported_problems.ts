/** Problems of a grammar as the core reports them: the fault that prevents growth, and remarks on the last plant. */
import type { Fault } from "../ui/editor_context";

/** Error or remark with a place in the text. */
export interface Problem {
	readonly severity: "error" | "remark";
	/** From 1; columns count characters. */
	readonly line: number;
	readonly column: number;
	readonly message: string;
}

/** Whether two lists have the same problems in the same places. */
export function sameProblems(some: readonly Problem[], others: readonly Problem[]): boolean {
	const alike = (a: Problem, b: Problem) =>
		a.line === b.line && a.column === b.column && a.severity === b.severity && a.message === b.message;
	return some.length === others.length && some.every((each, i) => alike(each, others[i]));
}

/**
 * Returns the problems that have a place in the text.
 * @param notes the plant's notes; remarks among them begin with their place
 */
export function problemsOf(fault: Fault | undefined, notes: readonly string[]): Problem[] {
	if (fault) return fault.line > 0 ? [{ severity: "error", ...fault }] : [];
	return notes.flatMap((note) => {
		const [, line, column, message] = /^Line (\d+), column (\d+): (.+)$/s.exec(note) ?? [];
		return message ? [{ severity: "remark", line: Number(line), column: Number(column), message } as const] : [];
	});
}
