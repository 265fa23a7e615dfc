import type { RecentPlant } from "../../../../web/src/app/recent/recent_plant";
import type { RecentChange, RecentContent, RecentStore } from "../../../../web/src/app/recent/recent_store";
import type { DeferStorage } from "../../../../web/src/app/recent/recents";

/** A store shared by several pages, as tabs share a browser's. Steps run one after the other, asynchronously. */
export class SharedRecent implements RecentStore {
	plants: readonly RecentPlant[] = [];
	contents = new Map<string, RecentContent>();
	/** The error of every step, as where storage is forbidden. */
	forbidden: Error | undefined;
	/** The error of steps that store contents, as on a full disk. */
	full: Error | undefined;
	#last: Promise<unknown> = Promise.resolve();

	all(): Promise<readonly RecentPlant[]> {
		return this.#inTurn(() => this.plants);
	}

	content(id: string): Promise<RecentContent> {
		return this.#inTurn(() => this.contents.get(id) ?? {});
	}

	change(decide: (stored: readonly RecentPlant[]) => RecentChange): Promise<void> {
		return this.#inTurn(() => {
			const { plants, contents, replaced } = decide(this.plants);
			if (this.full && [...(contents?.values() ?? [])].some(({ picture, extra }) => picture || extra)) throw this.full;
			this.plants = plants;
			this.contents = new Map(
				plants.map(({ id }) => {
					const sources = [contents?.get(id), this.contents.get(id)];
					for (const old of replaced?.get(id) ?? []) sources.push(this.contents.get(old));
					const [picture, extra] = (["picture", "extra"] as const).map((key) =>
						sources.map((source) => source?.[key]).find((each) => each !== undefined),
					);
					return [id, { picture, extra } as RecentContent];
				}),
			);
		});
	}

	#inTurn<T>(step: () => T): Promise<T> {
		const turn = this.#last
			.then(() => new Promise((resolve) => setTimeout(resolve)))
			.then(() => {
				if (this.forbidden) throw this.forbidden;
				return step();
			});
		this.#last = turn.catch(() => {});
		return turn;
	}
}

/** A browser's storage; `full` storages refuse to write. */
export class MemoryStorage implements DeferStorage {
	readonly items = new Map<string, string>();
	/** The most characters of an item. */
	most = Number.POSITIVE_INFINITY;

	getItem(key: string): string | null {
		return this.items.get(key) ?? null;
	}

	setItem(key: string, value: string): void {
		if (value.length > this.most) throw new DOMException("full", "QuotaExceededError");
		this.items.set(key, value);
	}

	removeItem(key: string): void {
		this.items.delete(key);
	}
}

export const plantAs = (id: string, more: Partial<RecentPlant> = {}): RecentPlant => ({
	id,
	link: `?v=2&preset=${id}`,
	title: id,
	at: 1000,
	...more,
});
