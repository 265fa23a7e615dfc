/** Presses that follow each other within this many milliseconds are one run. */
const PAUSE = 1000;

/** How many runs there have been on the page, so that each has a name of its own. */
let made = 0;

/** Tells runs of key presses apart: one step for the undo list each, though every press is seen at once. */
export class KeyRuns {
	#name = "";
	#of: string | undefined;
	#last = Number.NEGATIVE_INFINITY;

	/** The name of the run that a press belongs to. @param of what is moved: another begins a run */
	press(of: string, now = performance.now()): string {
		if (of !== this.#of || now - this.#last > PAUSE) this.#name = `keys ${++made}`;
		this.#of = of;
		this.#last = now;
		return this.#name;
	}
}
