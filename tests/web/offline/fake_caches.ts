/** Caches of a browser, as far as the app uses them: answers by address. */
export class FakeCaches {
	readonly stored = new Map<string, Map<string, Response>>();

	async open(name: string) {
		const cache = this.stored.get(name) ?? new Map<string, Response>();
		this.stored.set(name, cache);
		return {
			match: async (address: string) => cache.get(address)?.clone(),
			put: async (address: string, response: Response) => void cache.set(address, response),
		};
	}

	keys = async () => [...this.stored.keys()];
	delete = async (name: string) => this.stored.delete(name);

	/** Responses in a cache, by address. */
	texts(name: string): Promise<Record<string, string>> {
		const found = [...(this.stored.get(name) ?? [])].map(async ([address, answer]) => [
			address,
			await answer.clone().text(),
		]);
		return Promise.all(found).then(Object.fromEntries);
	}
}
