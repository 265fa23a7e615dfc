/** The keyboard shortcuts that the help lists. */
import type { ToolKey } from "../ui/tool";
import type { StudioState } from "./studio_state";

interface Shortcut {
	readonly keys: readonly string[];
	readonly does: string;
}

const FIRST: readonly Shortcut[] = [
	{ keys: ["Ctrl+Z"], does: "Undo" },
	{ keys: ["Ctrl+Shift+Z", "Ctrl+Y"], does: "Redo" },
	{ keys: ["Ctrl+S"], does: "Save, and what is saved" },
];
const NEW: Shortcut = { keys: ["N"], does: "New variation" };
const HELP: Shortcut = { keys: ["?"], does: "This help" };
const LAST: readonly Shortcut[] = [
	{ keys: ["Esc"], does: "While a plant takes long to grow: cancel" },
	{ keys: ["Shift+←", "Shift+→"], does: "On a slider: ten steps" },
	{ keys: ["←", "→", "↑", "↓"], does: "In the 3-D view: orbit; with Shift: move" },
	{ keys: ["+", "−", "0"], does: "In the 3-D view: nearer, further, reset view" },
	{ keys: ["Enter", "0 … 9"], does: "On a slider: type the number; Enter or Escape goes back" },
	{ keys: ["Delete"], does: "On a slider: the preset's value" },
];

/** All shortcuts, those of views, controls and tools included; single letters only while they are enabled. */
export function shortcuts({ modelUi, ui }: Pick<StudioState, "modelUi" | "ui">): readonly Shortcut[] {
	const tools = modelUi?.tools ?? [];
	const letter = ({ letter, does }: ToolKey) => ({ keys: [letter.toUpperCase()], does });
	return [
		...FIRST,
		...(ui.letters ? [NEW, ...tools.flatMap(({ key }) => (key ? [letter(key)] : [])), HELP] : []),
		...LAST,
		...tools.flatMap(({ keys = [] }) => keys),
	];
}
