/**
 * Marks productions of the chosen module in the text: the production that rewrites it next, and the one that wrote it.
 */
import { type Extension, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView } from "@codemirror/view";

/** Lines of the text, counted from 1. */
export interface MarkedProductions {
	readonly fires?: number | undefined;
	readonly wrote?: number | undefined;
}

const marked = StateEffect.define<DecorationSet>();

const marks = StateField.define<DecorationSet>({
	create: () => Decoration.none,
	update(value, transaction) {
		for (const effect of transaction.effects) if (effect.is(marked)) return effect.value;
		return value.map(transaction.changes);
	},
	provide: (field) => EditorView.decorations.from(field),
});

const FIRES = Decoration.line({ class: "cm-fires" });
const WROTE = Decoration.line({ class: "cm-wrote" });

/** Extension that stores and draws the marks. */
export const productionMarks: Extension = marks;

/** Marks productions and scrolls to the first of them; the cursor and the focus stay. */
export function markProductions(view: EditorView, { fires, wrote }: MarkedProductions): void {
	const { doc } = view.state;
	const startOfLine = (line: number | undefined) =>
		line === undefined || line < 1 || line > doc.lines ? undefined : doc.line(line).from;
	const [next, before] = [startOfLine(fires), startOfLine(wrote)];
	const ranges = [
		...(next === undefined ? [] : [FIRES.range(next)]),
		...(before === undefined ? [] : [WROTE.range(before)]),
	];
	const shown = next ?? before;
	view.dispatch({
		effects: [
			marked.of(Decoration.set(ranges, true)),
			...(shown === undefined ? [] : [EditorView.scrollIntoView(shown, { y: "nearest", yMargin: 30 })]),
		],
	});
}
