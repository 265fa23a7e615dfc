/** The ecosystems of Table 2 (Kim, Kim and Cho 2013): growth steps, nodes per tree, and leaves of natural size. */
import { beforeAll, expect, it } from "vitest";
import { growPlant } from "../../../../web/src/generate/growth";
import { model as growth } from "../../../../web/src/models/growth/index";
import { model } from "../../../../web/src/models/stand/index";
import { valuesOf } from "../../../../web/src/models/stand/members";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { inRun } from "../../../long_run.mjs";
import { run } from "./stands";

/** Number of trees, growth steps, average number of nodes. */
const TABLE_2 = [
	[500, 7, 9, 194],
	[1000, 7, 7, 155],
	[1500, 6, 6, 99],
	[2000, 5, 5, 59],
] as const;
/** Number of trees of a stand whose branches are counted. */
const COUNTED = inRun(120, 500);

let plans: StandPlant[];
beforeAll(async () => {
	await Promise.all(growth.presets.list.map(({ name }) => growth.prepare(fromPreset(growth, name))));
	plans = await Promise.all(
		TABLE_2.map(async ([count]) => {
			const specimen = fromPreset(model, `ecosystem-${count}`);
			await model.prepare?.(specimen);
			return model.read(await run(model.wasm, model.encode(specimen, { meshes: false })));
		}),
	);
});

it.each(TABLE_2)("%i trees have %i to %i steps, and leaves as long as trees have", (count, least, most) => {
	const plan = plans[TABLE_2.findIndex(([each]) => each === count)];
	expect(plan.places.count).toBeGreaterThan(0.98 * count);
	const steps = new Set<number>();
	for (let plant = 0; plant < plan.places.count; plant++) {
		const values = valuesOf(plan, plant);
		steps.add(Math.round(Number(values.steps)));
		expect(values.leaf_size).toBeGreaterThan(5);
		expect(values.leaf_size).toBeLessThan(15);
	}
	expect([...steps].sort()).toEqual(Array.from({ length: most - least + 1 }, (_, i) => least + i));
});

it.each(TABLE_2)(
	"%i trees of %i to %i steps have %i nodes on average, counted as branches",
	async (count, _, __, nodes) => {
		const plan = plans[TABLE_2.findIndex(([each]) => each === count)];
		let sum = 0;
		for (let i = 0; i < COUNTED; i++) {
			const plant = Math.floor((i * plan.places.count) / COUNTED);
			const { steps } = valuesOf(plan, plant);
			const preset = fromPreset(growth, plan.kinds[plan.places.kind[plant]].preset);
			const parameters = { ...preset.parameters, steps: Math.round(Number(steps)), leaf_kind: 0 };
			const specimen = { ...preset, seed: plan.places.seed[plant], parameters };
			sum += (await growPlant(growth, specimen, { meshes: false, measures: false }, run)).counts.branches;
		}
		expect(sum / COUNTED / nodes).toBeGreaterThan(0.85);
		expect(sum / COUNTED / nodes).toBeLessThan(1.15);
	},
);
