import { html } from "lit";
import { flatVeins, type Leaf } from "../grown";
import type { FlatVeins } from "../outline/outline_canvas";
import type { OutlineEvent } from "../outline/outline_event";
import { CROSSES } from "../outline/outline_words";
import { madeSymmetric, type OutlinePoint } from "../outline/points";
import { enclosesBlade } from "../outline/spline";
import type { LeafContext, LeafTool } from "./context";
import "../outline/outline_view";

/** The flat editor of the outline. Its state: whether both sides move together. */
export const outline: LeafTool<boolean> = {
	name: "outline",
	initial: true,
	recall: (stored) => stored !== false,
	editor: { title: "Outline", draw },
	keys: [
		{ keys: ["Page ↑", "Page ↓"], does: "On a point of the outline: the one before, the next" },
		{ keys: ["Insert"], does: "On a point of the outline: another after it" },
		{ keys: ["Delete"], does: "On a point of the outline: takes it out" },
		{ keys: ["T"], does: "On a point of the outline: smooth, corner, rounded tip, pointed tip" },
	],
};

const GESTURE = "outline";

function draw(context: LeafContext): unknown {
	const { specimen, grown, grownFrom } = context.state;
	return html`<panicle-outline
		.points=${specimen.outline} .veins=${grown && veinsOf(grown, (grownFrom ?? specimen).parameters.length)}
		.millimetres=${specimen.parameters.length} .mirror=${context.toolState(outline)}
		@outline-input=${({ detail: { outline, run } }: OutlineEvent) => context.edit({ details: { outline }, run }, GESTURE)}
		@outline-change=${() => context.settle(GESTURE)} @outline-mirror=${() => toggleMirror(context)}
		@outline-refused=${() => context.notify(`${CROSSES} there`, ["It stays where it last did not."], { brief: true, topic: GESTURE })}
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

function veinsOf(leaf: Leaf, millimetres: number): FlatVeins {
	const before = known.get(leaf);
	if (before) return before;
	const veins = flatVeins(leaf, millimetres);
	known.set(leaf, veins);
	return veins;
}
