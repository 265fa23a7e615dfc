/**
 * The octahedron's control points (paper section 4.2, figure 5a): p1 fixed at the top, p2 below it at the bunch's
 * length, p3 right and p4 left in the front view, p5 front and p6 back in the side view. Everything here is in pixels
 * of the paper's 600 × 600 view: x away from the axis to the right, y down from p1. The side view is the bunch seen
 * from its left, so p5 stands at the right as p3 does in front.
 */

import { formatNumber } from "../../../locale/format";
import type { Point } from "../../../ui/handles/point";
import { text } from "../messages.generated";
import type { NumberKey } from "../parameters.generated";

export type View = "front" | "side";
export type SideHandle = "p3" | "p4" | "p5" | "p6";
export type Handle = "p2" | SideHandle;
export type ShapeKey = Extract<NumberKey, "l" | `${SideHandle}${"w" | "r"}`>;

/** Numbers that the handles set; a specimen's parameters contain them. */
export type BunchShape = Record<ShapeKey, number>;

/** Pairs of sides that move as one. */
export interface Locks {
	leftRight: boolean;
	frontBack: boolean;
}

interface Side {
	/** Case of its messages. */
	name: "right" | "left" | "front" | "back";
	view: View;
	/** Side of the axis in its view. */
	sign: 1 | -1;
	opposite: SideHandle;
	lock: keyof Locks;
}

export const SIDES: Record<SideHandle, Side> = {
	p3: { name: "right", view: "front", sign: 1, opposite: "p4", lock: "leftRight" },
	p4: { name: "left", view: "front", sign: -1, opposite: "p3", lock: "leftRight" },
	p5: { name: "front", view: "side", sign: 1, opposite: "p6", lock: "frontBack" },
	p6: { name: "back", view: "side", sign: -1, opposite: "p5", lock: "frontBack" },
};

export const SIDE_HANDLES = ["p3", "p4", "p5", "p6"] as const;
export const HANDLES = ["p2", ...SIDE_HANDLES] as const;

/** The two side handles of a view, the one at the right first. */
export const VIEW_SIDES: Record<View, readonly [SideHandle, SideHandle]> = { front: ["p3", "p4"], side: ["p5", "p6"] };

/** Width and height of the paper's view, in pixels. */
export const VIEW_PIXELS = 600;

/** Units of the paper per pixel: a rachis segment is 50 units long and C_l = 29 pixels of the profile. */
export const UNITS_PER_PIXEL = 50 / 29;

/** Returns metres per pixel of the profile; `unit` is the specimen's scale in millimetres per unit of the paper. */
export function metresPerPixel(unit: number): number {
	return (UNITS_PER_PIXEL * unit) / 1000;
}

/** Returns whether a handle is one of the four side handles. */
export function isSide(handle: Handle): handle is SideHandle {
	return handle !== "p2";
}

/** Returns the parameters that a handle sets. */
export function handleKeys(handle: Handle): ShapeKey[] {
	return isSide(handle) ? [`${handle}w`, `${handle}r`] : ["l"];
}

/** Returns a handle's position in its view. */
export function handlePosition(shape: BunchShape, handle: Handle): Point {
	if (!isSide(handle)) return { x: 0, y: shape.l };
	// −0 is 0
	return { x: SIDES[handle].sign * shape[`${handle}w`] + 0, y: shape[`${handle}r`] };
}

/** A profile with the millimetres of its unit. */
export type ScaledShape = BunchShape & Record<"unit", number>;

/** Returns a handle's label: "p3, right: 64.7 mm wide, 64.7 mm below the top". */
export function handleLabel(shape: ScaledShape, handle: Handle): string {
	const value = handleValue(shape, handle);
	return isSide(handle)
		? text("handle_side", { handle, side: SIDES[handle].name, value })
		: text("handle_length", { handle, value });
}

/** Returns a handle's numbers in words: "64.7 mm wide, 64.7 mm below the top". */
export function handleValue(shape: ScaledShape, handle: Handle): string {
	return isSide(handle)
		? text("handle_width_and_drop", {
				width: inMillimetres(shape, `${handle}w`),
				drop: inMillimetres(shape, `${handle}r`),
			})
		: `${formatNumber(inMillimetres(shape, "l"))} mm`;
}

/** Returns a length of the profile in millimetres, to a tenth. */
export function inMillimetres(shape: ScaledShape, key: ShapeKey): number {
	return Math.round(shape[key] * metresPerPixel(shape.unit) * 10_000) / 10;
}
