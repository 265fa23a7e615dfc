/** Largest pixel ratio: finer pixels are not visible to the naked eye. */
const MAX_RATIO = 2;
const LEAST = 0.5;
/** Frame times in ms: slower frames are felt as lag, faster ones leave time for finer pixels. */
const SLOW = 42;
const FAST = 20;

/**
 * Pixels per CSS pixel during movements: coarser if frames are slow, finer again if they are fast. At rest the picture
 * has the device's own ratio.
 */
export class PixelRatio {
	readonly rest: number;
	#moving: number;
	#smoothed = 0;
	#frames = 0;

	/**
	 * @param device `devicePixelRatio`
	 * @param slow whether frames are known to come slowly, before any has been timed
	 */
	constructor(device: number, slow = false) {
		this.rest = Math.min(Math.max(device, 1), MAX_RATIO);
		this.#moving = slow ? LEAST : this.rest;
	}

	/** Pixels per CSS pixel of a picture in movement. */
	get moving(): number {
		return this.#moving;
	}

	/** Records the time between two frames of one movement, milliseconds. */
	note(milliseconds: number): void {
		this.#smoothed = this.#frames === 0 ? milliseconds : this.#smoothed + 0.4 * (milliseconds - this.#smoothed);
		this.#frames++;
		if (this.#frames < 3) return;
		if (this.#smoothed > SLOW) this.#change(Math.max(0.6, Math.sqrt(SLOW / (1.3 * this.#smoothed))));
		else if (this.#smoothed < FAST && this.#moving < this.rest && this.#frames > 20) this.#change(1.15);
	}

	/**
	 * Multiplies the ratio of movements by a factor, rounded to steps of 1/8: downwards if it shrinks, upwards if it
	 * grows.
	 */
	#change(factor: number): void {
		// Steps of 1/8 need fewer reallocations of the drawing buffer.
		const wanted = Math.min(this.rest, Math.max(LEAST, this.#moving * factor));
		this.#moving =
			factor < 1 ? Math.max(LEAST, Math.floor(wanted * 8) / 8) : Math.min(this.rest, Math.ceil(wanted * 8) / 8);
		this.#frames = 0;
	}
}
