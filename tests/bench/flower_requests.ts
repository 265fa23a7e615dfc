/** What the bench asks of flowers. A module of its own, for what it fetches has to be there once it has been read. */
import { writeContainer } from "../../web/src/core/container";
import { model } from "../../web/src/models/flower/index";
import { encodeFlower } from "../../web/src/models/flower/request";
import { fromPreset } from "../../web/src/specimen/from_preset";

await model.prepare(fromPreset(model));

/** The shelf's species. */
export const FLOWERS = model.presets.list.filter(({ kind }) => kind === "species").map(({ name }) => name);

/** A flower's map alone, or with its skin, rounded so often, and nothing else. */
export function flowerOf(name: string, meshes: boolean, smooth = 1): Uint8Array {
	const plain = fromPreset(model, name);
	const specimen = { ...plain, parameters: { ...plain.parameters, smooth } };
	return writeContainer(encodeFlower(specimen, { meshes, sky: false, measures: false, map: false }));
}
