/** The editor as the page looks: its colours and faces are the page's own (studio/style/tokens.css). */
import { EditorView } from "@codemirror/view";

const mono = { fontFamily: "var(--mono)", fontSize: "var(--code-size, 13px)", lineHeight: "1.55" };

export const EDITOR_STYLE = EditorView.theme({
	"&": { height: "100%", color: "var(--ink)", backgroundColor: "transparent" },
	"&.cm-focused": { outline: "2px solid var(--wine)", outlineOffset: "-2px" },
	".cm-scroller": {
		...mono,
		overscrollBehavior: "contain",
		scrollbarWidth: "thin",
		scrollbarColor: "var(--hairline) transparent",
	},
	".cm-content": { padding: "10px 0 40px", caretColor: "var(--wine)" },
	".cm-line": { padding: "0 12px 0 8px" },
	".cm-cursor": { borderLeftColor: "var(--wine)", borderLeftWidth: "2px" },
	".cm-gutters": { border: "0", backgroundColor: "transparent", color: "var(--ink-soft)" },
	".cm-lineNumbers .cm-gutterElement": { minWidth: "34px", padding: "0 4px 0 8px", opacity: "0.75" },
	"&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": {
		background: "var(--code-selected)",
	},
	"&.cm-focused .cm-matchingBracket": { backgroundColor: "transparent", outline: "1px solid var(--wine)" },
	"&.cm-focused .cm-nonmatchingBracket": { backgroundColor: "transparent", outline: "1px dotted var(--wine)" },
	".cm-comment": { color: "var(--ink-soft)", fontStyle: "italic" },
	".cm-statement": { color: "var(--wine)" },
	".cm-arrow": { color: "var(--wine)" },
	".cm-symbol": { color: "var(--code-symbol)" },
	".cm-branch": { color: "var(--code-symbol)", fontWeight: "600" },
	".cm-function": { color: "var(--code-function)" },
	".cm-number": {
		color: "var(--code-number)",
		cursor: "ew-resize",
		textDecoration: "underline dotted 1px",
		textUnderlineOffset: "3px",
	},
	".cm-operator": { color: "var(--ink-soft)" },
	"&.cm-scrubbing, &.cm-scrubbing *": { cursor: "ew-resize" },
	".cm-error": { textDecoration: "underline wavy 1.5px var(--code-error)", textUnderlineOffset: "3px" },
	".cm-remark": { textDecoration: "underline wavy 1px var(--code-function)", textUnderlineOffset: "3px" },
	".cm-tooltip": {
		maxWidth: "min(360px, 90vw)",
		border: "1px solid var(--hairline)",
		borderRadius: "6px",
		backgroundColor: "var(--paper-raised)",
		boxShadow: "0 6px 20px var(--shadow)",
		color: "var(--ink)",
		fontFamily: "var(--sans)",
		fontSize: "13px",
	},
	".cm-help, .cm-told": { padding: "6px 10px" },
	".cm-help code": { color: "var(--code-symbol)", fontFamily: "var(--mono)" },
	".cm-told p": { margin: "0" },
	".cm-tooltip.cm-tooltip-autocomplete > ul": { maxHeight: "14em", fontFamily: "var(--mono)", fontSize: "13px" },
	".cm-tooltip.cm-tooltip-autocomplete > ul > li": { padding: "3px 8px" },
	".cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]": {
		backgroundColor: "var(--wine-fill)",
		color: "var(--on-wine)",
	},
	".cm-completionDetail": { color: "var(--ink-soft)", fontStyle: "normal" },
	"li[aria-selected] .cm-completionDetail": { color: "inherit" },
	".cm-completionMatchedText": { textDecoration: "none", fontWeight: "700" },
	".cm-completionInfo": { padding: "6px 10px" },
});
