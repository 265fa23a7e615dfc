/**
 * What all plants on a page share: workers that grow, each with its cores, and one context of the graphics card, of which browsers keep
 * only some sixteen. Made when first asked for; given up some time after the last plant has gone.
 */
import { Client } from "../core/client";
import { holdScripts } from "../core/hold_scripts";
import { compileCore } from "../core/loader";
import { Pool } from "../core/pool";
import { spawnWorker } from "../core/spawn";
import { loadScene } from "../models/renderers";
import type { Renderer } from "../render/renderer";

/** A page that puts one plant in another's place need not start anew. */
const LINGER = 1000;

export interface CommonsOptions {
	pool?: () => Pool;
	renderer?: () => Promise<Renderer>;
	/** Keeps the element's scripts available after an update of the app. */
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

	/** One plant more. @returns what is to be called once when it goes */
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

	/** What grows one document's plants; to be closed by whoever asked. */
	client(): Client {
		this.#pool ??= this.#options.pool();
		return new Client({ pool: this.#pool });
	}

	/** Draws all plants' pictures. @throws NoWebGL2Error, and what the loading of the script throws; asked again, it is tried again */
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

/** The page's. */
export const commons = new Commons();

function ownPool(): Pool {
	return new Pool({ spawn: spawnWorker, compile: compileCore, seats: Math.min(navigator.hardwareConcurrency, 2) });
}

/** Holds the element's scripts, which the service worker serves to pages in the app's folder and to `embed.html`. */
function holdOwn(): void {
	holdScripts(import.meta.url);
}

async function ownRenderer(): Promise<Renderer> {
	const [, { Renderer }] = await Promise.all([loadScene(), import("../render/renderer")]);
	return new Renderer();
}
