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

	/** Handles a pressed key. */
	down({ key }: KeyboardEvent): void {
		if (!MOVING_KEYS.test(key)) return;
		this.#held = true;
		// Arrow keys in both directions form one run; other keys begin a run each.
		this.#run = this.#runs.press(key.startsWith("Arrow") ? "arrows" : key);
	}

	/** Run of the current change; undefined during a drag. */
	get run(): string | undefined {
		return this.#held ? this.#run : undefined;
	}

	/** Ends a press when the key is released or the focus lost. */
	readonly up = (): void => {
		if (this.#held) this.#settle();
		this.#held = false;
	};

	/** The slider's `change` event: ends a drag, if no key is held. */
	readonly slid = (): void => {
		if (!this.#held) this.#settle();
	};
}
