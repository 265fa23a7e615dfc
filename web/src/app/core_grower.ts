/** Grows plants of any model through the core's client; the studio's only access to it. */
import { Client } from "../core/client";
import type { Block } from "../core/container";
import { Superseded, UnsupportedError } from "../core/errors";
import { maxPageWorkers } from "../core/page_pool";
import { grownMembers, MemberCache } from "../generate/members";
import { readable, readablePlant } from "../generate/readable";
import type { GrowthOptions } from "../models/model";
import type { PageModel } from "../models/page_model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import { text } from "./messages.generated";

export interface PageGrowOptions extends GrowthOptions {
	/** Cancels: the promise rejects with the signal's reason. */
	signal?: AbortSignal;
	/** Whether the model's sketch is enough in place of the full files that the growth needs besides the core. */
	sketched?: boolean;
	/** Called with the plant so far, while member plants of a stand still grow. */
	grew?(grown: Plant): void;
}

/** Grows specimens; rejects as `Client.grow` does. */
export interface Grower {
	grow(model: PageModel, specimen: Specimen, options?: PageGrowOptions): Promise<Plant>;
}

export class CoreGrower implements Grower {
	readonly #addressOf: (file: string) => string | undefined;
	readonly #client: Pick<Client, "warm" | "grow" | "growMember">;
	readonly #members = new MemberCache();
	#calls = 0;

	/** @param addressOf address of a core's file; undefined for unknown names */
	constructor(
		addressOf: (file: string) => string | undefined,
		client: Pick<Client, "warm" | "grow" | "growMember"> = pageClient(),
	) {
		this.#addressOf = addressOf;
		this.#client = client;
	}

	/** Starts fetching a core, so that it is ready for the first growth. */
	warm(file: string): void {
		const wasm = this.#addressOf(file);
		if (wasm !== undefined) this.#client.warm(wasm);
	}

	/**
	 * Grows a specimen with all its members. A newer call supersedes an older one, which rejects with Superseded.
	 * @param options.grew receives the plant while its members arrive
	 */
	async grow(
		model: PageModel,
		specimen: Specimen,
		{ signal, sketched, grew, ...wanted }: PageGrowOptions = {},
	): Promise<Plant> {
		const wasm = this.#requireAddress(model.wasm);
		const call = ++this.#calls;
		// Parts that cannot be fetched are missing from the plant; the core's notes list them.
		const fetched = sketched && model.sketch ? model.sketch(specimen) : model.prepare?.(specimen);
		await fetched?.catch(() => {});
		// A newer call is running already: this older one must not replace it.
		if (call !== this.#calls) throw new Superseded();
		const order = { wasm, blocks: model.encode(specimen, wanted) };
		const ending = signal ? { signal } : {};
		const answer = await readable(() => this.#client.grow(order, ending))();
		const grown = await readablePlant(model.read(answer, specimen));
		if (!model.members) return grown;
		const isNewest = () => {
			if (call !== this.#calls) throw new Superseded();
		};
		const run = async (file: string, blocks: readonly Block[]) => {
			isNewest();
			return this.#client.growMember({ wasm: this.#requireAddress(file), blocks }, ending);
		};
		return grownMembers(model, grown, run, {
			meshes: wanted.meshes ?? true,
			concurrency: 2 * maxPageWorkers(),
			cache: this.#members,
			grew: (part) => {
				isNewest();
				if (!wanted.preview) grew?.(part);
			},
		});
	}

	/** Returns the address of a core's file; throws an UnsupportedError for unknown names. */
	#requireAddress(file: string): string {
		const wasm = this.#addressOf(file);
		if (wasm === undefined) throw new UnsupportedError("core", text("growing_no_core"));
		return wasm;
	}
}

/** Creates the client of the plant in view: it grows two plants in parallel where there is a second processor. */
const pageClient = () => new Client({ concurrency: Math.min(navigator.hardwareConcurrency, 2) });
