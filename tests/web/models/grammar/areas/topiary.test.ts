import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../../web/src/core/core";
import type { GrammarPlant } from "../../../../../web/src/models/grammar/grammar_plant";
import { model } from "../../../../../web/src/models/grammar/index";
import type { GrammarSpecimen } from "../../../../../web/src/models/grammar/specimen";
import { fetchTexts } from "../../../../../web/src/models/grammar/texts";
import { fromPreset } from "../../../../../web/src/specimen/from_preset";
import { freshCore } from "../../../core/wasm";
import { clothed, lateralTips, leafBases, surfacePlaces } from "./clothing";

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("grammar.wasm");
});

const grow = (specimen: GrammarSpecimen): GrammarPlant => model.read(core.grow(model.encode(specimen, { meshes: false })));
const presets = model.presets.list.filter(({ kind }) => kind === "topiary").map(({ name }) => name);

describe.each(presets)("%s", (name) => {
	it("is clothed by leaves of a fifteenth of its areas, within 20,000 segments", () => {
		const specimen = fromPreset(model, name);
		const t = performance.now();
		const plant = grow(specimen);
		const ms = performance.now() - t;
		const { leaf } = specimen.constants;
		const bases = leafBases(plant);
		const shares = (specimen.areas ?? []).map((area) => clothed(surfacePlaces(area, 1500), bases, leaf));
		console.log(name, plant.segments.count, plant.organs.count, plant.counts.steps, ms.toFixed(0), shares.map((x) => x.toFixed(3)).join(" "), (specimen.areas ?? []).map((a) => (Math.max(...a.size) / leaf).toFixed(1) + "/" + (Math.cbrt(a.size[0] * a.size[1] * a.size[2]) / leaf).toFixed(1)).join(" "), plant.notes.join());
		expect(lateralTips(plant).length).toBeGreaterThan(100);
	});
});
