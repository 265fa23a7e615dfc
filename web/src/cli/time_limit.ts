/** The time limit of a call, `--seconds N`: a growth that reaches it ends with the plant so far. */
import { CoreError } from "../core/errors";
import { MessageError } from "../locale/message_error";
import { text } from "./messages.generated";

/** The share of the time limit for growing: the rest is for meshes and for writing the file. */
const GROWING = 0.75;

/** The time was over before there was anything to write. Ends the command with the status of a time limit. */
export class TimeOverError extends MessageError {
	override name = "TimeOverError";
}

export class TimeLimit {
	readonly #milliseconds: number;
	readonly #begun: number;

	/**
	 * Starts the limit.
	 * @param seconds undefined: no limit
	 * @param elapsed milliseconds of a monotonic clock
	 */
	constructor(
		readonly seconds: number | undefined,
		readonly elapsed: () => number,
	) {
		this.#milliseconds = seconds === undefined ? Number.POSITIVE_INFINITY : 1000 * GROWING * seconds;
		this.#begun = elapsed();
	}

	/** The elapsed share of the time for growing; 0 without a limit. */
	readonly passed = (): number => (this.elapsed() - this.#begun) / this.#milliseconds;

	/** Whether the time for growing is over. */
	readonly isOver = (): boolean => this.passed() >= 1;

	/** The option as users type it. */
	get option(): string {
		return `--seconds ${this.seconds}`;
	}

	/**
	 * Waits for a growth that is useless if cut short.
	 * @throws TimeOverError where the time limit cut it short, or it began after the limit
	 */
	async whole<Plant extends { cutShort?: "limit" | "time" }>(grow: () => Promise<Plant>): Promise<Plant> {
		if (this.isOver()) throw this.#timeOverError();
		const plant = await this.orNothing(grow());
		if (plant.cutShort === "time") throw this.#timeOverError();
		return plant;
	}

	/**
	 * Waits for a growth; a plant that the time limit cut short is a result, too.
	 * @throws TimeOverError where the time limit ended it without a plant
	 */
	async orNothing<Plant>(growing: Promise<Plant>): Promise<Plant> {
		try {
			return await growing;
		} catch (error) {
			if (error instanceof CoreError && error.reason === "limit" && this.isOver()) throw this.#timeOverError();
			throw error;
		}
	}

	/** Returns the error of a time limit that was reached before there was anything to write. */
	#timeOverError(): TimeOverError {
		const { code, args, text: problem } = text.message("time_over");
		return new TimeOverError({ code, args, text: text("at_option", { option: this.option, problem }) });
	}
}
