/** The keyboard shortcuts of the page and of the model's tools, by group. */
import type { ToolKey } from "../../ui/tool";
import { ACTIONS, isLetter, keysInWords, type PageAction } from "../actions";
import type { StudioState } from "../studio_state";
import { text } from "./messages.generated";

interface Shortcut {
	readonly keys: readonly string[];
	readonly description: string;
}

export interface ShortcutGroup {
	readonly key: "general" | "view" | "controls" | "tools";
	readonly shortcuts: readonly Shortcut[];
}

/** Returns the groups that have shortcuts; single letters and signs only while they are enabled. */
export function shortcutGroups(state: Pick<StudioState, "modelUi" | "ui" | "dark">): readonly ShortcutGroup[] {
	const { modelUi, ui } = state;
	const tools = modelUi?.tools ?? [];
	const ofTool = ({ letter, description }: ToolKey) => ({ keys: [letter.toUpperCase()], description });
	const ofAction = (action: PageAction): readonly Shortcut[] => {
		const keys = action.shortcuts?.filter((each) => ui.letters || !isLetter(each)).map(keysInWords) ?? [];
		return keys.length > 0 ? [{ keys, description: action.description?.() ?? action.title(state) }] : [];
	};
	const ofActions = (group: PageAction["group"]) => ACTIONS.filter((each) => each.group === group).flatMap(ofAction);
	const groups: readonly ShortcutGroup[] = [
		{ key: "general", shortcuts: [...ofActions(undefined), { keys: ["Esc"], description: text("cancel") }] },
		{
			key: "view",
			shortcuts: [
				{ keys: ["←", "→", "↑", "↓"], description: text("view_rotate") },
				{ keys: ["+", "−", "0"], description: text("view_zoom") },
				...ofActions("view"),
			],
		},
		{
			key: "controls",
			shortcuts: [
				{ keys: ["Shift+←", "Shift+→"], description: text("slider_steps") },
				{ keys: ["Enter", "0 … 9"], description: text("slider_type") },
				{ keys: ["Delete"], description: text("slider_reset") },
			],
		},
		{
			key: "tools",
			shortcuts: [
				...tools.flatMap(({ key }) => (key && ui.letters ? [ofTool(key)] : [])),
				...tools.flatMap(({ keys = [] }) => keys),
			],
		},
	];
	return groups.filter(({ shortcuts }) => shortcuts.length > 0);
}
