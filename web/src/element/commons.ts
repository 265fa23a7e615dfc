/**
 * The resources that all elements of a page share besides its workers (core/page_pool.ts): one WebGL context, of which
 * browsers allow about sixteen. It is created on first use, and released some time after the last element has left the
 * page.
 */
import { holdScripts } from "../core/hold_scripts";
import { loadScene } from "../models/renderers";
import type { Renderer } from "../render/renderer";

/** Delay of the release, so that a page may replace its only plant; milliseconds. */
const LINGER = 1000;

export interface CommonsOptions {
	renderer?: () => Promise<Renderer>;
	/** Retains the element's scripts after an update of the app. */
	hold?: () => void;
}

export class Commons {
	readonly #options: Required<CommonsOptions>;
	#held = false;
	#users = 0;
	#renderer: Promise<Renderer> | undefined;
	#leaving: ReturnType<typeof setTimeout> | undefined;

	constructor({ renderer = ownRenderer, hold = holdOwn }: CommonsOptions = {}) {
		this.#options = { renderer, hold };
	}

	/** Registers a plant. @returns a function that unregisters it, to be called once */
	enter(): () => void {
		if (!this.#held) this.#options.hold();
		this.#held = true;
		this.#users++;
		clearTimeout(this.#leaving);
		return () => {
			this.#users--;
			if (this.#users === 0) this.#leaving = setTimeout(() => this.#close(), LINGER);
		};
	}

	/**
	 * The renderer of all plants. Rejects with NoWebGL2Error or errors of loading the script; the next call tries again.
	 */
	renderer(): Promise<Renderer> {
		if (this.#renderer) return this.#renderer;
		const renderer = this.#options.renderer();
		this.#renderer = renderer;
		renderer.catch(() => {
			if (this.#renderer === renderer) this.#renderer = undefined;
		});
		return renderer;
	}

	/** Releases the renderer's context. */
	#close(): void {
		this.#renderer?.then((renderer) => renderer.dispose()).catch(() => {});
		this.#renderer = undefined;
	}
}

/** The page's shared resources. */
export const commons = new Commons();

/** Holds the element's scripts, which the service worker serves to pages in the app's folder and to `embed.html`. */
function holdOwn(): void {
	holdScripts(import.meta.url);
}

/**
 * Loads the scripts of the scene and makes a renderer.
 * @throws NoWebGL2Error
 */
async function ownRenderer(): Promise<Renderer> {
	const [, { Renderer }] = await Promise.all([loadScene(), import("../render/renderer")]);
	return new Renderer();
}
