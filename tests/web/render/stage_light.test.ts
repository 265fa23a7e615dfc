import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { rigOf, spreadOf, type Theme } from "../../../web/src/render/light";
import { outdoorRig } from "../../../web/src/render/outdoor/outdoor_light";
import { PaperShadow } from "../../../web/src/render/paper_shadow";
import { StageLight } from "../../../web/src/render/stage_light";

describe("StageLight", () => {
	it("turns with the viewer", () => {
		const light = new StageLight();
		const camera = new PerspectiveCamera();
		camera.position.set(5, 0, 0);
		camera.lookAt(0, 0, 0);
		camera.updateMatrixWorld();
		light.aim(camera);
		const { x, y, z } = rigOf("light").key.direction;
		// Seen from +X, the viewer's right is −Z, and +X is behind the viewer.
		expect(light.uniforms.keyDirection.value.distanceTo(new Vector3(z, y, -x))).toBeLessThan(1e-9);
	});

	it("stays where it is if its rig is fixed, while the rig in view space turns", () => {
		const light = new StageLight();
		light.setRig(outdoorRig("light"));
		const sun = outdoorRig("light").key.direction;
		const camera = new PerspectiveCamera();
		for (const [x, z] of [
			[5, 0],
			[0, -5],
		]) {
			camera.position.set(x, 1, z);
			camera.lookAt(0, 0, 0);
			camera.updateMatrixWorld();
			light.aim(camera);
			expect(light.uniforms.keyDirection.value.distanceTo(sun)).toBeLessThan(1e-9);
			const seen = light.rig.key.direction.clone().transformDirection(camera.matrixWorld);
			expect(seen.distanceTo(sun)).toBeLessThan(1e-9);
		}
	});

	it("uses the rig of its theme, in the shaders too", () => {
		const light = new StageLight();
		light.setRig(rigOf("dark"));
		expect(light.rig).toBe(rigOf("dark"));
		expect(light.uniforms.rim.value.irradiance.toArray()).toEqual(rigOf("dark").rim.irradiance);
	});
});

describe.each(["light", "dark"] as Theme[])("the shadow's lamp of the %s rig", (theme) => {
	it("is in front of the paper, on the key light's side and lower, so that the shadow falls away from it", () => {
		const rig = rigOf(theme);
		const shadow = new PaperShadow();
		shadow.setRig(rig);
		const lamp = shadow.uniforms.lamp.value;
		const key = rig.key.direction;
		expect(lamp.z).toBeGreaterThan(0.5);
		expect(Math.sign(lamp.x)).toBe(Math.sign(key.x));
		expect(lamp.y).toBeGreaterThan(0);
		expect(lamp.y).toBeLessThan(key.y);
		expect(shadow.uniforms.spread.value).toBe(spreadOf(rig.key));
	});
});
