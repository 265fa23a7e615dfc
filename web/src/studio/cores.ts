/** Growing whatever model: the one place where the studio meets the core's client. */
import { Client } from "../core/client";
import { Superseded, UnsupportedError } from "../core/errors";
import type { GrowthOptions, Model } from "../models/model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";

export interface GrowOptions extends GrowthOptions {
	/** Cancels: the promise rejects with the signal's reason. */
	signal?: AbortSignal;
	/** Whether a sketch does for what besides the core it needs. */
	sketched?: boolean;
}

/** What grows specimens; rejects as `Client.grow` does. */
export interface Grower {
	grow(model: Model, specimen: Specimen, options?: GrowOptions): Promise<Plant>;
}

export class Cores implements Grower {
	readonly #addressOf: (file: string) => string | undefined;
	readonly #client: Pick<Client, "warm" | "grow">;
	#calls = 0;

	/** @param addressOf where a core's file lies; undefined where there is none of that name */
	constructor(addressOf: (file: string) => string | undefined, client: Pick<Client, "warm" | "grow"> = pageClient()) {
		this.#addressOf = addressOf;
		this.#client = client;
	}

	/** Starts fetching a core, so that it is warm when the first plant is asked for. */
	warm(file: string): void {
		const wasm = this.#addressOf(file);
		if (wasm !== undefined) this.#client.warm(wasm);
	}

	async grow(model: Model, specimen: Specimen, { signal, sketched, ...wanted }: GrowOptions = {}): Promise<Plant> {
		const wasm = this.#addressOf(model.wasm);
		if (wasm === undefined)
			throw new UnsupportedError("core", `The core of the ${model.noun} is not part of this page.`);
		const call = ++this.#calls;
		// What cannot be fetched is missing from the plant, and the core says so.
		const fetched = sketched && model.sketch ? model.sketch(specimen) : model.prepare?.(specimen);
		await fetched?.catch(() => {});
		// One that had less to wait for is under way: this would begin after it, and take its place.
		if (call !== this.#calls) throw new Superseded();
		const order = { wasm, blocks: model.encode(specimen, wanted) };
		return model.read(await this.#client.grow(order, signal ? { signal } : {}), specimen);
	}
}

/** Grows two side by side, where there is a second processor. */
function pageClient(): Client {
	return new Client({ abreast: Math.min(navigator.hardwareConcurrency, 2), onNote: (text) => console.info(text) });
}
