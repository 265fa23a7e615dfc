/**
 * What a phone's keyboard leaves of the page. It covers the page and makes it no smaller, so the page is told (style/pane.css): an
 * attribute of the root while there is one, and how high and where the part is that can be seen.
 */

/** What is covered at the least, CSS pixels: bars of the browser come and go by less. */
const KEYBOARD = 120;
/** Who has zoomed in sees less of the page without any keyboard. */
const UNZOOMED = 1.05;

export class TypingRoom {
	readonly #changed: () => void;
	readonly #ended = new AbortController();

	/** Follows the keyboard from now on. @param changed called when there is another room */
	constructor(changed: () => void) {
		this.#changed = changed;
		const { signal } = this.#ended;
		for (const kind of ["resize", "scroll"]) window.visualViewport?.addEventListener(kind, this.#look, { signal });
		this.#look();
	}

	/** The page has all its room again. */
	end(): void {
		this.#ended.abort();
		document.documentElement.removeAttribute("data-keyboard");
	}

	readonly #look = (): void => {
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
