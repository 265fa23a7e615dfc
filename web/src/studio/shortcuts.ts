import type { ToolKey } from "../controls/tool";
import { applying } from "./panel_groups";
import type { Studio } from "./studio";
import type { StudioState } from "./studio_state";

interface Shortcut {
	readonly keys: readonly string[];
	readonly does: string;
}

const FIRST: readonly Shortcut[] = [
	{ keys: ["Ctrl+Z"], does: "Undo" },
	{ keys: ["Ctrl+Shift+Z", "Ctrl+Y"], does: "Redo" },
];
const NEW: Shortcut = { keys: ["N"], does: "New variation" };
const HELP: Shortcut = { keys: ["?"], does: "This help" };
const LAST: readonly Shortcut[] = [
	{ keys: ["Shift+←", "Shift+→"], does: "On a slider: ten steps" },
	{ keys: ["←", "→", "↑", "↓"], does: "In the 3-D view: orbit; with Shift: move" },
	{ keys: ["+", "−", "0"], does: "In the 3-D view: nearer, further, reset view" },
	{ keys: ["Enter", "0 … 9"], does: "On a slider: type the number; Enter or Escape goes back" },
	{ keys: ["Delete"], does: "On a slider: the preset's value" },
];

/** What the help lists, those of the views, controls and tools included; letters only while they are keys. */
export function shortcuts({ face, ui }: Pick<StudioState, "face" | "ui">): readonly Shortcut[] {
	const tools = face?.tools ?? [];
	const letter = ({ letter, does }: ToolKey) => ({ keys: [letter.toUpperCase()], does });
	return [
		...FIRST,
		...(ui.letters ? [NEW, ...tools.flatMap(({ key }) => (key ? [letter(key)] : [])), HELP] : []),
		...LAST,
		...tools.flatMap(({ keys = [] }) => keys),
	];
}

/** Keys for the whole page. While text is typed or a list is open, they are the field's. Returns what ends it. */
export function listenForShortcuts(studio: Studio, openHelp: () => void): () => void {
	const listener = (event: KeyboardEvent) => {
		if (event.defaultPrevented || isTyping(event)) return;
		const action = event.ctrlKey || event.metaKey ? commandOf(event, studio) : letterOf(event, studio, openHelp);
		if (!action) return;
		event.preventDefault();
		action();
	};
	window.addEventListener("keydown", listener);
	return () => window.removeEventListener("keydown", listener);
}

function commandOf(event: KeyboardEvent, studio: Studio): (() => void) | undefined {
	const key = event.key.toLowerCase();
	if (key === "z") return () => (event.shiftKey ? studio.redo() : studio.undo());
	if (key === "y") return () => studio.redo();
	return undefined;
}

function letterOf(event: KeyboardEvent, studio: Studio, openHelp: () => void): (() => void) | undefined {
	if (event.altKey || !studio.state.ui.letters || document.querySelector("dialog[open]")) return undefined;
	// "?" may need Shift; no letter does.
	if (event.shiftKey && event.key !== "?") return undefined;
	const pressed = event.key.toLowerCase();
	if (pressed === "n") return () => studio.newVariation();
	if (pressed === "?") return openHelp;
	const { face, specimen } = studio.state;
	const tool = applying(face?.tools, specimen).find(({ key }) => key?.letter === pressed);
	return tool && (() => tool.press?.(studio));
}

/** In a field that holds text, and in a list, Ctrl+Z and letters belong to it; sliders, switches and pictures of colour hold none. */
function isTyping(event: KeyboardEvent): boolean {
	const target = event.composedPath()[0];
	if (target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement) return true;
	if (target instanceof HTMLElement && target.isContentEditable) return true;
	return (
		target instanceof HTMLInputElement &&
		!["range", "checkbox", "radio", "color", "button", "file"].includes(target.type)
	);
}
