/** A build of the app in a cache of its own, until no page needs it. */
import { type Built, isNamedByContent } from "./built";

export interface CachedAppOptions {
	/** The app's folder, as a whole address that ends in a slash: several apps on one host have separate caches. */
	readonly scope: string;
	readonly built: Built;
	readonly caches: CacheStorage;
	readonly fetch: (url: string, init: RequestInit) => Promise<Response>;
}

/** The number of files that are fetched at once. */
const ABREAST = 6;
/** The number of times that a file is fetched before the app is left incomplete until the next visit. */
const TRIES = 3;
const PAGE = "";
/** These files do not depend on request headers, even where a host claims so. */
const MATCHING = { ignoreVary: true } as const;

export class CachedApp {
	readonly #options: CachedAppOptions;
	readonly #prefix: string;
	readonly #name: string;
	#filling: Promise<void> | undefined;

	constructor(options: CachedAppOptions) {
		this.#options = options;
		this.#prefix = `panicle ${options.scope} `;
		this.#name = this.#prefix + options.built.id;
	}

	/** Returns whether every file of this build is cached. The page is fetched last. */
	async isWhole(): Promise<boolean> {
		const cache = await this.#open();
		return (await cache.match(this.#address(PAGE), MATCHING)) !== undefined;
	}

	/** Returns whether another build is cached completely: pages come from that one. */
	async isOtherWhole(): Promise<boolean> {
		return (await this.#inOthers(PAGE)) !== undefined;
	}

	/**
	 * Fetches every file that is not cached yet, up to TRIES times each.
	 * @throws where one cannot be fetched, or differs from this build's, as after a deploy: fetched files stay
	 */
	fill(): Promise<void> {
		this.#filling ??= this.#fill().finally(() => {
			this.#filling = undefined;
		});
		return this.#filling;
	}

	/** Returns a cached file: of this build, or of a build with open pages where this build has no such file. */
	async find(path: string): Promise<Response | undefined> {
		if (!Object.hasOwn(this.#options.built.files, path))
			return isNamedByContent(path) ? this.#inOthers(path) : undefined;
		const cache = await this.#open();
		return cache.match(this.#address(path), MATCHING);
	}

	/**
	 * Returns a file of this build, or its script that serves specimens; fetches it if it is not cached yet.
	 * @throws as `fill`
	 */
	async bring(path: string): Promise<Response> {
		const cache = await this.#open();
		const cached = await cache.match(this.#address(path), MATCHING);
		if (cached) return cached;
		const response = await this.#fetch(path, "auto");
		await cache.put(this.#address(path), response.clone());
		return response;
	}

	/**
	 * Deletes other builds, except those that have one of these scripts.
	 * @param open addresses of the open pages' scripts
	 */
	async sweep(open: readonly string[]): Promise<void> {
		for (const name of await this.#others()) {
			const cache = await this.#options.caches.open(name);
			const found = await Promise.all(open.map((script) => cache.match(script, MATCHING)));
			if (found.every((script) => script === undefined)) await this.#options.caches.delete(name);
		}
	}

	/** Fetches the missing files, some at a time and each up to TRIES times; the page last. */
	async #fill(): Promise<void> {
		const cache = await this.#open();
		let waiting = Object.keys(this.#options.built.files).filter((path) => path !== PAGE);
		let failure: unknown;
		for (let tries = 0; tries < TRIES && waiting.length > 0; tries++) {
			const failed: string[] = [];
			const next = async (): Promise<void> => {
				for (let path = waiting.pop(); path !== undefined; path = waiting.pop()) {
					try {
						await this.#store(cache, path);
					} catch (error) {
						failed.push(path);
						failure = error;
					}
				}
			};
			await Promise.all(Array.from({ length: ABREAST }, next));
			waiting = failed;
		}
		if (waiting.length > 0) throw failure;
		await this.#store(cache, PAGE);
	}

	/** Adds a file to the cache, copied from another build's cache where its name depends on its content. */
	async #store(cache: Cache, path: string): Promise<void> {
		const address = this.#address(path);
		if (await cache.match(address, MATCHING)) return;
		const before = isNamedByContent(path) ? await this.#inOthers(path) : undefined;
		await cache.put(address, before ?? (await this.#fetch(path)));
	}

	/**
	 * Fetches a file of the build, and checks it by its hash (subresource integrity).
	 * @param path within the app's folder; empty for the page
	 */
	async #fetch(path: string, priority: "auto" | "low" = "low"): Promise<Response> {
		const response = await this.#options.fetch(this.#address(path), {
			integrity: this.#options.built.files[path],
			// Files that may have changed under the same name are revalidated.
			cache: isNamedByContent(path) ? "default" : "no-cache",
			priority,
		} as RequestInit);
		if (!response.ok) throw new Error(`${path || "The page"} could not be fetched: ${response.status}`);
		// Browsers open no page by a redirected response, which some hosts send for suffixes of names.
		return response.redirected ? new Response(await response.blob(), { headers: response.headers }) : response;
	}

	/** Returns a file from the caches of other builds; undefined where none has it. */
	async #inOthers(path: string): Promise<Response | undefined> {
		for (const name of await this.#others()) {
			const cache = await this.#options.caches.open(name);
			const found = await cache.match(this.#address(path), MATCHING);
			if (found) return found;
		}
		return undefined;
	}

	/** Returns the names of the other builds' caches. */
	async #others(): Promise<string[]> {
		const names = await this.#options.caches.keys();
		return names.filter((name) => name.startsWith(this.#prefix) && name !== this.#name);
	}

	/** Opens the cache of this build. */
	#open(): Promise<Cache> {
		return this.#options.caches.open(this.#name);
	}

	/** Returns the address of a file by its path in the app's folder. */
	#address(path: string): string {
		return this.#options.scope + path;
	}
}
