import { beforeAll, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { model as leaf } from "../../../../web/src/models/leaf/index";
import type { PageModel } from "../../../../web/src/models/page_model";
import type { TrailPlant } from "../../../../web/src/models/particles/trails";
import { GROWTH, LIFE } from "../../../../web/src/models/particles/watch";
import { model as root } from "../../../../web/src/models/root/index";
import { model as tree } from "../../../../web/src/models/tree/index";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import type { Specimen } from "../../../../web/src/specimen/specimen";
import { nextStep } from "../../../../web/src/ui/life";
import type { ModelUi } from "../../../../web/src/ui/tool";
import { inRun } from "../../../long_run.mjs";
import { particlesCore } from "./boundary/particles";

let core: Core;
beforeAll(async () => {
	core = await particlesCore();
});

it.each([
	["leaf", leaf, inRun(["oak"], ["grapevine", "oak", "willow"])],
	["tree", tree, inRun(["bonsai"], ["oak", "bonsai", "hedge"])],
	["root", root, ["tap", "fibrous"]],
] as const)("a %s runs in as many steps at any age, each of which is seen, up to the end", (_, each, presets) => {
	const model = each as unknown as PageModel<Specimen, TrailPlant>;
	for (const preset of presets) {
		const specimen = fromPreset(model, preset);
		const at = (age: number) => {
			const parameters = { ...specimen.parameters, particles: 40, age };
			const changed = { ...specimen, parameters };
			return model.read(core.grow(model.encode(changed, { meshes: false, measures: false })), changed);
		};
		const whole = at(100);
		const steps = LIFE.steps?.(whole) ?? 0;
		expect(steps).toBeGreaterThan(5);
		let pressed = 0;
		let before = at(0).fingerprint;
		for (let age = 0; age < 100; pressed++) {
			age = nextStep(LIFE, age, steps);
			const now = at(age);
			expect(LIFE.steps?.(now)).toBe(steps);
			expect(now.fingerprint, `${preset}, step ${pressed} of ${steps}`).not.toBe(before);
			before = now.fingerprint;
		}
		expect(pressed).toBe(steps);
		expect(before).toBe(whole.fingerprint);
		expect(nextStep(LIFE, 100, steps)).toBe(0);
	}
});

it.each([
	["tree", tree],
	["root", root],
] as const)("a %s that grows with its age has a life of its own stages, one at a time", async (_, each) => {
	const model = each as unknown as PageModel<Specimen, TrailPlant>;
	const face = (await model.ui?.()) as ModelUi<Specimen, TrailPlant>;
	const bars = (life: number) => {
		const specimen = fromPreset(model);
		const changed = { ...specimen, parameters: { ...specimen.parameters, life } };
		return face.tools.filter(({ bar, applies }) => bar && (applies?.(changed) ?? true)).map(({ name }) => name);
	};
	expect([bars(0), bars(1)]).toEqual([["age"], ["growth"]]);
	expect(GROWTH.stages.map(({ name }) => name)).not.toContain("Merging");
});
