import { describe, expect, it } from "vitest";
import { agedOf, hasAges } from "../../../web/src/files/aged";
import type { Model } from "../../../web/src/models/model";
import { everyPart } from "../../../web/src/plant/part";
import { specimenFromPreset } from "../bunch";
import { freshCore, growBunch } from "../core/wasm";
import { bunchModel } from "../studio/desk";

describe("a plant at the ages of its life", () => {
	it("runs from the flower to the ripe bunch in even steps, whatever age it has itself", async () => {
		const core = await freshCore();
		const asked: number[] = [];
		const specimen = specimenFromPreset("riesling");
		const aged = agedOf(bunchModel, specimen, async (younger) => {
			asked.push(younger.parameters.age);
			return growBunch(core, younger as typeof specimen);
		});
		if (!aged) throw new Error("no ages");
		expect(aged.ages).toHaveLength(25);
		expect([aged.ages[0], aged.ages[1], aged.ages.at(-1)]).toEqual([0, 4.17, 100]);
		const green = async (age: number) => {
			const berry = [...everyPart(await aged.at(age))].find(({ name }) => name.startsWith("Berry "));
			const [red = 0, g = 0] = berry?.shape?.mesh.colours ?? [];
			return g / red;
		};
		expect(await green(25)).toBeGreaterThan(1.1 * (await green(100)));
		expect(asked).toEqual([25, 100]);
	});

	it("is of those alone that heed an age", () => {
		expect(hasAges(bunchModel, specimenFromPreset("riesling"))).toBe(true);
		expect(hasAges(bunchModel, specimenFromPreset("duku", 1))).toBe(false);
		const ageless = { ...bunchModel, table: { ...bunchModel.table, entry: () => undefined } } as unknown as Model;
		expect(agedOf(ageless, specimenFromPreset("riesling"), async () => Promise.reject())).toBeUndefined();
	});
});
