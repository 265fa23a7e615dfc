/**
 * Replaces a selection when the user types over it. The browser would store the style of the replaced text as an
 * inline style, which the page's content security policy rejects with an error in the console.
 */
import { EditorView } from "@codemirror/view";

export const typingOver = EditorView.domEventHandlers({
	beforeinput({ inputType, data, isComposing }, view) {
		const { main, ranges } = view.state.selection;
		if (inputType !== "insertText" || data === null || isComposing || main.empty || ranges.length > 1) return false;
		const replace = () =>
			view.state.update(view.state.replaceSelection(data), { userEvent: "input.type", scrollIntoView: true });
		const handlers = view.state.facet(EditorView.inputHandler);
		if (!handlers.some((handle) => handle(view, main.from, main.to, data, replace))) view.dispatch(replace());
		return true;
	},
});
