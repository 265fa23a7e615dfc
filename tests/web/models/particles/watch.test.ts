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
	["leaf", leaf],
	["tree", tree],
	["root", root],
] as const)("a %s runs in as many steps at any age, and each of them moves it on", (_, each) => {
	const model = each as unknown as Model<Specimen, TrailPlant>;
	const specimen = fromPreset(model);
	const at = (age: number) => {
		const parameters = { ...specimen.parameters, particles: 120, age };
		const asked = { ...specimen, parameters };
		return model.read(core.grow(model.encode(asked, { meshes: false })), asked);
	};
	const whole = at(100);
	const steps = LIFE.steps?.(whole) ?? 0;
	expect(steps).toBeGreaterThan(10);
	const seen = new Set([at(0).fingerprint]);
	for (let [age, step] = [0, 1]; step <= 12; step++) {
		age = nextStep(LIFE, age, steps);
		const now = at(age);
		expect(LIFE.steps?.(now)).toBe(steps);
		seen.add(now.fingerprint);
	}
	// Trails of trees and roots are simplified: of neighbouring moments two may be alike.
	expect(seen.size).toBeGreaterThan(6);
	expect(at(nextStep(LIFE, 99.99, steps)).segments.ends.length).toBe(whole.segments.ends.length);
	expect(nextStep(LIFE, 100, steps)).toBe(0);
});
