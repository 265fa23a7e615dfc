/** Builds modules one after another, so that the first can be used while the others are still being built. */

/** @typedef {"building" | "ready" | "failed"} ModuleState */

export class CoreQueue {
	/** Models that wait, in the order in which they will be built. */
	#waiting;
	#build;
	#onState;
	/** @type {Map<string, { promise: Promise<boolean>, settle: (isBuilt: boolean) => void }>} */
	#ends = new Map();
	#ended = new Set();
	/** Models with a pending request. */
	#requested = new Set();

	/**
	 * @param {string[]} models in the order in which to build them
	 * @param {(model: string) => Promise<boolean>} build returns whether the module was built; must not throw
	 * @param {(model: string, state: ModuleState) => void} [onState] called for a model with a pending request
	 */
	constructor(models, build, onState = () => {}) {
		this.#waiting = [...models];
		this.#build = build;
		this.#onState = onState;
		for (const model of models) {
			let settle = (/** @type {boolean} */ _isBuilt) => {};
			const promise = new Promise((resolve) => {
				settle = resolve;
			});
			this.#ends.set(model, { promise, settle });
		}
	}

	/** Builds the waiting modules; resolves when none is left. */
	async run() {
		for (let model = this.#waiting.shift(); model !== undefined; model = this.#waiting.shift()) {
			const isBuilt = await this.#build(model);
			this.#ended.add(model);
			this.#ends.get(model)?.settle(isBuilt);
			if (this.#requested.delete(model)) this.#onState(model, isBuilt ? "ready" : "failed");
		}
	}

	/**
	 * Waits for a model's module, which is built next if it has not been started.
	 *
	 * @param {string} model
	 * @returns {Promise<boolean>} whether it was built; true for a model that was never in the queue
	 */
	async wait(model) {
		const end = this.#ends.get(model);
		if (!end) return true;
		const at = this.#waiting.indexOf(model);
		if (at > 0) this.#waiting.unshift(...this.#waiting.splice(at, 1));
		if (!this.#ended.has(model) && !this.#requested.has(model)) {
			this.#requested.add(model);
			this.#onState(model, "building");
		}
		return end.promise;
	}

	/** Models with a pending request now. */
	get requested() {
		return [...this.#requested];
	}
}
