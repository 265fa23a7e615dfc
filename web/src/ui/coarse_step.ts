/** Steps of arrow keys on sliders: one of the slider's own steps, ten with Shift. */

const STEPS = 10;
const WAYS: Readonly<Record<string, number>> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };

/**
 * Returns the amount that a key adds to a slider's value; undefined if the browser handles the key.
 * @param step of the slider
 */
export function coarseStep(
	step: number,
	{ key, shiftKey }: Pick<KeyboardEvent, "key" | "shiftKey">,
): number | undefined {
	return shiftKey && key in WAYS ? WAYS[key] * STEPS * step : undefined;
}
