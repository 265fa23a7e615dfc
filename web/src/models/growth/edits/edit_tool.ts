/** Tool that edits single branches by hand: chosen in the 3-D view or by keys, then bent, drawn, cut or left to die. */
import { svg } from "lit";
import type { Change, EditorContext } from "../../../ui/editor_context";
import { LazyInteraction } from "../../../ui/handles/lazy_interaction";
import type { Tool } from "../../../ui/tool";
import type { GrowthPlant } from "../growth_plant";
import { text } from "../messages.generated";
import type { GrowthSpecimen } from "../specimen";
import { volumeTool } from "../volumes/volume_tool";
import { type BranchEdit, cutShare, type EditKind, MAX_EDITS, withEdit, withoutEdits } from "./branch_edit";
import { type Branch, type BranchPlace, branchesOf, lengthOf, siblingsOf } from "./branches";
import { drawChip } from "./edit_chip";
import { drawEdits } from "./edit_panel";

export type EditContext = EditorContext<GrowthSpecimen, GrowthPlant>;

/** State of the tool. */
export interface EditState {
	readonly on: boolean;
	/** The chosen branch, and the place on it where a cut is made. */
	readonly chosen: BranchPlace | undefined;
	/** Address of the branch under the pointer. */
	readonly marked: string | undefined;
	/** Whether the next stroke over the picture is the chosen branch's new curve. */
	readonly drawing: boolean;
}

const OFF: EditState = { on: false, chosen: undefined, marked: undefined, drawing: false };
/** Where a branch that was chosen by keys is cut. */
export const USUAL_CUT = 0.4;

/** A pruning saw over a branch. */
const ICON = svg`<path d="M10 17.500V9M10 12.500L4.500 7M10 9l3-3.500"/><path d="M12 10.500l5.500-5.500M13.200 11.700l5.500-5.500" stroke-dasharray="1.600 1.200"/>`;

export const editTool: Tool<GrowthSpecimen, GrowthPlant, EditState> = {
	name: "branches",
	initial: OFF,
	press: (context) => (context.toolState(editTool).on ? leave(context) : enter(context)),
	button: {
		slot: "edit",
		icon: ICON,
		get label() {
			return text("branch_edit");
		},
		pressed: (context) => context.toolState(editTool).on,
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
		subject: (context) => context.toolState(editTool).on || undefined,
		draw: drawEdits,
	},
	interaction: (view, context) =>
		new LazyInteraction({
			context,
			wanted: () => context.toolState(editTool).on,
			fetch: async () => new (await import("./edit_interaction")).EditInteraction(view, context),
			onFetchFailed: () => leave(context),
		}),
};

/** Begins editing; the handles of growth volumes make way. */
function enter(context: EditContext): void {
	const volumes = context.toolState(volumeTool);
	if (volumes.handles) context.setToolState(volumeTool, { ...volumes, handles: false });
	context.setToolState(editTool, { ...OFF, on: true });
}

/** Ends editing. */
export function leave(context: EditContext): void {
	context.setToolState(editTool, OFF);
}

/** Chooses a branch, or none. */
export function choose(context: EditContext, chosen: BranchPlace | undefined): void {
	context.setToolState(editTool, { ...context.toolState(editTool), chosen, drawing: false });
}

/** Returns the chosen branch, if the tree has it. */
export function chosenBranch(context: EditContext): Branch | undefined {
	const { chosen } = context.toolState(editTool);
	const { grown } = context.state;
	return grown && chosen ? branchesOf(grown).byAddress.get(chosen.address) : undefined;
}

/** Returns the change that sets the edits. */
export const changeOf = (edits: readonly BranchEdit[]): Change => ({ details: { edits } });

/** Adds an edit as an undo step; a notice if there are too many. */
export function put(context: EditContext, edit: BranchEdit): void {
	const edits = withEdit(context.state.specimen.edits, edit);
	if (edits.length > MAX_EDITS)
		context.notify(text("too_many_edits", { most: MAX_EDITS }), [], { topic: "branches", brief: true });
	else context.set(changeOf(edits));
}

/** Cuts the chosen branch, or marks it dead or alive again. */
export function act(context: EditContext, kind: Exclude<EditKind, "curve">): void {
	const { chosen } = context.toolState(editTool);
	if (!chosen || !chosenBranch(context)) return;
	const { edits } = context.state.specimen;
	const shoot = chosen.address;
	if (kind !== "dead") put(context, { shoot, kind, at: cutShare(chosen.at) });
	else if (hasEdit(edits, shoot, "dead")) context.set(changeOf(withoutEdits(edits, shoot, "dead")));
	else put(context, { shoot, kind });
}

/** Removes all edits of the chosen branch: it grows as before. */
export function reset(context: EditContext): void {
	const { chosen } = context.toolState(editTool);
	const { edits } = context.state.specimen;
	if (chosen && hasEdit(edits, chosen.address)) context.set(changeOf(withoutEdits(edits, chosen.address)));
}

/** Returns whether a branch has an edit, or one of a kind. */
export const hasEdit = (edits: readonly BranchEdit[], address: string, kind?: EditKind): boolean =>
	edits.some((each) => each.shoot === address && (kind === undefined || each.kind === kind));

/**
 * Returns whether a branch can be bent or drawn: it has its whole length only in the grown tree, and only where it is
 * not cut.
 */
export const canShape = ({ edits, parameters }: GrowthSpecimen, address: string): boolean =>
	parameters.age === 100 && !hasEdit(edits, address, "prune") && !hasEdit(edits, address, "break");

/** Describes a branch: "Branch 3 of 9 on the trunk, 4.2 m". */
export function branchInWords(plant: GrowthPlant, branch: Branch): string {
	const branches = branchesOf(plant);
	const siblings = siblingsOf(branches, branch);
	const values = {
		number: siblings.indexOf(branch.address) + 1,
		count: siblings.length,
		length: `${lengthOf(branch.line).toFixed(1)} m`,
	};
	if (branch.parent === undefined) return text("trunk_described", values);
	return branch.order === 1
		? text("limb_described", values)
		: text("twig_described", { ...values, order: branch.order });
}
