/** Encodes a specimen as the blocks of a request (wasm-core/src/models/stand/model.hpp). */
import type { Block } from "../../core/container";
import { requestBlocks, requireText } from "../../plant/request";
import type { GrowthOptions } from "../model";
import type { StandSpecimen } from "./specimen";
import { STAND_TABLE } from "./table";
import { fetchedText } from "./texts";

/**
 * Encodes a stand as a request to the core; the plan is the preset's text or the user's own.
 * @throws CoreError where the preset's text has not been fetched, or a parameter is not a number
 */
export function encodeStand(specimen: StandSpecimen, options: GrowthOptions = {}): Block[] {
	const { meshes = true, preview = false } = options;
	const { measures = !preview } = options;
	const text = requireText(fetchedText(specimen));
	return [
		...requestBlocks(specimen, STAND_TABLE.core, [meshes && "meshes", measures && "measures"]),
		{ name: "plan", data: text },
	];
}
