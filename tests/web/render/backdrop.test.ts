import { PerspectiveCamera, type ShaderMaterial, Texture, Vector3 } from "three";
import { expect, it } from "vitest";
import { Backdrop } from "../../../web/src/render/backdrop";
import { rigOf } from "../../../web/src/render/light";

const camera = new PerspectiveCamera(50, 1.5);
const backdrop = new Backdrop(new Texture());
const { uniforms } = backdrop.mesh.material as ShaderMaterial;

/** Height of a position in the view over the horizon, as in the shader: 0 level, 1 overhead. */
function high(x: number, y: number): number {
	const { sight, rise } = uniforms;
	return rise.value.dot(new Vector3(x, y, 1)) / Math.hypot(sight.value.x * x, sight.value.y * y, 1);
}

it("the sky has the camera's elevation at every position of the view", () => {
	camera.position.set(3, 1, 2);
	camera.lookAt(8, 4, -1);
	camera.updateMatrixWorld();
	backdrop.setSky(camera);
	expect(uniforms.sky.value).toBe(1);
	for (const [x, y] of [
		[0, 0],
		[-1, 1],
		[0.7, -0.9],
	]) {
		const ray = new Vector3(x, y, 0.5).unproject(camera).sub(camera.position).normalize();
		expect(high(x, y)).toBeCloseTo(ray.y, 5);
	}
});

it("cut-out pictures, and cameras outside the plant, have no sky", () => {
	backdrop.setFlat(0);
	backdrop.setSky(camera);
	expect(uniforms.sky.value).toBe(0);
	backdrop.setRig(rigOf("dark"));
	backdrop.setSky(camera);
	expect(uniforms.sky.value).toBe(1);
	backdrop.setSky(undefined);
	expect(uniforms.sky.value).toBe(0);
});
