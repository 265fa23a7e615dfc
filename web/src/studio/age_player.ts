/**
 * Lets the age run from where it stands to ripe. A frame asks for the age of its own moment, and the client answers the
 * newest question only, so that nothing queues however long a growth takes.
 */
import type { Specimen } from "../specimen/specimen";
import { nextStage, RIPE } from "./age";
import { PLAY, type Studio } from "./studio";

/** From the first flowers to ripe, in milliseconds. */
const WHOLE_LIFE = 9000;
/** How long each stage stands where motion is unwelcome, in milliseconds. */
const STAND = 1500;
/** A page that was hidden or busy goes on where it was, not where it would be; milliseconds. */
const LONGEST_FRAME = 500;
/** Ages are told to this part of a percent, so that a link stays short. */
const STEPS_PER_PERCENT = 10;

export interface Clock {
	/** Calls back once, with the time in milliseconds, when the next frame is due. */
	request(callback: (now: number) => void): void;
	/** Whether motion is unwelcome: the age then goes from stage to stage. */
	stepwise(): boolean;
}

export class AgePlayer {
	#running = false;
	#age = 0;
	#last = 0;
	/** What the last frame made; anything else on the controls means that a hand has taken over. */
	#made: Specimen | undefined;

	constructor(
		private readonly studio: Studio,
		private readonly clock: Clock = FRAMES,
	) {
		studio.subscribe(() => this.#follow());
	}

	#follow(): void {
		const { playing, specimen } = this.studio.state;
		if (playing === this.#running) return;
		this.#running = playing;
		if (!playing) return;
		const { age } = specimen.parameters;
		this.#made = undefined;
		this.#age = age >= RIPE ? 0 : age;
		this.#last = Number.NaN;
		this.clock.request(this.#frame);
	}

	readonly #frame = (now: number): void => {
		if (!this.#running) return;
		const { studio } = this;
		if (this.#made && studio.state.specimen !== this.#made) {
			studio.setPlaying(false);
			return;
		}
		if (this.#advance(now)) {
			const age = Math.round(this.#age * STEPS_PER_PERCENT) / STEPS_PER_PERCENT;
			studio.edit({ parameters: { age } }, PLAY);
			this.#made = studio.state.specimen;
		}
		if (this.#age >= RIPE) studio.setPlaying(false);
		else this.clock.request(this.#frame);
	};

	/** Moves the age on to a moment; tells whether it has moved. */
	#advance(now: number): boolean {
		const first = Number.isNaN(this.#last);
		const passed = first ? 0 : now - this.#last;
		if (this.clock.stepwise()) {
			if (!first && passed < STAND) return false;
			if (!first) this.#age = nextStage(this.#age, 1).at;
		} else {
			this.#age = Math.min(RIPE, this.#age + (Math.min(passed, LONGEST_FRAME) / WHOLE_LIFE) * RIPE);
		}
		this.#last = now;
		return true;
	}
}

const FRAMES: Clock = {
	request: (callback) => requestAnimationFrame(callback),
	stepwise: () => matchMedia("(prefers-reduced-motion: reduce)").matches,
};
