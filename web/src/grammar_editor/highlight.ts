/** Colours the tokens of the text, in the visible ranges only. */
import { type EditorState, type Extension, StateField, type Text } from "@codemirror/state";
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
import type { GrammarOutline } from "./outline";
import { readOutline } from "./read_outline";
import { firstEndingBehind, type Token, type TokenKind } from "./scan";

/** Reads the outline of a text in the editor's language. */
const read = (text: string, state: EditorState): GrammarOutline => readOutline(text, state.facet(dialect));

/** Outline of the current text, shared by all extensions. */
export const outlined = StateField.define<GrammarOutline>({
	create: (state) => read(state.doc.toString(), state),
	update: (value, { docChanged, newDoc, startState }) => (docChanged ? read(newDoc.toString(), startState) : value),
});

const MARKS = new Map<TokenKind, Decoration>(
	(["comment", "statement", "arrow", "symbol", "branch", "name", "function", "number", "operator"] as const).map(
		(kind) => [kind, Decoration.mark({ class: `cm-${kind}` })],
	),
);

/**
 * Longest line that is coloured, in characters. Browsers compute the layout of a line as a whole, which takes long for
 * thousands of tokens.
 */
export const LONGEST_COLOURED = 10_000;

/** Returns the tokens to colour: those in the ranges, except in long lines. */
export function colouredPieces(
	pieces: readonly Token[],
	doc: Text,
	ranges: readonly { readonly from: number; readonly to: number }[],
): Token[] {
	const found: Token[] = [];
	for (const { from, to } of ranges) {
		let index = firstEndingBehind(pieces, from);
		while (index < pieces.length && pieces[index].from < to) {
			const line = doc.lineAt(pieces[index].from);
			// A comment may end in a later line.
			if (line.length > LONGEST_COLOURED) index = Math.max(index + 1, firstEndingBehind(pieces, line.to));
			else found.push(pieces[index++]);
		}
	}
	return found;
}

/** Returns the coloured tokens of the visible ranges as CodeMirror's decorations. */
function coloured({ state, visibleRanges }: EditorView): DecorationSet {
	const marks = colouredPieces(state.field(outlined).pieces, state.doc, visibleRanges).flatMap(
		(piece) => MARKS.get(piece.kind)?.range(piece.from, piece.to) ?? [],
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

/** Colours of tokens, and tooltips. */
export const highlight: Extension = [outlined, colours, help];
