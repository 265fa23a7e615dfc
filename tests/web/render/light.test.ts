import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import {
	blurred,
	COSINE_SHARPNESS,
	frameOf,
	GLOSS_SHARPNESS,
	type Lobe,
	rigOf,
	type Theme,
} from "../../../web/src/render/light";
import { lightUniforms, setRig } from "../../../web/src/render/light_shader";

/** ∫ of the lobe's red over the sphere. */
function total({ sharpness, colour }: Lobe): number {
	let sum = 0;
	const steps = 4000;
	for (let i = 0; i < steps; i++) {
		const cosine = -1 + (2 * (i + 0.5)) / steps;
		sum += colour[0] * Math.exp(sharpness * (cosine - 1));
	}
	return (sum * 2 * 2 * Math.PI) / steps;
}

describe.each(["light", "dark"] as Theme[])("the %s rig", (theme) => {
	const rig = rigOf(theme);

	it("keeps its total light when blurred", () => {
		for (const lobe of rig.surroundings) {
			for (const sharpness of [COSINE_SHARPNESS, GLOSS_SHARPNESS]) {
				const wide = blurred(lobe, sharpness);
				expect(wide.sharpness).toBeLessThan(lobe.sharpness);
				expect(total(wide)).toBeCloseTo(total(lobe), 3);
			}
		}
	});

	it("has windows whose frames turn their own direction into +Z", () => {
		for (const window of [rig.key, rig.rim]) {
			const ahead = window.direction.clone().applyMatrix3(frameOf(window));
			expect(ahead.distanceTo(new Vector3(0, 0, 1))).toBeLessThan(1e-9);
			expect(frameOf(window).determinant()).toBeCloseTo(1, 9);
		}
	});

	it("reaches the shader as lobes that approximate the Gaussians", () => {
		const uniforms = lightUniforms();
		setRig(uniforms, rig);
		rig.surroundings.forEach((lobe, i) => {
			const wide = blurred(lobe, COSINE_SHARPNESS);
			const { x, y, z, w } = uniforms.diffuseLobes.value[i];
			for (const d of [lobe.axis, lobe.axis.clone().negate(), new Vector3(0, 0, 1), new Vector3(1, 0, 0)]) {
				const drawn = Math.max(0, d.x * x + d.y * y + d.z * z + w) ** 8;
				expect(Math.abs(drawn - Math.exp(wide.sharpness * (d.dot(lobe.axis) - 1)))).toBeLessThan(0.04);
			}
		});
	});
});
