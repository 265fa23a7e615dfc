/**
 * Keeps the extent of a view constant while the profile changes. A drag may come from the other view, a slider or the
 * 3-D handles: this view only sees that changes follow each other closely. A change after a pause (a preset, an undo)
 * is followed at once.
 */
export class SteadyExtent {
	/** Extent in pixels of the profile; 0 before the first. */
	extent = 0;
	#movedAt = Number.NEGATIVE_INFINITY;

	/**
	 * Sets the extent to `wanted`, unless the profile has moved recently.
	 * @param motion `held` while a handle of this view is held, `moved` when the profile changed since the last call.
	 * @param now Milliseconds on any clock.
	 * @returns Milliseconds after which to call again, if the extent is behind.
	 */
	follow(wanted: number, motion: "held" | "moved" | "still", now: number): number | undefined {
		const resting = motion !== "held" && now - this.#movedAt >= REST;
		if (motion !== "still") this.#movedAt = now;
		if (resting || this.extent === 0) this.extent = wanted;
		return this.extent === wanted || motion === "held" ? undefined : REST;
	}

	/** Resets the extent after a resize: the next call is followed at once. */
	forget(): void {
		this.extent = 0;
	}
}

/** Pause without changes that counts as rest, in milliseconds. */
const REST = 300;
