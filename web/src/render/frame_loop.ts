import { PixelRatio } from "./pixel_ratio";

/** Delay after the last movement until the picture is drawn at full resolution, ms. */
const SETTLE = 140;

export interface Frame {
	/** Pixels per CSS pixel to draw at. */
	ratio: number;
	/** Time stamp of the animation frame, ms. */
	now: number;
}

/**
 * Draws on demand, one frame per request. Frames are coarser while a movement is slow, and the last frame after a
 * movement has the full resolution.
 */
export class FrameLoop {
	#scheduled = 0;
	#settling: ReturnType<typeof setTimeout> | undefined;
	#previous = 0;
	#ratio: PixelRatio;
	#waiting: (() => void)[] = [];
	#moving = false;
	#stopped = false;

	/**
	 * @param draw draws one frame; true requests another one at once, because a movement continues
	 * @param device `devicePixelRatio`
	 * @param slow whether frames are known to be slow
	 */
	constructor(
		readonly draw: (frame: Frame) => boolean,
		device: number,
		readonly slow = false,
	) {
		this.#ratio = new PixelRatio(device, slow);
	}

	/** Sets `devicePixelRatio`, which changes with the screen. */
	setDevice(device: number): void {
		this.#ratio = new PixelRatio(device, this.slow);
	}

	/** Pixels per CSS pixel of a picture at rest. */
	get rest(): number {
		return this.#ratio.rest;
	}

	/**
	 * Requests a frame.
	 * @param moving the frame is part of a movement: it may be coarser, and a full frame follows the movement
	 */
	request(moving = false): void {
		if (this.#stopped) return;
		this.#moving ||= moving;
		if (this.#scheduled === 0) this.#scheduled = requestAnimationFrame((now) => this.#frame(now));
	}

	/** Resolves when nothing is left to draw. */
	whenIdle(): Promise<void> {
		if (this.#scheduled === 0 && this.#settling === undefined) return Promise.resolve();
		return new Promise((resolve) => this.#waiting.push(resolve));
	}

	/** Cancels all frames, now and later, and resolves all waiting `whenIdle`. */
	stop(): void {
		this.#stopped = true;
		cancelAnimationFrame(this.#scheduled);
		clearTimeout(this.#settling);
		this.#scheduled = 0;
		this.#settling = undefined;
		this.#wake();
	}

	/**
	 * Draws one frame. While objects move, the resolution follows the duration of frames; after the last movement,
	 * `#settle` requests a frame at full resolution.
	 * @param now time of the frame, ms
	 */
	#frame(now: number): void {
		this.#scheduled = 0;
		const moving = this.#moving;
		this.#moving = false;
		if (moving && this.#previous > 0) this.#ratio.note(now - this.#previous);
		this.#previous = moving ? now : 0;
		const goesOn = this.draw({ ratio: moving ? this.#ratio.moving : this.#ratio.rest, now });
		clearTimeout(this.#settling);
		this.#settling = undefined;
		if (goesOn) this.request(true);
		else if (moving) this.#settle();
		if (this.#scheduled === 0 && this.#settling === undefined) this.#wake();
	}

	/** Requests a frame at full resolution some time after the last movement, if the movement was drawn coarser. */
	#settle(): void {
		this.#settling = setTimeout(() => {
			this.#settling = undefined;
			this.#previous = 0;
			if (this.#ratio.moving < this.#ratio.rest) this.request();
			else if (this.#scheduled === 0) this.#wake();
		}, SETTLE);
	}

	/** Resolves all waiting `whenIdle`. */
	#wake(): void {
		const waiting = this.#waiting;
		this.#waiting = [];
		for (const resolve of waiting) resolve();
	}
}
