/**
 * Plays a life from the current age to its end. Each frame requests the age of its own moment, and the client answers
 * only the newest request, so that requests do not queue.
 */
import type { Specimen } from "../specimen/specimen";
import type { EditorContext, Stateful } from "./editor_context";
import { type Life, nextStage } from "./life";

/** Duration of a stage with reduced motion, milliseconds. */
const STAGE_DURATION = 1500;
/** Longest time step, milliseconds: after a hidden or busy page, playing continues where it was. */
const LONGEST_FRAME = 500;
/**
 * Ages are rounded to this many steps of a life, and to no more steps per unit than a link stores, so that links stay
 * short.
 */
const STEPS_OF_LIFE = 1000;
const MOST_STEPS_PER_UNIT = 100;
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
	#lastFrameTime = 0;
	/** Specimen of the last frame; any other specimen means that the user has changed a control. */
	#lastFrameSpecimen: Specimen | undefined;

	/** @param state tool state with `playing`; setting it starts and stops the player */
	constructor(context: EditorContext, life: Life, state: Stateful<PlayState>, clock: Clock = FRAMES) {
		this.#context = context;
		this.#life = life;
		this.#state = state;
		this.#clock = clock;
		this.#unsubscribe = context.subscribe(() => this.#startOrStop());
	}

	/** Stops playing at the current age and unsubscribes. */
	dispose(): void {
		this.#unsubscribe();
		this.#stop();
	}

	/**
	 * Starts or stops after the tool state. At the end of the life, and at the age at which a plant is at its best,
	 * playing starts from the first stage, so that it shows the whole life and not only the decline.
	 */
	#startOrStop(): void {
		const { playing } = this.#context.toolState(this.#state);
		if (playing === this.#running) return;
		if (!playing) {
			this.#stop();
			return;
		}
		const age = this.#context.state.specimen.parameters[this.#life.parameter];
		this.#running = true;
		this.#lastFrameSpecimen = undefined;
		const { end, bestAge, stages } = this.#life;
		this.#age = age >= end || age === bestAge ? stages[0].at : age;
		this.#lastFrameTime = Number.NaN;
		this.#requestFrame();
	}

	/** Schedules a frame, unless one is due. */
	#requestFrame(): void {
		if (this.#isFrameDue) return;
		this.#isFrameDue = true;
		this.#clock.request(this.#frame);
	}

	/** Stops playing, and makes one undo step of the whole run. */
	#stop(): void {
		if (!this.#running) return;
		this.#running = false;
		const state = this.#context.toolState(this.#state);
		if (state.playing) this.#context.setToolState(this.#state, { ...state, playing: false });
		this.#context.settle(PLAY);
	}

	/** Sets the age of this frame; stops at the end, or if the specimen was edited since the last frame. */
	readonly #frame = (now: number): void => {
		this.#isFrameDue = false;
		if (!this.#running) return;
		const context = this.#context;
		if (this.#lastFrameSpecimen && context.state.specimen !== this.#lastFrameSpecimen) {
			this.#stop();
			return;
		}
		if (this.#advance(now)) {
			const stepsPerUnit = Math.min(MOST_STEPS_PER_UNIT, STEPS_OF_LIFE / this.#lifeSpan);
			const age = Math.round(this.#age * stepsPerUnit) / stepsPerUnit;
			context.edit({ parameters: { [this.#life.parameter]: age } }, PLAY);
			this.#lastFrameSpecimen = context.state.specimen;
		}
		if (this.#age >= this.#life.end) this.#stop();
		else this.#requestFrame();
	};

	/** From the first stage to the end, in units of the parameter. */
	get #lifeSpan(): number {
		return this.#life.end - this.#life.stages[0].at;
	}

	/**
	 * Advances the age to a moment.
	 * @returns whether the age changed
	 */
	#advance(now: number): boolean {
		const first = Number.isNaN(this.#lastFrameTime);
		const passed = first ? 0 : now - this.#lastFrameTime;
		const { end, milliseconds } = this.#life;
		const { speed = 1 } = this.#context.toolState(this.#state);
		if (this.#clock.stepwise()) {
			if (!first && passed < STAGE_DURATION / speed) return false;
			if (!first) this.#age = nextStage(this.#life, this.#age, 1).at;
		} else {
			const share = (Math.min(passed, LONGEST_FRAME) * speed) / milliseconds;
			this.#age = Math.min(end, this.#age + share * this.#lifeSpan);
		}
		this.#lastFrameTime = now;
		return true;
	}
}

const FRAMES: Clock = {
	request: (callback) => requestAnimationFrame(callback),
	stepwise: () => matchMedia("(prefers-reduced-motion: reduce)").matches,
};
