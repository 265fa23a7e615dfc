import type { Viewer } from "./viewer";

const ORBIT_STEP = 0.12;
const PAN_STEP = 0.05;
const ZOOM_STEP = 1.15;

/** Help on the keys of the focused view, for screen readers. */
export const ORBIT_KEYS =
	"Arrow keys orbit, with Shift they move; plus and minus go nearer and further, 0 resets the view.";

/**
 * Turns, moves and zooms the view by keys.
 * @returns whether the key was one of them
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
