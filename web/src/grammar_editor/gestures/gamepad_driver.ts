import { text } from "../messages.generated";
import type { Driver, DriverEvents } from "./driver";

/**
 * Speed at full tilt, as a share of the range per second; and dead zone of an untouched stick, as a share of its
 * travel.
 */
const [SPEED, SLACK] = [0.6, 0.15];
/** Buttons of the standard mapping: the lowest of the right four, and the directional pad. */
const [NEXT, UP, DOWN, LEFT, RIGHT] = [0, 12, 13, 14, 15];

/** Used part of a gamepad's state. */
export interface Pad {
	readonly axes: readonly number[];
	readonly buttons: readonly { readonly pressed: boolean }[];
}

/** Returns the direction of a gamepad, from its left stick and its directional pad: to the right and down, −1 … 1. */
export function pushOf({ axes, buttons }: Pad): { readonly x: number; readonly y: number } {
	const pressed = (button: number) => Number(buttons[button]?.pressed ?? false);
	const stick = (value = 0) => (Math.abs(value) < SLACK ? 0 : (value - Math.sign(value) * SLACK) / (1 - SLACK));
	const clamped = (value: number) => Math.min(Math.max(value, -1), 1);
	return {
		x: clamped(stick(axes[0]) + pressed(RIGHT) - pressed(LEFT)),
		y: clamped(stick(axes[1]) + pressed(DOWN) - pressed(UP)),
	};
}

/** Returns the first connected gamepad; undefined if there is none, or gamepads are not allowed. */
function firstPad(): Pad | undefined {
	// Pages without HTTPS have no gamepads, and frames may lack the permission.
	const { getGamepads } = navigator as { readonly getGamepads?: Navigator["getGamepads"] };
	try {
		return getGamepads?.call(navigator).find((each) => each !== null) ?? undefined;
	} catch {
		return undefined;
	}
}

/** A gamepad's left stick or directional pad moves the circle; its first button selects the next pair. */
export class GamepadDriver implements Driver {
	readonly #events: DriverEvents;
	#frame = 0;
	#before = 0;
	#pushed = false;
	#pressed = false;
	#connected: boolean | undefined;

	constructor(events: DriverEvents) {
		this.#events = events;
		this.#frame = requestAnimationFrame((now) => this.#readPad(now));
	}

	/** Ends reading the gamepad. */
	stop(): void {
		cancelAnimationFrame(this.#frame);
	}

	/**
	 * Reads the first gamepad in every frame. After a pause, such as in a hidden tab, at most 0.1 s of movement is
	 * applied.
	 * @param now time of the frame, ms
	 */
	#readPad(now: number): void {
		this.#frame = requestAnimationFrame((next) => this.#readPad(next));
		const pad = firstPad();
		const seconds = Math.min((now - this.#before) / 1000, 0.1);
		this.#before = now;
		if ((pad !== undefined) !== this.#connected) {
			this.#connected = pad !== undefined;
			this.#events.report(text(pad ? "gamepad_ready" : "gamepad_missing"));
		}
		if (pad) this.#handleInput(pad, seconds);
	}

	/**
	 * Moves the circle by the stick, whose tilt sets the speed, and reports when it comes to rest; a button selects the
	 * next pair.
	 */
	#handleInput(pad: Pad, seconds: number): void {
		const { x, y } = pushOf(pad);
		const next = pad.buttons[NEXT]?.pressed ?? false;
		if (next && !this.#pressed) this.#events.next();
		this.#pressed = next;
		if (x !== 0 || y !== 0) {
			const { x: left, y: top } = this.#events.where();
			const shifted = (at: number, by: number) => Math.min(Math.max(at + by * SPEED * seconds, 0), 1);
			this.#events.move({ x: shifted(left, x), y: shifted(top, y) });
		} else if (this.#pushed) this.#events.rest();
		this.#pushed = x !== 0 || y !== 0;
	}
}
