/** Handles Escape during a drag before the rest of the page, independent of the focus. */
export class EscapeKey {
	readonly #pressed: () => void;

	constructor(pressed: () => void) {
		this.#pressed = pressed;
	}

	listen(on: boolean): void {
		if (on) window.addEventListener("keydown", this.#heard, { capture: true });
		else window.removeEventListener("keydown", this.#heard, { capture: true });
	}

	readonly #heard = (event: KeyboardEvent): void => {
		if (event.key !== "Escape") return;
		event.preventDefault();
		event.stopPropagation();
		this.#pressed();
	};
}
