import type { Studio } from "./studio";

interface Shortcut {
	readonly keys: readonly string[];
	readonly does: string;
}

/** What the help lists, those of the views and controls included. */
export const SHORTCUTS: readonly Shortcut[] = [
	{ keys: ["Ctrl+Z"], does: "Undo" },
	{ keys: ["Ctrl+Shift+Z", "Ctrl+Y"], does: "Redo" },
	{ keys: ["N"], does: "New variation" },
	{ keys: ["S"], does: "Stems only, and back" },
	{ keys: ["O"], does: "Octahedron and its handles in 3-D, and back" },
	{ keys: ["?"], does: "This help" },
	{ keys: ["←", "→", "↑", "↓"], does: "In the 3-D view: orbit; with Shift: move" },
	{ keys: ["+", "−", "0"], does: "In the 3-D view: nearer, further, reset view" },
	{ keys: ["Delete"], does: "On a slider: the preset's value" },
];

/** Keys for the whole page. While text is typed, they are the text's. */
export function listenForShortcuts(studio: Studio, openHelp: () => void): void {
	window.addEventListener("keydown", (event) => {
		if (event.defaultPrevented || isTyping(event)) return;
		const action = event.ctrlKey || event.metaKey ? commandOf(event, studio) : letterOf(event, studio, openHelp);
		if (!action) return;
		event.preventDefault();
		action();
	});
}

function commandOf(event: KeyboardEvent, studio: Studio): (() => void) | undefined {
	const key = event.key.toLowerCase();
	if (key === "z") return () => (event.shiftKey ? studio.redo() : studio.undo());
	if (key === "y") return () => studio.redo();
	return undefined;
}

function letterOf(event: KeyboardEvent, studio: Studio, openHelp: () => void): (() => void) | undefined {
	if (event.altKey || document.querySelector("dialog[open]")) return undefined;
	const { ui } = studio.state;
	const actions: Readonly<Record<string, () => void>> = {
		n: () => studio.newVariation(),
		s: () => studio.setUi({ stems: !ui.stems }),
		o: () => studio.setUi({ octahedron: !ui.octahedron }),
		"?": openHelp,
	};
	return actions[event.key.toLowerCase()];
}

/** In a field that holds text, Ctrl+Z and letters belong to it; sliders, switches and pictures of colour hold none. */
function isTyping(event: KeyboardEvent): boolean {
	const target = event.composedPath()[0];
	if (target instanceof HTMLTextAreaElement) return true;
	return (
		target instanceof HTMLInputElement &&
		!["range", "checkbox", "radio", "color", "button", "file"].includes(target.type)
	);
}
