/**
 * Plays a life from the current age to its end. Each frame requests the age of its own moment, and the client answers
 * only the newest request, so that requests do not queue.
 */
import type { Specimen } from "../specimen/specimen";
import type { EditorContext, Stateful } from "./editor_context";
import { type Life, nextStage } from "./life";

/** Duration of a stage with reduced motion, milliseconds. */
const STAND = 1500;
/** Longest time step, milliseconds: after a hidden or busy page, playing continues where it was. */
const LONGEST_FRAME = 500;
/** Ages are rounded to this share of a life, and to no more decimals than a link stores, so that links stay short. */
const SHARES = 1000;
const FINEST = 100;
/** Gesture name of playing; a drag meanwhile is an undo step of its own. */
export const PLAY = "play";

export interface Clock {
	/** Schedules a callback, with the time in milliseconds, for the next frame. */
	request(callback: (now: number) => void): void;
	/** Whether motion is reduced: the age then moves from stage to stage. */
	stepwise(): boolean;
}

export interface PlayState {
	readonly playing: boolean;
	/** Speed relative to the life's own; 1 if absent. */
	readonly speed?: number;
}

export class LifePlayer {
	readonly #context: EditorContext;
	readonly #life: Life;
	readonly #state: Stateful<PlayState>;
	readonly #clock: Clock;
	readonly #unsubscribe: () => void;
	#running = false;
	/** Whether a frame is scheduled: one scheduled before a stop is reused by the next start. */
	#isFrameDue = false;
	#age = 0;
	#last = 0;
	/** Specimen of the last frame; any other specimen means that the user has changed a control. */
	#made: Specimen | undefined;

	/** @param state tool state with `playing`; setting it starts and stops the player */
	constructor(context: EditorContext, life: Life, state: Stateful<PlayState>, clock: Clock = FRAMES) {
		this.#context = context;
		this.#life = life;
		this.#state = state;
		this.#clock = clock;
		this.#unsubscribe = context.subscribe(() => this.#follow());
	}

	/** Stops playing at the current age and unsubscribes. */
	dispose(): void {
		this.#unsubscribe();
		this.#stop();
	}

	#follow(): void {
		const { playing } = this.#context.toolState(this.#state);
		if (playing === this.#running) return;
		if (!playing) {
			this.#stop();
			return;
		}
		const age = this.#context.state.specimen.parameters[this.#life.parameter];
		this.#running = true;
		this.#made = undefined;
		const { end, height, stages } = this.#life;
		this.#age = age >= end || age === height ? stages[0].at : age;
		this.#last = Number.NaN;
		this.#requestFrame();
	}

	#requestFrame(): void {
		if (this.#isFrameDue) return;
		this.#isFrameDue = true;
		this.#clock.request(this.#frame);
	}

	/** Makes one undo step of the whole run. */
	#stop(): void {
		if (!this.#running) return;
		this.#running = false;
		const state = this.#context.toolState(this.#state);
		if (state.playing) this.#context.setToolState(this.#state, { ...state, playing: false });
		this.#context.settle(PLAY);
	}

	readonly #frame = (now: number): void => {
		this.#isFrameDue = false;
		if (!this.#running) return;
		const context = this.#context;
		if (this.#made && context.state.specimen !== this.#made) {
			this.#stop();
			return;
		}
		if (this.#advance(now)) {
			const fine = Math.min(FINEST, SHARES / this.#whole);
			const age = Math.round(this.#age * fine) / fine;
			context.edit({ parameters: { [this.#life.parameter]: age } }, PLAY);
			this.#made = context.state.specimen;
		}
		if (this.#age >= this.#life.end) this.#stop();
		else this.#requestFrame();
	};

	get #whole(): number {
		return this.#life.end - this.#life.stages[0].at;
	}

	/**
	 * Advances the age to a moment.
	 * @returns whether the age changed
	 */
	#advance(now: number): boolean {
		const first = Number.isNaN(this.#last);
		const passed = first ? 0 : now - this.#last;
		const { end, milliseconds } = this.#life;
		const { speed = 1 } = this.#context.toolState(this.#state);
		if (this.#clock.stepwise()) {
			if (!first && passed < STAND / speed) return false;
			if (!first) this.#age = nextStage(this.#life, this.#age, 1).at;
		} else {
			const share = (Math.min(passed, LONGEST_FRAME) * speed) / milliseconds;
			this.#age = Math.min(end, this.#age + share * this.#whole);
		}
		this.#last = now;
		return true;
	}
}

const FRAMES: Clock = {
	request: (callback) => requestAnimationFrame(callback),
	stepwise: () => matchMedia("(prefers-reduced-motion: reduce)").matches,
};
