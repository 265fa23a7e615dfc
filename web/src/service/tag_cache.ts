/** A cache of entity tags of the last answers, by request: an unchanged answer need not be computed to report that. */
export class TagCache {
	readonly #tags = new Map<string, string>();

	/** @param most the size of the cache; the least recently used tags are evicted */
	constructor(readonly most: number) {}

	/** Returns the cached tag of a request, which then counts as recently used; undefined if it is not cached. */
	tag(key: string): string | undefined {
		const tag = this.#tags.get(key);
		if (tag !== undefined) this.keep(key, tag);
		return tag;
	}

	/** Caches the tag of a request; evicts the least recently used one if there are too many. */
	keep(key: string, tag: string): void {
		this.#tags.delete(key);
		this.#tags.set(key, tag);
		if (this.#tags.size > this.most) this.#tags.delete(this.#tags.keys().next().value as string);
	}
}
