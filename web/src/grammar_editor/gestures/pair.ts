/** Selects the two axes that gestures control, and the next two. */
import type { Axis } from "./axis";

/** Ids of the axes; undefined if there is none. */
export interface Pair {
	readonly across: string | undefined;
	readonly up: string | undefined;
}

/** Petrenko 2014, section 4.3.3: horizontal movement bends the stem, vertical movement changes its length. */
const USUAL: Pair = { across: "constant bend", up: "constant length" };

/** Returns the axes of a pair. A missing axis is replaced by the usual one, or else by the first one. */
export function pairOf(axes: readonly Axis[], { across, up }: Pair): { readonly across?: Axis; readonly up?: Axis } {
	const find = (id: string | undefined) => axes.find((axis) => axis.id === id);
	const [right, above] = [find(across) ?? find(USUAL.across), find(up) ?? find(USUAL.up)];
	const first = right ?? axes.find((axis) => axis !== above);
	const second = above ?? axes.find((axis) => axis !== first);
	return { ...(first ? { across: first } : {}), ...(second ? { up: second } : {}) };
}

/** Returns the next pair of all axes, cyclically; with an odd number, the last axis is paired with the first. */
export function nextPair(axes: readonly Axis[], { across, up }: Pair): Pair {
	if (axes.length < 2) return { across, up };
	const last = Math.max(...[across, up].map((id) => axes.findIndex((axis) => axis.id === id)));
	const first = last + 1 < axes.length ? last + 1 : 0;
	return { across: axes[first].id, up: axes[(first + 1) % axes.length].id };
}
