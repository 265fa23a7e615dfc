/** Tags of the answers given last, by what was asked: an answer that has not changed need not be worked out to say so. */
export class Known {
	readonly #tags = new Map<string, string>();

	/** @param most how many are kept; those not asked for longest are forgotten */
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
