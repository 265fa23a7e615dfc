import { applying } from "./panel_groups";
import type { Studio } from "./studio";

/** Dialogs that keys open. */
export interface Opens {
	help(): void;
	saved(): void;
}

/**
 * Handles the page's keyboard shortcuts. Text fields, lists and open dialogs keep their keys.
 * @returns a function that stops listening
 */
export function listenForShortcuts(studio: Studio, opens: Opens): () => void {
	const listener = (event: KeyboardEvent) => {
		if (event.defaultPrevented || isTyping(event) || document.querySelector("dialog[open]")) return;
		const action = event.ctrlKey || event.metaKey ? commandOf(event, studio, opens) : letterOf(event, studio, opens);
		if (!action) return;
		event.preventDefault();
		action();
	};
	window.addEventListener("keydown", listener);
	return () => window.removeEventListener("keydown", listener);
}

function commandOf(event: KeyboardEvent, studio: Studio, { saved }: Opens): (() => void) | undefined {
	const key = event.key.toLowerCase();
	if (key === "z") return () => (event.shiftKey ? studio.redo() : studio.undo());
	if (key === "y") return () => studio.redo();
	if (key === "s" && !event.shiftKey) return saved;
	return undefined;
}

function letterOf(event: KeyboardEvent, studio: Studio, { help }: Opens): (() => void) | undefined {
	if (event.altKey) return undefined;
	if (event.key === "Escape" && studio.state.growing) return () => studio.cancel();
	if (!studio.state.ui.letters) return undefined;
	// "?" may need Shift; no letter does.
	if (event.shiftKey && event.key !== "?") return undefined;
	const { modelUi, specimen } = studio.state;
	const tools = applying(modelUi?.tools, specimen);
	if (tools.some((tool) => tool.holdsLetters?.(studio))) return undefined;
	const pressed = event.key.toLowerCase();
	if (pressed === "n") return () => studio.newVariation();
	if (pressed === "?") return help;
	const tool = tools.find(({ key }) => key?.letter === pressed);
	return tool && (() => tool.press?.(studio));
}

/** Whether a text field or a list has the focus; these use Ctrl+Z and letters themselves. Sliders, switches and colour fields do not. */
function isTyping(event: KeyboardEvent): boolean {
	const target = event.composedPath()[0];
	if (target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement) return true;
	if (target instanceof HTMLElement && target.isContentEditable) return true;
	return (
		target instanceof HTMLInputElement &&
		!["range", "checkbox", "radio", "color", "button", "file"].includes(target.type)
	);
}
