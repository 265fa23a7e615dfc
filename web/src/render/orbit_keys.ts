import { text } from "./messages.generated";
import type { Viewer } from "./viewer";

const ORBIT_STEP = 0.12;
const PAN_STEP = 0.05;
const ZOOM_STEP = 1.15;

/** Returns the help on the keys of the focused view, for screen readers. */
export const orbitKeys = (): string => text("orbit_keys");

/**
 * Turns the view by the arrow keys, moves it by Shift and the arrow keys, and zooms it by + − 0.
 * @returns whether the key was one of these; false with Ctrl, Alt or Meta
 */
export function turnedBy(
	view: Pick<Viewer<never, never>, "orbit" | "pan" | "zoom" | "resetView">,
	{ key, shiftKey, ctrlKey, metaKey, altKey }: KeyboardEvent,
): boolean {
	if (ctrlKey || metaKey || altKey) return false;
	const arrow = ARROWS[key];
	if (arrow && shiftKey) view.pan(arrow[0] * PAN_STEP, arrow[1] * PAN_STEP);
	else if (arrow) view.orbit(arrow[0] * ORBIT_STEP, arrow[1] * ORBIT_STEP);
	else if (key === "+" || key === "=") view.zoom(ZOOM_STEP);
	else if (key === "-" || key === "−") view.zoom(1 / ZOOM_STEP);
	else if (key === "0") view.resetView();
	else return false;
	return true;
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
	ArrowLeft: [-1, 0],
	ArrowRight: [1, 0],
	ArrowUp: [0, -1],
	ArrowDown: [0, 1],
};
