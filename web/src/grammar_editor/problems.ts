/** Shows the core's errors and remarks in the text. */
import { type Extension, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView, hoverTooltip } from "@codemirror/view";
import type { Problem } from "./reported_problems";

interface Placed extends Problem {
	readonly from: number;
	readonly to: number;
}

const problemsEffect = StateEffect.define<readonly Placed[]>();

/** Problems follow the text while it is edited, until they are replaced. */
const problems = StateField.define<readonly Placed[]>({
	create: () => [],
	update(value, transaction) {
		for (const effect of transaction.effects) if (effect.is(problemsEffect)) return effect.value;
		if (!transaction.docChanged) return value;
		const { changes } = transaction;
		return value.map((each) => ({ ...each, from: changes.mapPos(each.from, -1), to: changes.mapPos(each.to, 1) }));
	},
	provide: (field) => EditorView.decorations.from(field, marks),
});

/** Returns wavy lines under the problems as CodeMirror's decorations. */
function marks(all: readonly Placed[]): DecorationSet {
	const ranges = all
		.filter(({ from, to }) => to > from)
		.map(({ from, to, severity }) => Decoration.mark({ class: `cm-${severity}` }).range(from, to));
	return Decoration.set(ranges, true);
}

const hover = hoverTooltip(
	(view, place) => {
		const here = view.state.field(problems).filter(({ from, to }) => from <= place && place <= to);
		if (here.length === 0) return null;
		return {
			pos: Math.min(...here.map(({ from }) => from)),
			end: Math.max(...here.map(({ to }) => to)),
			/** Builds the tooltip: one line per problem. */
			create: () => {
				const dom = document.createElement("div");
				dom.className = "cm-problems";
				for (const { message, severity } of here) {
					const line = document.createElement("p");
					line.className = `cm-problem-${severity}`;
					line.textContent = message;
					dom.append(line);
				}
				return { dom };
			},
		};
	},
	{ hideOnChange: true },
);

/** Shows problems in the text, by a wavy line and under the pointer. */
export const showProblems: Extension = [problems, hover];

/** Replaces the problems shown in an editor. */
export function setProblems(view: EditorView, all: readonly Problem[]): void {
	view.dispatch({ effects: problemsEffect.of(all.map((each) => ({ ...each, ...placeOf(view, each) }))) });
}

/**
 * Returns the range of the word at a line and column; the last character of the line if the column is behind its end.
 */
export function placeOf(
	{ state }: EditorView,
	{ line, column }: Pick<Problem, "line" | "column">,
): { from: number; to: number } {
	const { from, to, text } = state.doc.line(Math.min(Math.max(line, 1), state.doc.lines));
	const before = placeInLine(text, column);
	WORD.lastIndex = before;
	const word = WORD.exec(text)?.[0] ?? "";
	if (word) return { from: from + before, to: from + before + word.length };
	const end = from + text.trimEnd().length;
	return { from: Math.max(from, end - 1), to: Math.max(end, Math.min(to, from + 1)) };
}

const WORD = /[\p{L}\p{N}_]+|-->|\S/uy;

/** Returns the index in a line of a column from 1. Columns count characters, not UTF-16 code units. */
function placeInLine(text: string, column: number): number {
	if (!hasPairs(text)) return Math.min(Math.max(0, column - 1), text.length);
	let place = 0;
	for (let count = 1; count < column && place < text.length; count++) place += isPairAt(text, place) ? 2 : 1;
	return place;
}

/** The last line checked, as a cache: most problems are in the same few lines. */
let looked = { text: "", pairs: false };

/** Returns whether any character of a line is a surrogate pair; remembers the last line. */
function hasPairs(text: string): boolean {
	if (looked.text !== text) looked = { text, pairs: /[\ud800-\udbff]/.test(text) };
	return looked.pairs;
}

/** Returns whether the character at an index is a surrogate pair. */
const isPairAt = (text: string, place: number): boolean => (text.codePointAt(place) ?? 0) > 0xffff;
