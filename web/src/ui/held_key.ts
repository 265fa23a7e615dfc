import { KeyRuns } from "./key_runs";

const MOVING_KEYS = /^(Arrow|Page|Home|End)/;

/**
 * Distinguishes a slider's keys from its drags: a press ends when the key is released, and consecutive presses are one
 * undo step.
 */
export class HeldKey {
	#held = false;
	#run = "";
	readonly #runs = new KeyRuns();
	readonly #settle: () => void;

	/** @param settle called at the end of a run, and of a drag */
	constructor(settle: () => void) {
		this.#settle = settle;
	}

	/** A key went down. */
	down({ key }: KeyboardEvent): void {
		if (!MOVING_KEYS.test(key)) return;
		this.#held = true;
		// Arrow keys in both directions form one run; other keys begin a run each.
		this.#run = this.#runs.press(key.startsWith("Arrow") ? "arrows" : key);
	}

	/** The run that a change belongs to; undefined where it is a drag's. */
	get run(): string | undefined {
		return this.#held ? this.#run : undefined;
	}

	/** The key came up, or the focus went. */
	readonly up = (): void => {
		if (this.#held) this.#settle();
		this.#held = false;
	};

	/** The slider's `change` event: ends a drag, if no key is held. */
	readonly slid = (): void => {
		if (!this.#held) this.#settle();
	};
}
