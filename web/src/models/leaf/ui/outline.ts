import { html } from "lit";
import { flatVeins, type Leaf } from "../grown";
import { text } from "../messages.generated";
import type { FlatVeins } from "../outline/outline_canvas";
import type { OutlineEvent } from "../outline/outline_event";
import { madeSymmetric, type OutlinePoint } from "../outline/points";
import { enclosesBlade } from "../outline/spline";
import type { LeafContext, LeafTool } from "./context";
import "../outline/outline_view";

/** The flat editor of the outline. Its state: whether both sides move together. */
export const outline: LeafTool<boolean> = {
	name: "outline",
	initial: true,
	recall: (stored) => stored !== false,
	editor: {
		get title() {
			return text("outline");
		},
		draw,
	},
	keys: [
		{
			keys: ["Page ↑", "Page ↓"],
			get description() {
				return text("key_page");
			},
		},
		{
			keys: ["Insert"],
			get description() {
				return text("key_insert");
			},
		},
		{
			keys: ["Delete"],
			get description() {
				return text("key_delete");
			},
		},
		{
			keys: ["T"],
			get description() {
				return text("key_kind");
			},
		},
	],
};

const GESTURE = "outline";

/** Renders the view of the outline, connected to the document. */
function draw(context: LeafContext): unknown {
	const { specimen, grown, grownFrom } = context.state;
	return html`<panicle-outline
		.points=${specimen.outline} .veins=${grown && veinsOf(grown, (grownFrom ?? specimen).parameters.length)}
		.millimetres=${specimen.parameters.length} .mirror=${context.toolState(outline)}
		@outline-input=${({ detail: { outline, run } }: OutlineEvent) => context.edit({ details: { outline }, run }, GESTURE)}
		@outline-change=${() => context.settle(GESTURE)} @outline-mirror=${() => toggleMirror(context)}
		@outline-refused=${() => context.notify(text("would_cross_there"), [text("stays")], { brief: true, topic: GESTURE })}
	></panicle-outline>`;
}

/** Toggles the lock. Locking mirrors the right side to the left at once. */
export function toggleMirror(context: LeafContext): void {
	const mirror = !context.toolState(outline);
	context.setToolState(outline, mirror);
	if (mirror) setOutline(context, madeSymmetric(context.state.specimen.outline));
}

/** Sets the outline as one undo step; ignores outlines that enclose no blade. */
export function setOutline(context: LeafContext, points: OutlinePoint[]): void {
	if (enclosesBlade(points)) context.set({ details: { outline: points } });
}

/** Cache of the leaves' flat veins. */
const known = new WeakMap<Leaf, FlatVeins>();

/**
 * Returns the flat veins of a leaf, from the cache where possible, so that the view sees the same object again.
 * @param millimetres length of the leaf
 */
function veinsOf(leaf: Leaf, millimetres: number): FlatVeins {
	const before = known.get(leaf);
	if (before) return before;
	const veins = flatVeins(leaf, millimetres);
	known.set(leaf, veins);
	return veins;
}
