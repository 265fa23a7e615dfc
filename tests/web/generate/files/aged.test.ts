import { describe, expect, it } from "vitest";
import { agedOf, hasAges } from "../../../../web/src/generate/files/aged";
import { model as flower } from "../../../../web/src/models/flower/index";
import type { FlowerSpecimen } from "../../../../web/src/models/flower/specimen";
import type { Model } from "../../../../web/src/models/model";
import { everyPart } from "../../../../web/src/plant/part";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { bunchModel } from "../../app/context";
import { specimenFromPreset } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";

const flowerModel = flower as unknown as Model;
const flowerOf = (preset: string) => fromPreset(flower, preset);

describe("a plant at the ages of its life", () => {
	it("runs from the flower to the ripe bunch in even steps, whatever age it has itself", async () => {
		const core = await freshCore();
		const requested: number[] = [];
		const specimen = specimenFromPreset("riesling");
		const aged = agedOf(bunchModel, specimen, async (younger) => {
			requested.push(younger.parameters.age);
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
		expect(requested).toEqual([25, 100]);
	});

	it("is a flower from the bud to where it is open, and none whose text says nothing of age", async () => {
		await flower.prepare(flowerOf("tulip"));
		const core = await freshCore("flower.wasm");
		const aged = agedOf(flowerModel, flowerOf("tulip"), async (younger) =>
			flower.read(core.grow(flower.encode(younger as FlowerSpecimen))),
		);
		expect([aged?.ages.length, aged?.ages[0], aged?.ages[12], aged?.ages.at(-1)]).toEqual([25, 0, 0.5, 1]);
		const [bud, open] = await Promise.all([0, 1].map(async (age) => [...((await aged?.at(age)) ?? [])]));
		expect(bud[0].shape?.mesh.positions).not.toEqual(open[0].shape?.mesh.positions);
		expect(hasAges(flowerModel, flowerOf("table-3"))).toBe(false);
	});

	it("is of those alone that heed an age", () => {
		expect(hasAges(bunchModel, specimenFromPreset("riesling"))).toBe(true);
		expect(hasAges(bunchModel, specimenFromPreset("duku", 1))).toBe(false);
		const ageless = { ...bunchModel, table: { ...bunchModel.table, entry: () => undefined } } as unknown as Model;
		expect(agedOf(ageless, specimenFromPreset("riesling"), async () => Promise.reject())).toBeUndefined();
	});
});
