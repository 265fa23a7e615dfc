/** A document of an element as the plant that it grows into. */
import type { Client } from "../core/client";
import { coreAddress } from "../core/core_address";
import { Superseded } from "../core/errors";
import { growPlant } from "../generate/growth";
import type { GrowthOptions } from "../models/model";
import type { Plant } from "../plant/plant";
import type { SpecimenDocument } from "./grown_detail";

/** How many of those that stand in a plant are asked for at once. */
const ABREAST = 4;

/**
 * Rejects as `Client.grow` does, and with an Error where a core is not beside the script.
 * @param isNewest whether nothing newer is asked for: where that ends, no more of what stands in it is grown, and it rejects as superseded
 */
export async function growDocument(
	client: Pick<Client, "grow" | "among">,
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
			if (wasm === undefined) throw new Error(`The core ${file} is not beside the script.`);
			// The document itself gives way to a newer one; what stands in it does not.
			const grown = first ? client.grow({ wasm, blocks }, { signal }) : client.among({ wasm, blocks }, { signal });
			first = false;
			return grown;
		},
		{ abreast: ABREAST },
	);
	// Of plants that grow at once each is shown, so that a drag shows what there is; a stand that was late would undo a newer plant.
	if (model.members) go();
	return grown;
}
