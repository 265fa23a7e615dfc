import { expect, it } from "vitest";
import { batchFormats } from "../../../web/src/app/files/batch";
import { downloadFormats } from "../../../web/src/app/files/formats";
import { formatKeysOf as formatsOfSeries } from "../../../web/src/batch/series";
import { EMPTY_PLANT } from "../../../web/src/plant/plant";
import { specimenFromPreset } from "../bunch";
import { bunchModel } from "./context";

it("offers the formats of a series for a batch, without growth animations", () => {
	const shown = { model: bunchModel, grown: EMPTY_PLANT, from: specimenFromPreset("riesling") };
	const keys = batchFormats(shown).map(({ key }) => key);
	expect(downloadFormats(shown, undefined).map(({ key }) => key)).toContain("glb-growth");
	expect(keys).not.toContain("glb-growth");
	expect(keys).toEqual(expect.arrayContaining(["glb", "glb-low", "stl", "obj", "json"]));
	expect(formatsOfSeries(bunchModel)).toEqual(expect.arrayContaining(keys));
});
