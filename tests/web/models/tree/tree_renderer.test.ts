import { Group } from "three";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { model as rootModel } from "../../../../web/src/models/root/index";
import { model } from "../../../../web/src/models/tree/index";
import { boundingProfileOf, fitView, needsRefit } from "../../../../web/src/render/camera_fit";
import { PAPER } from "../../../../web/src/render/model_renderer";
import { PaperShadow } from "../../../../web/src/render/paper_shadow";
import { StageLight } from "../../../../web/src/render/stage_light";
import { windUniforms } from "../../../../web/src/render/wind_shader";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { particlesCore } from "../particles/boundary/particles";

let core: Core;
beforeAll(async () => {
	core = await particlesCore();
});

const stage = () => ({
	root: new Group(),
	light: new StageLight(),
	shadow: new PaperShadow(),
	wind: windUniforms(),
	setting: PAPER,
});

/** The framing of a plant with few particles and no leaves. */
async function fitOf(kind: typeof model | typeof rootModel, preset: string, life: "run" | "grow", age: number) {
	const published = fromPreset(kind as typeof model, preset);
	const { parameters } = published;
	const entry = kind.table.entry("life");
	const option = entry && "options" in entry ? entry.options.indexOf(life) : -1;
	const specimen = { ...published, parameters: { ...parameters, particles: 80, leaves: 0, life: option, age } };
	const plant = (kind as typeof model).read(core.grow(kind.encode(specimen as never, { preview: true })), specimen);
	const figure = (await (kind as typeof model).render())(stage());
	figure.show(plant, specimen);
	const fit = fitView(boundingProfileOf(figure.bounds()), 0.42, 1, 0.07, 0.12);
	figure.dispose();
	return fit;
}

describe.each([
	[model, "oak"],
	[rootModel, "tap"],
] as const)("the view of a plant that grows with its age", (kind, preset) => {
	it("is as large for a young one as for the grown one", async () => {
		const grown = await fitOf(kind, preset, "grow", 100);
		for (const age of [0, 10, 50]) {
			const young = await fitOf(kind, preset, "grow", age);
			expect(needsRefit(young, grown)).toBe(false);
			expect(needsRefit(grown, young)).toBe(false);
		}
	});
});

describe("the view of a plant that runs", () => {
	it("is framed by its visible parts", async () => {
		const run = await fitOf(model, "cypress", "run", 100);
		const grown = await fitOf(model, "cypress", "grow", 100);
		expect(run.distance).toBeLessThan(grown.distance);
	});
});
