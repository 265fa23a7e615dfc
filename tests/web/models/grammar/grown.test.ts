import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { exportJson, writeJson } from "../../../../web/src/formats/json";
import type { GrammarPlant } from "../../../../web/src/models/grammar/grammar_plant";
import { model } from "../../../../web/src/models/grammar/index";
import type { GrammarOrganRecord, LineRecord } from "../../../../web/src/models/grammar/record";
import type { GrammarRequestOptions } from "../../../../web/src/models/grammar/request";
import type { GrammarSpecimen } from "../../../../web/src/models/grammar/specimen";
import { fetchTexts } from "../../../../web/src/models/grammar/texts";
import { everyPart } from "../../../../web/src/plant/part";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { freshCore } from "../../core/wasm";

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("grammar.wasm");
});

const of = (grammar: string, changes: Partial<GrammarSpecimen> = {}): GrammarSpecimen => ({
	...fromPreset(model),
	...changes,
	grammar,
});
const grow = (specimen: GrammarSpecimen, options?: GrammarRequestOptions): GrammarPlant =>
	model.read(core.grow(model.encode(specimen, options)));

/** Blades of a leaf that has not opened. */
const ALLOWED = /grammar\.flat_polygons/;

const TWIGS = "#define spread 40\naxiom: F [ +(spread) F S(0.3) ] [ -(spread) F S(0.2) ] F";

describe("a plant that a text grows", () => {
	it("has notes only if there is something to report, for every preset", () => {
		const wrong = model.presets.list.flatMap(({ name }) => {
			const { notes: all, counts } = grow(fromPreset(model, name), { meshes: false });
			const notes = all.filter((note) => !ALLOWED.test(note));
			return notes.length > 0 || counts.segments + counts.organs === 0 ? [{ name, notes, counts }] : [];
		});
		expect(wrong).toEqual([]);
	});

	it("has its modules, steps and string in the JSON document", () => {
		const specimen = of(TWIGS);
		const grown = grow(specimen, { string: true });
		const json = exportJson(model, grown, specimen);
		expect(json).toMatchObject({
			modules: 12,
			steps: 0,
			string: "F[+(40)F S(0.3)][-(40)F S(0.2)]F",
			counts: { modules: 12, segments: 4, organs: 2, polygons: 0 },
		});
		expect((json.segments as LineRecord[]).map(({ module }) => module)).toEqual([0, 3, 8, 11]);
		expect((json.organs as GrammarOrganRecord[]).map(({ module, kind }) => [module, kind])).toEqual([
			[4, "ball"],
			[9, "ball"],
		]);
		expect(JSON.parse(writeJson(model, grown, specimen).toString())).toEqual(json);
		expect(exportJson(model, grow(specimen), specimen)).not.toHaveProperty("string");
	});

	it("is meshed coarsely in passing where it has many lines, and is the same plant", () => {
		const text = of("derivation length: 8\naxiom: A\nA --> F [ +(30) A ] [ -(30) /(90) A ] A");
		const [fine, coarse] = [{}, { preview: true }].map((options) => grow(text, options));
		expect(coarse.meshes[0].indices.length).toBeLessThan(fine.meshes[0].indices.length / 2);
		expect(coarse.fingerprint).toBe(fine.fingerprint);
	});

	it("uses constants and steps", () => {
		const wide = grow(of(TWIGS, { constants: { spread: 90 } }));
		expect(wide.segments.ends[6 + 4]).toBeCloseTo(0.01);
		expect(wide.segments.ends[6 + 3]).toBeCloseTo(-0.01);
		expect(grow(of("axiom: F\nF --> F F", { steps: 5 })).counts.segments).toBe(32);
	});

	it("summarises its counts in words", () => {
		expect(model.summary(grow(of(TWIGS)))).toBe("12 modules, 4 segments, 2 organs");
		expect(model.summary(grow(of("axiom: F")))).toBe("1 module, 1 segment");
	});

	it("is in parts by colour, in the document's palette, each with a name", () => {
		const specimen = of(TWIGS);
		specimen.look.colour7 = "0000ff";
		const parts = [...everyPart(model.parts(grow(specimen), specimen))];
		expect(parts.map(({ name }) => name)).toEqual(["Lines", "Ball 7"]);
		expect(parts[1].shape?.material).toMatchObject({ name: "Skin 7", colour: [0, 0, 1] });
		expect(parts[1].shape?.instances?.each?.(1)).toEqual({ name: "Ball 2", extras: { segment: 2, module: 9 } });
	});

	it("rejects specimens without a text", () => {
		expect(() => model.encode({ ...fromPreset(model), preset: "none" })).toThrow(
			"The preset’s grammar could not be loaded. Check your connection and try again.",
		);
	});
});
