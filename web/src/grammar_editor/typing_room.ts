/**
 * Follows the on-screen keyboard of a phone, which covers the page without resizing it. While it is open, the root has
 * an attribute and two style properties with the visible part (style/pane.css).
 */

/** Least covered height that counts as a keyboard, CSS pixels: the browser's bars cover less. */
const KEYBOARD = 120;
/** A zoomed page shows less without any keyboard. */
const UNZOOMED = 1.05;

export class TypingRoom {
	readonly #changed: () => void;
	readonly #ended = new AbortController();

	/**
	 * Begins to follow the keyboard.
	 * @param changed called when the visible part changes
	 */
	constructor(changed: () => void) {
		this.#changed = changed;
		const { signal } = this.#ended;
		for (const kind of ["resize", "scroll"]) window.visualViewport?.addEventListener(kind, this.#measure, { signal });
		this.#measure();
	}

	/** Stops following the keyboard, and removes the attribute from the page. */
	end(): void {
		this.#ended.abort();
		document.documentElement.removeAttribute("data-keyboard");
	}

	/**
	 * Compares the visible part with the window: a much lower visible part without zoom means that the keyboard is open.
	 */
	readonly #measure = (): void => {
		const { visualViewport: seen, innerHeight } = window;
		const root = document.documentElement;
		const before = root.hasAttribute("data-keyboard");
		const now = seen !== null && seen.scale < UNZOOMED && innerHeight - seen.height > KEYBOARD;
		root.toggleAttribute("data-keyboard", now);
		if (now) {
			root.style.setProperty("--seen-height", `${seen.height}px`);
			root.style.setProperty("--seen-from", `${seen.offsetTop}px`);
		}
		if (now || before) this.#changed();
	};
}
