import { ACTIONS, isLetter, type KeyCombination, type PageAction } from "./actions";
import { applying } from "./panel_groups";
import type { Studio } from "./studio";

/**
 * Handles the page's keyboard shortcuts. Text fields, lists and open dialogs keep their keys.
 * @returns a function that stops listening
 */
export function listenForShortcuts(studio: Studio): () => void {
	const listener = (event: KeyboardEvent) => {
		if (event.defaultPrevented || event.altKey || document.querySelector("dialog[open]")) return;
		const run = runOf(event, studio);
		if (!run) return;
		event.preventDefault();
		run();
	};
	window.addEventListener("keydown", listener);
	return () => window.removeEventListener("keydown", listener);
}

/** Returns the action of a key; undefined for keys without effect. */
function runOf(event: KeyboardEvent, studio: Studio): (() => void) | undefined {
	const pressed = (keys: KeyCombination) => isPressed(keys, event);
	const action = ACTIONS.find(({ shortcuts = [] }) => shortcuts.some(pressed));
	if (isTyping(event)) return action?.everywhere ? runnerOf(action, studio) : undefined;
	if (action?.shortcuts?.some((keys) => pressed(keys) && !isLetter(keys))) return runnerOf(action, studio);
	if (event.ctrlKey || event.metaKey) return undefined;
	return letterOf(event, action, studio);
}

/** Returns a function that runs an action unless it is unavailable now. */
const runnerOf = (action: PageAction, studio: Studio) => () => {
	if (action.isAvailable?.(studio) ?? true) action.run(studio);
};

/** Returns whether an event is a shortcut. Keys that are no letters may need Shift. */
function isPressed(keys: KeyCombination, { key, shiftKey, ctrlKey, metaKey }: KeyboardEvent): boolean {
	const isShift = keys.shift ?? (/[a-z]/.test(keys.key) ? false : shiftKey);
	const isCtrl = ctrlKey || metaKey;
	return key.toLowerCase() === keys.key && isShift === shiftKey && (keys.ctrl ?? false) === isCtrl;
}

/**
 * Returns the action of a single letter or sign; undefined for keys without effect. Letters have none if the user turned them
 * off, or while a tool uses them itself.
 */
function letterOf(event: KeyboardEvent, action: PageAction | undefined, studio: Studio): (() => void) | undefined {
	if (event.key === "Escape" && studio.state.growing) return () => studio.cancel();
	if (!studio.state.ui.letters) return undefined;
	const { modelUi, specimen } = studio.state;
	const tools = applying(modelUi?.tools, specimen);
	if (tools.some((tool) => tool.holdsLetters?.(studio))) return undefined;
	if (action) return runnerOf(action, studio);
	const pressed = event.key.toLowerCase();
	const tool = event.shiftKey ? undefined : tools.find(({ key }) => key?.letter === pressed);
	return tool && (() => tool.press?.(studio));
}

/**
 * Returns whether a text field or a list has the focus; these use Ctrl+Z and letters themselves. Sliders, switches and
 * colour fields do not.
 */
function isTyping(event: KeyboardEvent): boolean {
	const target = event.composedPath()[0];
	if (target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement) return true;
	if (target instanceof HTMLElement && target.isContentEditable) return true;
	return (
		target instanceof HTMLInputElement &&
		!["range", "checkbox", "radio", "color", "button", "file"].includes(target.type)
	);
}
