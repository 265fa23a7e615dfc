/** A cache of entity tags of the last answers, by request: an unchanged answer need not be computed to report that. */
export class Known {
	readonly #tags = new Map<string, string>();

	/** @param most the size of the cache; the least recently used tags are evicted */
	constructor(readonly most: number) {}

	tag(asked: string): string | undefined {
		const tag = this.#tags.get(asked);
		if (tag !== undefined) this.keep(asked, tag);
		return tag;
	}

	keep(asked: string, tag: string): void {
		this.#tags.delete(asked);
		this.#tags.set(asked, tag);
		if (this.#tags.size > this.most) this.#tags.delete(this.#tags.keys().next().value as string);
	}
}
