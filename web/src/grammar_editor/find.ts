/** Search in the text: CodeMirror's panel, with the page's wording. */
import { closeSearchPanel, findNext, findPrevious, openSearchPanel, search, searchPanelOpen } from "@codemirror/search";
import { EditorState, type Extension } from "@codemirror/state";
import { type EditorView, keymap } from "@codemirror/view";

const PHRASES = {
	next: "Next",
	previous: "Previous",
	all: "Select all",
	"match case": "Match case",
	regexp: "Pattern",
	"by word": "Whole words",
	replace: "Replace it",
	"replace all": "Replace all",
	close: "Close the search",
};

/** Opens the panel, or focuses its field. */
export function openFind(view: EditorView): boolean {
	openSearchPanel(view);
	const panel = view.dom.querySelector<HTMLElement>(".cm-search");
	if (panel) {
		panel.role = "search";
		panel.ariaLabel = "Find in the grammar";
	}
	return true;
}

/**
 * Closes the panel.
 * @returns whether the panel was open
 */
export const closeFind = (view: EditorView): boolean => searchPanelOpen(view.state) && closeSearchPanel(view);

const OPEN = "Mod-f";

/** Above the text, where no phone's keyboard covers it. */
export const finding: Extension = [
	search({ top: true }),
	EditorState.phrases.of(PHRASES),
	keymap.of([
		{ key: OPEN, run: openFind, scope: "editor search-panel" },
		{ key: "F3", run: findNext, shift: findPrevious, scope: "editor search-panel", preventDefault: true },
		{ key: "Escape", run: closeFind, scope: "search-panel" },
	]),
];
