/** The time limit of a call, `--seconds N`: a growth that reaches it ends with what has grown so far. */
import { CoreError } from "../core/errors";

/** Of the time limit, the share for growing: the rest is for meshes and for writing the file. */
const GROWING = 0.75;

/** The time was over before anything was there to write. Ends the command with the status of a time limit. */
export class TimeOverError extends Error {
	override name = "TimeOverError";
}

export class TimeLimit {
	readonly #milliseconds: number;
	readonly #begun: number;

	/**
	 * Begins now.
	 * @param seconds undefined: no limit
	 * @param elapsed milliseconds from any moment on
	 */
	constructor(
		readonly seconds: number | undefined,
		readonly elapsed: () => number,
	) {
		this.#milliseconds = seconds === undefined ? Number.POSITIVE_INFINITY : 1000 * GROWING * seconds;
		this.#begun = elapsed();
	}

	/** The share of the time for growing that has passed; 0 where there is no limit. */
	readonly passed = (): number => (this.elapsed() - this.#begun) / this.#milliseconds;

	readonly isOver = (): boolean => this.passed() >= 1;

	/** The time limit as it is typed. */
	get option(): string {
		return `--seconds ${this.seconds}`;
	}

	/**
	 * Waits for a growth of which a part is of no use.
	 * @throws TimeOverError where it was cut short by the time limit, or began after its end
	 */
	async whole<Plant extends { cutShort?: "limit" | "time" }>(grow: () => Promise<Plant>): Promise<Plant> {
		if (this.isOver()) throw this.#nothing();
		const plant = await this.orNothing(grow());
		if (plant.cutShort === "time") throw this.#nothing();
		return plant;
	}

	/**
	 * Waits for a growth.
	 * @throws TimeOverError where the time limit ended it with nothing to show
	 */
	async orNothing<Plant>(growing: Promise<Plant>): Promise<Plant> {
		try {
			return await growing;
		} catch (error) {
			if (error instanceof CoreError && error.reason === "limit" && this.isOver()) throw this.#nothing();
			throw error;
		}
	}

	#nothing(): TimeOverError {
		return new TimeOverError(
			`${this.option}: the time limit was reached before there was anything to write; give it more seconds, or make the plant smaller`,
		);
	}
}
