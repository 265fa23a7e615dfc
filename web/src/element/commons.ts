/**
 * The resources that all plants of a page share: workers with cores, and one WebGL context, of which browsers allow about sixteen. They
 * are created on first use, and released some time after the last plant has left the page.
 */
import { Client } from "../core/client";
import { holdScripts } from "../core/hold_scripts";
import { compileCore } from "../core/loader";
import { Pool } from "../core/pool";
import { spawnWorker } from "../core/spawn";
import { loadScene } from "../models/renderers";
import type { Renderer } from "../render/renderer";

/** Delay of the release, so that a page may replace its only plant; milliseconds. */
const LINGER = 1000;

export interface CommonsOptions {
	pool?: () => Pool;
	renderer?: () => Promise<Renderer>;
	/** Retains the element's scripts after an update of the app. */
	hold?: () => void;
}

export class Commons {
	readonly #options: Required<CommonsOptions>;
	#held = false;
	#users = 0;
	#pool: Pool | undefined;
	#renderer: Promise<Renderer> | undefined;
	#leaving: ReturnType<typeof setTimeout> | undefined;

	constructor({ pool = ownPool, renderer = ownRenderer, hold = holdOwn }: CommonsOptions = {}) {
		this.#options = { pool, renderer, hold };
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

	/** A new client for one element; the caller closes it. */
	client(): Client {
		this.#pool ??= this.#options.pool();
		return new Client({ pool: this.#pool });
	}

	/** The renderer of all plants. Rejects with NoWebGL2Error or errors of loading the script; the next call tries again. */
	renderer(): Promise<Renderer> {
		if (this.#renderer) return this.#renderer;
		const renderer = this.#options.renderer();
		this.#renderer = renderer;
		renderer.catch(() => {
			if (this.#renderer === renderer) this.#renderer = undefined;
		});
		return renderer;
	}

	#close(): void {
		this.#pool?.close();
		this.#pool = undefined;
		this.#renderer?.then((renderer) => renderer.dispose()).catch(() => {});
		this.#renderer = undefined;
	}
}

/** The page's shared resources. */
export const commons = new Commons();

function ownPool(): Pool {
	return new Pool({ spawn: spawnWorker, compile: compileCore, workers: Math.min(navigator.hardwareConcurrency, 2) });
}

/** Holds the element's scripts, which the service worker serves to pages in the app's folder and to `embed.html`. */
function holdOwn(): void {
	holdScripts(import.meta.url);
}

async function ownRenderer(): Promise<Renderer> {
	const [, { Renderer }] = await Promise.all([loadScene(), import("../render/renderer")]);
	return new Renderer();
}
