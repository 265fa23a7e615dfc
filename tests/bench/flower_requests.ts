/** Requests of the benchmark for flowers. A separate module, because its fetches must finish when it has loaded. */
import { writeContainer } from "../../web/src/core/container";
import { model } from "../../web/src/models/flower/index";
import { encodeFlower } from "../../web/src/models/flower/request";
import type { FlowerSpecimen } from "../../web/src/models/flower/specimen";
import { fetchedText } from "../../web/src/models/flower/texts";
import { fromPreset } from "../../web/src/specimen/from_preset";

await model.prepare(fromPreset(model));

/** The shelf's species, inflorescences and meadows. */
export const FLOWERS = model.presets.list
	.filter(({ kind }) => /^(?:species|inflorescences|meadows)$/.test(kind))
	.map(({ name }) => name);

/** Names of presets, by their texts. */
export const textNames = new Map(
	model.presets.list.map(({ name }) => [fetchedText(fromPreset(model, name)), name] as const),
);

/** Differences of a flower from its preset. */
export interface Changed {
	/** A variable’s number, read where the text first gives it. */
	number?: [name: string, value: number];
}

/** One volume with its skin, which takes some microseconds. Alternating requests make the core release its caches. */
export const stemsAlone = [4, 5].map((sides) =>
	encodedRequest({ ...fromPreset(model), grammar: `#define STEM(${sides},0,0,0,1,1,1,1)\n#axiom: STEM\n` }, true),
);

/** A flower's map alone, or with its skin, rounded so often, and nothing else. */
export function flowerOf(name: string, meshes: boolean, smooth = 1, { number }: Changed = {}): Uint8Array {
	const plain = fromPreset(model, name);
	const text = fetchedText(plain) ?? "";
	const grammar = number && text.replace(RegExp(`(#define ${number[0]}=)[\\d.]+`), `$1${number[1]}`);
	if (grammar === text) throw new Error(`${name} has no other ${number?.[0]}`);
	const specimen = {
		...plain,
		parameters: { ...plain.parameters, smooth },
		...(grammar ? { grammar } : {}),
	};
	return encodedRequest(specimen, meshes);
}

function encodedRequest(specimen: FlowerSpecimen, meshes: boolean): Uint8Array {
	return writeContainer(encodeFlower(specimen, { meshes, sky: false, measures: false, map: false }));
}
