import { procedureOf } from "./panel_groups";
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
	{ keys: ["T"], does: "Thin by hand: a click takes a berry off; and back" },
	{ keys: ["K"], does: "Play the bunch's life, and pause" },
	{ keys: ["?"], does: "This help" },
	{ keys: ["←", "→", "↑", "↓"], does: "In the 3-D view: orbit; with Shift: move" },
	{ keys: ["+", "−", "0"], does: "In the 3-D view: nearer, further, reset view" },
	{ keys: ["Page ↑", "Page ↓"], does: "On the age: the next stage, the one before" },
	{ keys: ["Delete"], does: "On a slider: the preset's value; on the berry's: take it off" },
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

function letterOf(event: KeyboardEvent, studio: Studio, openHelp: () => void): (() => unknown) | undefined {
	if (event.altKey || document.querySelector("dialog[open]")) return undefined;
	const { ui, playing, specimen } = studio.state;
	// Only a natural bunch ages and is thinned.
	const natural = procedureOf(specimen) === "natural";
	const actions: Readonly<Record<string, () => unknown>> = {
		n: () => studio.newVariation(),
		s: () => studio.setUi({ stems: !ui.stems }),
		o: () => studio.setUi({ octahedron: !ui.octahedron }),
		t: () => natural && studio.setUi({ thinning: !ui.thinning }),
		k: () => natural && studio.setPlaying(!playing),
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
