/** The element's optional parts, one per attribute, each loaded on first use. */
import type { GrownDocument } from "../grown_detail";
import type { SpecimenView } from "../specimen_view";
import type { CanvasInteraction } from "./interaction";

/** An optional part that follows the plant in view. */
export interface Extra {
	show(shown: GrownDocument): void;
	/** Called when an attribute of the element has changed. */
	follow?(): void;
	dispose(): void;
}

export interface ExtrasHost {
	readonly element: HTMLElement & { toFile(format: string): Promise<Blob> };
	readonly root: ShadowRoot;
	readonly interaction: CanvasInteraction;
	/** The view of the plant; called only while a plant is shown. */
	view(): Promise<SpecimenView>;
}

const MADE_BY: Readonly<Record<string, (host: ExtrasHost) => Promise<Extra>>> = {
	controls: async (host) => new (await import("./bar")).Bar(host, await host.view()),
	wind: async (host) => new (await import("./pause")).Pause(host, await host.view()),
	handles: async (host) => new (await import("./handles_layer")).HandlesLayer(host, await host.view()),
};

export class ElementExtras {
	readonly #host: ExtrasHost;
	readonly #made = new Map<string, Promise<Extra | undefined>>();
	#shown: GrownDocument | undefined;

	constructor(host: ExtrasHost) {
		this.#host = host;
	}

	/** Creates the parts whose attributes are set, once there is a plant, and removes the others. */
	follow(): void {
		for (const name of Object.keys(MADE_BY)) {
			const wanted = this.#shown !== undefined && this.#host.element.hasAttribute(name);
			if (wanted && !this.#made.has(name)) this.#make(name);
			else if (!wanted) this.#drop(name);
		}
		this.#forEach((extra) => extra.follow?.());
	}

	show(shown: GrownDocument): void {
		this.#shown = shown;
		this.#forEach((extra) => extra.show(shown));
		this.follow();
	}

	/** Removes all parts, when the element leaves its page. */
	close(): void {
		this.#shown = undefined;
		for (const name of [...this.#made.keys()]) this.#drop(name);
	}

	/** Loads a part. If its script cannot be fetched, the next plant tries again. */
	#make(name: string): void {
		const making = MADE_BY[name](this.#host).then(
			(extra) => {
				if (this.#made.get(name) === making && this.#shown) extra.show(this.#shown);
				return extra;
			},
			() => {
				if (this.#made.get(name) === making) this.#made.delete(name);
				return undefined;
			},
		);
		this.#made.set(name, making);
	}

	/** Removes a part, also if its script is still loading. */
	#drop(name: string): void {
		const making = this.#made.get(name);
		this.#made.delete(name);
		void making?.then((extra) => extra?.dispose());
	}

	/** Calls a function with each part that is wanted, once it is loaded. */
	#forEach(work: (extra: Extra) => void): void {
		for (const making of this.#made.values()) void making.then((extra) => extra && work(extra));
	}
}
