/** Grows the plant of an element's document. */
import type { Client } from "../core/client";
import { coreAddress } from "../core/core_address";
import { Superseded, UnsupportedError } from "../core/errors";
import { growPlant } from "../generate/growth";
import type { GrowthOptions } from "../models/model";
import type { Plant } from "../plant/plant";
import type { SpecimenDocument } from "./grown_detail";
import { text } from "./messages.generated";

/** Number of a stand's member plants requested at once. */
const ABREAST = 4;

/**
 * Grows a document. Rejects as `Client.grow` does, and with an UnsupportedError if a core is not beside the script.
 * @param isNewest whether this is the newest request; once it is not, no more member plants are grown, and the promise
 * rejects with Superseded
 */
export async function growDocument(
	client: Pick<Client, "grow" | "growMember">,
	{ model, specimen }: SpecimenDocument,
	options: GrowthOptions,
	signal: AbortSignal,
	isNewest: () => boolean,
): Promise<Plant> {
	let first = true;
	const go = () => {
		if (!isNewest()) throw new Superseded();
	};
	const grown = await growPlant(
		{ ...model, prepare: (each) => model.prepare?.(each)?.catch(() => {}) },
		specimen,
		options,
		async (file, blocks) => {
			if (!first) go();
			const wasm = coreAddress(file);
			if (wasm === undefined) throw new UnsupportedError("core", text.message("core_missing", { file }));
			// A newer document supersedes the running growth of a document, but not those of member plants.
			const grown = first ? client.grow({ wasm, blocks }, { signal }) : client.growMember({ wasm, blocks }, { signal });
			first = false;
			return grown;
		},
		{ concurrency: ABREAST },
	);
	// A late stand must not replace a newer plant. Other plants are all shown, so that a drag shows intermediate states.
	if (model.members) go();
	return grown;
}
