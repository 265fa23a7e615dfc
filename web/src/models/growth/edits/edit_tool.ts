/** Tool that edits single branches by hand: chosen in the 3-D view or by keys, then bent, drawn, cut or left to die. */
import { svg } from "lit";
import { LazyInteraction } from "../../../ui/handles/lazy_interaction";
import type { Tool } from "../../../ui/tool";
import type { GrowthPlant } from "../growth_plant";
import { text } from "../messages.generated";
import type { GrowthSpecimen } from "../specimen";
import { drawChip } from "./edit_chip";
import { drawEdits } from "./edit_panel";
import { type EditState, editing, enter, leave } from "./edit_state";

/** A pruning saw over a branch. */
const ICON = svg`<path d="M10 17.500V9M10 12.500L4.500 7M10 9l3-3.500"/><path d="M12 10.500l5.500-5.500M13.200 11.700l5.500-5.500" stroke-dasharray="1.600 1.200"/>`;

export const editTool: Tool<GrowthSpecimen, GrowthPlant, EditState> = {
	...editing,
	press: (context) => (context.toolState(editing).on ? leave(context) : enter(context)),
	button: {
		slot: "edit",
		icon: ICON,
		get label() {
			return text("branch_edit");
		},
		pressed: (context) => context.toolState(editing).on,
	},
	key: {
		letter: "b",
		get description() {
			return text("branch_edit_key");
		},
	},
	keys: [
		{
			get keys() {
				return [text("arrow_keys")];
			},
			get description() {
				return text("branch_key_arrows");
			},
		},
		{
			keys: ["P", "B", "D", "R"],
			get description() {
				return text("branch_key_letters");
			},
		},
	],
	chip: {
		get title() {
			return text("branch_chosen");
		},
		draw: drawChip,
	},
	panel: {
		group: "shoots",
		place: "above",
		subject: (context) => context.toolState(editing).on || undefined,
		draw: drawEdits,
	},
	interaction: (view, context) =>
		new LazyInteraction({
			context,
			wanted: () => context.toolState(editing).on,
			fetch: async () => new (await import("./edit_interaction")).EditInteraction(view, context),
			onFetchFailed: () => leave(context),
		}),
};
