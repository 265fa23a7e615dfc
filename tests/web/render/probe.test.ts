import { Matrix4, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { blurred, COSINE_SHARPNESS, rigOf } from "../../../web/src/render/light";
import { probeOf } from "../../../web/src/render/probe";

/** Irradiance on a matt white surface with normal `n`, by three's own formula. */
function gathered(n: Vector3, camera = new Matrix4()): Vector3 {
	return probeOf(rigOf("light").surroundings, camera).getIrradianceAt(n, new Vector3()).divideScalar(Math.PI);
}

/** The same as the bunch's shaders have it. */
function drawn(n: Vector3): Vector3 {
	return rigOf("light").surroundings.reduce((sum, lobe) => {
		const { axis, sharpness, colour } = blurred(lobe, COSINE_SHARPNESS);
		return sum.addScaledVector(new Vector3(...colour), Math.exp(sharpness * (n.dot(axis) - 1)));
	}, new Vector3());
}

describe("probeOf", () => {
	it("lights standard materials by the surroundings like our shaders", () => {
		for (const at of [
			[0, 1, 0],
			[0, -1, 0],
			[0, 0, -1],
			[1, 0, 0],
			[-0.6, 0, 0.8],
		]) {
			const n = new Vector3(...at);
			expect(gathered(n).distanceTo(drawn(n))).toBeLessThan(0.06);
		}
	});

	it("turns with the viewer", () => {
		const camera = new Matrix4().makeRotationY(Math.PI / 2);
		const n = new Vector3(0, 0, -1);
		expect(gathered(n.clone().transformDirection(camera), camera).distanceTo(gathered(n))).toBeLessThan(1e-6);
	});
});
