const MOVING_KEYS = /^(Arrow|Page|Home|End)/;

/** A slider's run of a held key, told from its drags: a run is one step, which ends when the key comes up. */
export class HeldKey {
	#held = false;
	readonly #settle: () => void;

	/** @param settle called at the end of a run, and of a drag */
	constructor(settle: () => void) {
		this.#settle = settle;
	}

	/** A key went down. */
	down({ key }: KeyboardEvent): void {
		if (MOVING_KEYS.test(key)) this.#held = true;
	}

	/** The key came up, or the focus went. */
	readonly up = (): void => {
		if (this.#held) this.#settle();
		this.#held = false;
	};

	/** The slider says that it has changed: by a drag, if by no key. */
	readonly slid = (): void => {
		if (!this.#held) this.#settle();
	};
}
