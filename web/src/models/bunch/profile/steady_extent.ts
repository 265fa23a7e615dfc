/**
 * Holds what a view shows still while the profile is on the move. A drag may come from the other view, a slider or the
 * 3-D handles: all this view sees is that changes follow each other closely. A change after a rest (a preset, an undo)
 * is followed at once.
 */
export class SteadyExtent {
	/** Pixels of the profile; 0 before the first. */
	extent = 0;
	#movedAt = Number.NEGATIVE_INFINITY;

	/**
	 * Takes the extent that would suit now, unless the profile has moved within the last moments.
	 * @param motion `held` while a handle of this view is in hand, `moved` when the profile changed since the last call.
	 * @param now Milliseconds on any clock.
	 * @returns Milliseconds after which to ask again, where the extent is behind.
	 */
	follow(wanted: number, motion: "held" | "moved" | "still", now: number): number | undefined {
		const resting = motion !== "held" && now - this.#movedAt >= REST;
		if (motion !== "still") this.#movedAt = now;
		if (resting || this.extent === 0) this.extent = wanted;
		return this.extent === wanted || motion === "held" ? undefined : REST;
	}

	/** The element's size is another: the next call is followed at once. */
	forget(): void {
		this.extent = 0;
	}
}

/** How long without a change counts as rest, in milliseconds. */
const REST = 300;
