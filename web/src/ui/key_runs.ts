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
	 * Returns the name of a press's run.
	 * @param of the moved object: another object begins a new run
	 */
	press(of: string, now = performance.now()): string {
		if (of !== this.#of || now - this.#last > PAUSE) this.#name = `keys ${++made}`;
		this.#of = of;
		this.#last = now;
		return this.#name;
	}
}
