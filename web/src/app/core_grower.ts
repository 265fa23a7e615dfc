/** Growing whatever model: the one place where the studio meets the core's client. */
import { Client } from "../core/client";
import type { Block } from "../core/container";
import { Superseded, UnsupportedError } from "../core/errors";
import { grownMembers, MemberCache } from "../generate/members";
import type { GrowthOptions } from "../models/model";
import type { PageModel } from "../models/page_model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";

export interface GrowOptions extends GrowthOptions {
	/** Cancels: the promise rejects with the signal's reason. */
	signal?: AbortSignal;
	/** Whether a sketch does for what besides the core it needs. */
	sketched?: boolean;
	/** Told while those that stand in a plant still grow, with what there is so far. */
	grew?(grown: Plant): void;
}

/** What grows specimens; rejects as `Client.grow` does. */
export interface Grower {
	grow(model: PageModel, specimen: Specimen, options?: GrowOptions): Promise<Plant>;
}

export class CoreGrower implements Grower {
	readonly #addressOf: (file: string) => string | undefined;
	readonly #client: Pick<Client, "warm" | "grow" | "among">;
	readonly #members = new MemberCache();
	#calls = 0;

	/** @param addressOf where a core's file lies; undefined where there is none of that name */
	constructor(
		addressOf: (file: string) => string | undefined,
		client: Pick<Client, "warm" | "grow" | "among"> = pageClient(),
	) {
		this.#addressOf = addressOf;
		this.#client = client;
	}

	/** Starts fetching a core, so that it is warm when the first plant is asked for. */
	warm(file: string): void {
		const wasm = this.#addressOf(file);
		if (wasm !== undefined) this.#client.warm(wasm);
	}

	async grow(
		model: PageModel,
		specimen: Specimen,
		{ signal, sketched, grew, ...wanted }: GrowOptions = {},
	): Promise<Plant> {
		const wasm = this.#found(model.wasm, model.noun);
		const call = ++this.#calls;
		// What cannot be fetched is missing from the plant, and the core says so.
		const fetched = sketched && model.sketch ? model.sketch(specimen) : model.prepare?.(specimen);
		await fetched?.catch(() => {});
		// One that had less to wait for is under way: this would begin after it, and take its place.
		if (call !== this.#calls) throw new Superseded();
		const order = { wasm, blocks: model.encode(specimen, wanted) };
		const ending = signal ? { signal } : {};
		const grown = model.read(await this.#client.grow(order, ending), specimen);
		if (!model.members) return grown;
		const isNewest = () => {
			if (call !== this.#calls) throw new Superseded();
		};
		const run = async (file: string, blocks: readonly Block[]) => {
			isNewest();
			return this.#client.among({ wasm: this.#found(file, "plants there"), blocks }, ending);
		};
		return grownMembers(model, grown, run, {
			meshes: wanted.meshes ?? true,
			abreast: 2 * seats(),
			cache: this.#members,
			grew: (part) => {
				isNewest();
				if (!wanted.preview) grew?.(part);
			},
		});
	}

	#found(file: string, noun: string): string {
		const wasm = this.#addressOf(file);
		if (wasm === undefined) throw new UnsupportedError("core", `The core of the ${noun} is not part of this page.`);
		return wasm;
	}
}

/** As many workers as a stand of plants is worth, each with cores of its own. */
const seats = () => Math.max(1, Math.min(navigator.hardwareConcurrency, 4));

/** Grows two side by side, where there is a second processor. */
function pageClient(): Client {
	return new Client({
		abreast: Math.min(navigator.hardwareConcurrency, 2),
		seats: seats(),
		onNote: (text) => console.info(text),
	});
}
