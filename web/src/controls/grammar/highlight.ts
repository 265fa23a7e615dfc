/** A text's pieces in their colours, read anew with every change of it; only what is seen is marked. */
import { type EditorState, type Extension, StateField } from "@codemirror/state";
import {
	Decoration,
	type DecorationSet,
	type EditorView,
	hoverTooltip,
	ViewPlugin,
	type ViewUpdate,
} from "@codemirror/view";
import { dialect } from "./dialect";
import { explain } from "./explain";
import { type Outline, outlineOf } from "./outline";
import type { Kind } from "./scan";

const read = (text: string, state: EditorState): Outline => outlineOf(text, state.facet(dialect).scan(text));

/** What the text has, for all that asks. */
export const outlined = StateField.define<Outline>({
	create: (state) => read(state.doc.toString(), state),
	update: (value, { docChanged, newDoc, startState }) => (docChanged ? read(newDoc.toString(), startState) : value),
});

const MARKS = new Map<Kind, Decoration>(
	(["comment", "statement", "arrow", "symbol", "branch", "name", "function", "number", "operator"] as const).map(
		(kind) => [kind, Decoration.mark({ class: `cm-${kind}` })],
	),
);

function coloured({ state, visibleRanges }: EditorView): DecorationSet {
	const { pieces } = state.field(outlined);
	const marks = visibleRanges.flatMap(({ from, to }) =>
		pieces.flatMap((piece) => {
			const mark = piece.to > from && piece.from < to ? MARKS.get(piece.kind) : undefined;
			return mark ? [mark.range(piece.from, piece.to)] : [];
		}),
	);
	return Decoration.set(marks, true);
}

const colours = ViewPlugin.fromClass(
	class {
		decorations: DecorationSet;
		constructor(view: EditorView) {
			this.decorations = coloured(view);
		}
		update({ docChanged, viewportChanged, view }: ViewUpdate): void {
			if (docChanged || viewportChanged) this.decorations = coloured(view);
		}
	},
	{ decorations: ({ decorations }) => decorations },
);

const help = hoverTooltip(
	({ state }, place) => {
		const found = explain(state.field(outlined), place, state.facet(dialect).words);
		if (!found || found.to <= place) return null;
		return {
			pos: found.from,
			end: found.to,
			create: () => {
				const dom = document.createElement("div");
				dom.className = "cm-help";
				const written = document.createElement("code");
				written.textContent = found.written;
				dom.append(written, ` ${found.help}`);
				return { dom };
			},
		};
	},
	{ hideOnChange: true },
);

/** Colours, and help under the pointer. */
export const highlight: Extension = [outlined, colours, help];
