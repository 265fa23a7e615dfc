/**
 * The names a reader of an export sees in an outliner: the same in GLB and OBJ. Numbers start at 1, as people count,
 * and are padded so that sorting by name keeps their order.
 */
import type { Specimen } from "../specimen/specimen";

/** Node of the whole plant, e.g. `Bunch long-conical`. */
export function plantName(specimen: Specimen): string {
	const kind = specimen.model.charAt(0).toUpperCase() + specimen.model.slice(1);
	return `${kind} ${specimen.preset}`;
}

/** Name of a part of the stem: `Rachis` for −1, else `Axis 01` for s = 0 (the top one) and so on. */
export function stemName(axis: number): string {
	return axis < 0 ? "Rachis" : `Axis ${String(axis + 1).padStart(2, "0")}`;
}

/** Name of berry `index` (from 0) of `count`: `Berry 001`; more digits where there are more than 999. */
export function berryName(index: number, count: number): string {
	const digits = Math.max(3, String(count).length);
	return `Berry ${String(index + 1).padStart(digits, "0")}`;
}
