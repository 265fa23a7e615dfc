/** Edits of single branches by hand, as documents hold them (wasm-core/src/models/growth/edits.hpp). */

export type EditPoint = readonly [x: number, y: number, z: number];

/** Kinds of edits, in the order of the core's numbers. */
export const EDIT_KINDS = ["prune", "break", "dead", "curve"] as const;
export type EditKind = (typeof EDIT_KINDS)[number];

/** A cut at a share of the branch's internodes, 0.01 … 0.99. */
export interface CutEdit {
	/** Address of the branch or trunk: 16 hexadecimal digits. */
	readonly shoot: string;
	readonly kind: "prune" | "break";
	readonly at: number;
}

/** A branch that is dead, with all that grows on it. */
export interface DeadEdit {
	readonly shoot: string;
	readonly kind: "dead";
}

/** A branch that follows a curve through points relative to its base, metres. */
export interface CurveEdit {
	readonly shoot: string;
	readonly kind: "curve";
	readonly points: readonly EditPoint[];
}

export type BranchEdit = CutEdit | DeadEdit | CurveEdit;

/** Limits of the core. */
export const MAX_EDITS = 256;
export const MAX_POINTS = 16;
const MAX_REACH = 300;

/** Returns the share of a cut as documents hold it: within its range, to the hundredth. */
export const cutShare = (share: number): number => Math.round(100 * Math.min(0.99, Math.max(0.01, share))) / 100;

/** Returns a point as documents hold it: within the reach of a branch, to the centimetre. */
export function editPoint(point: EditPoint): EditPoint {
	const [x, y, z] = point.map((value) => Math.round(100 * Math.min(MAX_REACH, Math.max(-MAX_REACH, value))) / 100 + 0);
	return [x, y, z];
}

/** Returns the subject of a kind of edit: a later one of the same subject replaces it on the same branch. */
const subjectOf = (kind: EditKind): string => (kind === "prune" || kind === "break" ? "cut" : kind);

/** Returns the edits with one more, which replaces an earlier one of the same subject on the same branch. */
export function withEdit(edits: readonly BranchEdit[], edit: BranchEdit): readonly BranchEdit[] {
	const others = edits.filter(({ shoot, kind }) => shoot !== edit.shoot || subjectOf(kind) !== subjectOf(edit.kind));
	return [...others, edit];
}

/** Returns the edits without those of a branch, or without one of them. */
export const withoutEdits = (edits: readonly BranchEdit[], shoot: string, kind?: EditKind): readonly BranchEdit[] =>
	edits.filter((each) => each.shoot !== shoot || (kind !== undefined && each.kind !== kind));
