import { beforeAll, expect, it } from "vitest";
import { nextStep } from "../../../../web/src/controls/life";
import type { Core } from "../../../../web/src/core/core";
import type { Model } from "../../../../web/src/models/model";
import { model as leaf } from "../../../../web/src/models/particles/leaf/index";
import { model as root } from "../../../../web/src/models/particles/root/index";
import type { TrailPlant } from "../../../../web/src/models/particles/trails";
import { model as tree } from "../../../../web/src/models/particles/tree/index";
import { LIFE } from "../../../../web/src/models/particles/watch";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import type { Specimen } from "../../../../web/src/specimen/specimen";
import { particlesCore } from "./boundary/particles";

let core: Core;
beforeAll(async () => {
	core = await particlesCore();
});

it.each([
	["leaf", leaf, ["grapevine", "oak", "willow"]],
	["tree", tree, ["oak", "bonsai", "hedge"]],
	["root", root, ["tap", "fibrous"]],
] as const)("a %s runs in as many steps at any age, each of which is seen, up to the end", (_, each, presets) => {
	const model = each as unknown as Model<Specimen, TrailPlant>;
	for (const preset of presets) {
		const specimen = fromPreset(model, preset);
		const at = (age: number) => {
			const parameters = { ...specimen.parameters, particles: 40, age };
			const asked = { ...specimen, parameters };
			return model.read(core.grow(model.encode(asked, { meshes: false, measures: false })), asked);
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
