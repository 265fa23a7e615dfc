/** State of the tool that edits single branches, and its actions on the document. */
import type { Change, EditorContext, Stateful } from "../../../ui/editor_context";
import type { GrowthPlant } from "../growth_plant";
import { text } from "../messages.generated";
import type { GrowthSpecimen } from "../specimen";
import { volumeTool } from "../volumes/volume_tool";
import { type BranchEdit, cutShare, type EditKind, MAX_EDITS, withEdit, withoutEdits } from "./branch_edit";
import { type Branch, type BranchPlace, branchesOf, lengthOf, siblingsOf } from "./branches";

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
/** Where the page holds the state. */
export const editing: Stateful<EditState> = { name: "branches", initial: OFF };

/** Where a branch that was chosen by keys is cut. */
export const USUAL_CUT = 0.4;

/** Begins editing; the handles of growth volumes make way. */
export function enter(context: EditContext): void {
	const volumes = context.toolState(volumeTool);
	if (volumes.handles) context.setToolState(volumeTool, { ...volumes, handles: false });
	context.setToolState(editing, { ...OFF, on: true });
}

/** Ends editing. */
export function leave(context: EditContext): void {
	context.setToolState(editing, OFF);
}

/** Chooses a branch, or none. */
export function choose(context: EditContext, chosen: BranchPlace | undefined): void {
	context.setToolState(editing, { ...context.toolState(editing), chosen, drawing: false });
}

/** Returns the chosen branch, if the tree has it. */
export function chosenBranch(context: EditContext): Branch | undefined {
	const { chosen } = context.toolState(editing);
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
	const { chosen } = context.toolState(editing);
	if (!chosen || !chosenBranch(context)) return;
	const { edits } = context.state.specimen;
	const shoot = chosen.address;
	if (kind !== "dead") put(context, { shoot, kind, at: cutShare(chosen.at) });
	else if (hasEdit(edits, shoot, "dead")) context.set(changeOf(withoutEdits(edits, shoot, "dead")));
	else put(context, { shoot, kind });
}

/** Removes all edits of the chosen branch: it grows as before. */
export function reset(context: EditContext): void {
	const { chosen } = context.toolState(editing);
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
