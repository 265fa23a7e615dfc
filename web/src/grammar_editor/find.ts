/** Search in the text: CodeMirror's panel, with the page's wording. */
import { closeSearchPanel, findNext, findPrevious, openSearchPanel, search, searchPanelOpen } from "@codemirror/search";
import { EditorState, type Extension } from "@codemirror/state";
import { type EditorView, keymap } from "@codemirror/view";
import { text } from "./messages.generated";

/** Returns the panel's translated texts, by CodeMirror's English ones. */
const phrases = () => ({
	next: text("find_next"),
	previous: text("find_previous"),
	all: text("find_all"),
	"match case": text("find_case"),
	regexp: text("find_pattern"),
	"by word": text("find_words"),
	replace: text("find_replace"),
	"replace all": text("find_replace_all"),
	close: text("find_close"),
});

/** Opens the panel, or focuses its field. */
export function openFind(view: EditorView): boolean {
	openSearchPanel(view);
	const panel = view.dom.querySelector<HTMLElement>(".cm-search");
	if (panel) {
		panel.role = "search";
		panel.ariaLabel = text("find_panel");
	}
	return true;
}

/**
 * Closes the panel.
 * @returns whether the panel was open
 */
export const closeFind = (view: EditorView): boolean => searchPanelOpen(view.state) && closeSearchPanel(view);

const OPEN = "Mod-f";

/**
 * Returns the extension of the search panel and its keys. The panel is above the text, where no phone's keyboard covers
 * it.
 */
export const finding = (): Extension => [
	search({ top: true }),
	EditorState.phrases.of(phrases()),
	keymap.of([
		{ key: OPEN, run: openFind, scope: "editor search-panel" },
		{ key: "F3", run: findNext, shift: findPrevious, scope: "editor search-panel", preventDefault: true },
		{ key: "Escape", run: closeFind, scope: "search-panel" },
	]),
];
