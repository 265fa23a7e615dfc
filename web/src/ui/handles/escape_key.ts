/** Handles Escape during a drag before the rest of the page, independent of the focus. */
export class EscapeKey {
	readonly #pressed: () => void;

	constructor(pressed: () => void) {
		this.#pressed = pressed;
	}

	/** Begins or ends to listen for the key. */
	listen(on: boolean): void {
		if (on) window.addEventListener("keydown", this.#onKey, { capture: true });
		else window.removeEventListener("keydown", this.#onKey, { capture: true });
	}

	/** Handles Escape, which nothing else on the page then gets. */
	readonly #onKey = (event: KeyboardEvent): void => {
		if (event.key !== "Escape") return;
		event.preventDefault();
		event.stopPropagation();
		this.#pressed();
	};
}
