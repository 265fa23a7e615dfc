/** Encodes a specimen as the blocks of a request (wasm-core/src/models/stand/model.hpp). */
import type { Block } from "../../core/container";
import { CoreError } from "../../core/errors";
import type { GrowthOptions } from "../model";
import type { StandSpecimen } from "./specimen";
import { STAND_TABLE } from "./table";
import { fetchedText } from "./texts";

/** @throws CoreError where the preset's text has not been fetched, or a parameter is not a number */
export function encodeStand(specimen: StandSpecimen, options: GrowthOptions = {}): Block[] {
	const { meshes = true, preview = false } = options;
	const { measures = !preview } = options;
	const { model, seed, parameters } = specimen;
	const text = fetchedText(specimen);
	if (text === undefined) throw new CoreError("bad request", "The preset's plan could not be fetched.");
	return [
		{ name: "model", data: model },
		{ name: "seed", data: Uint32Array.of(seed) },
		{ name: "outputs", data: [meshes && "meshes", measures && "measures"].filter(Boolean).join(" ") },
		{
			name: "parameters",
			data: Float32Array.from(STAND_TABLE.core, ({ key }) => number(key, parameters[key as keyof typeof parameters])),
		},
		{ name: "plan", data: text },
	];
}

function number(key: string, value: number): number {
	if (Number.isFinite(value)) return value;
	throw new CoreError("bad request", `${key} is not a number.`);
}
