import { html } from "lit";
import { flatVeins, type Leaf } from "../grown";
import type { FlatVeins } from "../outline/outline_canvas";
import type { OutlineEvent } from "../outline/outline_event";
import { CROSSES } from "../outline/outline_words";
import { madeSymmetric, type OutlinePoint } from "../outline/points";
import { enclosesBlade } from "../outline/spline";
import type { LeafContext, LeafTool } from "./context";
import "../outline/outline_view";

/** The flat view of the outline with its points. The state: whether both sides move as one. */
export const outline: LeafTool<boolean> = {
	name: "outline",
	initial: true,
	recall: (kept) => kept !== false,
	editor: { title: "Outline", draw },
	keys: [
		{ keys: ["Page ↑", "Page ↓"], does: "On a point of the outline: the one before, the next" },
		{ keys: ["Insert"], does: "On a point of the outline: another after it" },
		{ keys: ["Delete"], does: "On a point of the outline: takes it out" },
		{ keys: ["T"], does: "On a point of the outline: smooth, corner, rounded tip, pointed tip" },
	],
};

const GESTURE = "outline";

function draw(desk: LeafContext): unknown {
	const { specimen, grown, grownFrom } = desk.state;
	return html`<panicle-outline
		.points=${specimen.outline} .veins=${grown && veinsOf(grown, (grownFrom ?? specimen).parameters.length)}
		.millimetres=${specimen.parameters.length} .mirror=${desk.toolState(outline)}
		@outline-input=${({ detail: { outline, run } }: OutlineEvent) => desk.edit({ details: { outline }, run }, GESTURE)}
		@outline-change=${() => desk.settle(GESTURE)} @outline-mirror=${() => toggleMirror(desk)}
		@outline-refused=${() => desk.notify(`${CROSSES} there`, ["It stays where it last did not."], { brief: true, topic: GESTURE })}
	></panicle-outline>`;
}

/** Locking brings the left side to the right one's shape at once, so that what is shown is what is locked. */
export function toggleMirror(desk: LeafContext): void {
	const mirror = !desk.toolState(outline);
	desk.setToolState(outline, mirror);
	if (mirror) setOutline(desk, madeSymmetric(desk.state.specimen.outline));
}

/** Another outline as one step; one that encloses nothing is none. */
export function setOutline(desk: LeafContext, points: OutlinePoint[]): void {
	if (enclosesBlade(points)) desk.set({ details: { outline: points } });
}

/** A leaf's flat veins, worked out once. */
const known = new WeakMap<Leaf, FlatVeins>();

function veinsOf(leaf: Leaf, millimetres: number): FlatVeins {
	const before = known.get(leaf);
	if (before) return before;
	const veins = flatVeins(leaf, millimetres);
	known.set(leaf, veins);
	return veins;
}
