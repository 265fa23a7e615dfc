/** The Khronos validator's verdict on a small plant of every model, in every form of GLB that needs neither ages nor levels. */
import { beforeAll, describe, expect, it } from "vitest";
import { CoreCache } from "../../../web/src/core/cores";
import { aboutPlant } from "../../../web/src/formats/about_plant";
import { PLANT_FILES } from "../../../web/src/formats/plant_files";
import { webGlb } from "../../../web/src/formats/web_glb";
import { makeFile } from "../../../web/src/generate/files/make";
import { growPlant } from "../../../web/src/generate/growth";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import type { Model } from "../../../web/src/models/model";
import type { Plant } from "../../../web/src/plant/plant";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { restore } from "../../../web/src/specimen/restore";
import type { Specimen } from "../../../web/src/specimen/specimen";
import { freshCore } from "../core/wasm";
import { complaints } from "./reading";

/** Settings that make a plant small, by model. */
const SMALL: Record<string, object> = {
	bunch: { preset: "redcurrant", count: 5, leaves: 1 },
	flower: { preset: "petal" },
	grammar: { grammar: "axiom: F [ +(40) F S(0.3) ] [ -(40) F S(0.2) ] F" },
	leaf: { n: 60 },
	tree: { preset: "sphere", n: 200 },
	root: { n: 60 },
	growth: { steps: 4 },
	stand: { grammar: "plants 2, random\ngrowth/figure-5: steps 2" },
};

/** Without glb-web, whose compression the validator cannot read, and MSFT_lod, which it does not know (lod_glb.test.ts). */
const FORMS = PLANT_FILES.filter(({ ending, life, levelled }) => ending === "glb" && !life && !levelled)
	.map(({ key }) => key)
	.filter((key) => key !== "glb-web");

const cores = new CoreCache(freshCore);

describe.each(modelNames())("a plant of the model %s", (name) => {
	let model: Model;
	let specimen: Specimen;
	let grown: Plant;
	beforeAll(async () => {
		model = (await modelNamed(name)) as Model;
		specimen = restore(model, SMALL[name] ?? {}, fromPreset(model)).specimen;
		grown = await growPlant(model, specimen, {}, (wasm, blocks) => cores.grow(wasm, blocks));
	});

	it.each(FORMS)("is a valid file of the format %s", async (format) => {
		const request = { model: name, format, grown, specimen, link: "https://example.org/?v=2", name };
		const file = await makeFile(model, { ...request, options: { triangles: 900 } });
		expect(await complaints(new Uint8Array(await file.arrayBuffer()))).toEqual([]);
	});

	it("is a valid file of the format glb-web before it is compressed", async () => {
		const about = await aboutPlant(model, grown, specimen);
		expect(await complaints(await webGlb(model.parts(grown, specimen), about, false))).toEqual([]);
	});
});
