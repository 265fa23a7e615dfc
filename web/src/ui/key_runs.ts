/** Presses that follow each other within this many milliseconds are one run. */
const PAUSE = 1000;

/** Number of runs on the page, for unique names. */
let made = 0;

/** Groups key presses into runs. Each run is one undo step, though every press has an immediate effect. */
export class KeyRuns {
	#name = "";
	#of: string | undefined;
	#last = Number.NEGATIVE_INFINITY;

	/**
	 * Returns the name of a press's run: that of the last press, if it was of the same object and recent.
	 * @param object the moved one: another object begins a new run
	 * @param now time of the press, ms
	 */
	press(object: string, now = performance.now()): string {
		if (object !== this.#of || now - this.#last > PAUSE) this.#name = `keys ${++made}`;
		this.#of = object;
		this.#last = now;
		return this.#name;
	}
}
