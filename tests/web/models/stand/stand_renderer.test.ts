/** Light on a stand while orbiting and while walking. */
import { BatchedMesh, Group, type Mesh, type Object3D, PerspectiveCamera, type Vector4 } from "three";
import { afterEach, expect, it, vi } from "vitest";
import { StandRenderer } from "../../../../web/src/models/stand/render/stand_renderer";
import { atFront, gazeOf, turned } from "../../../../web/src/models/stand/walker";
import type { RendererStage } from "../../../../web/src/render/model_renderer";
import { PAPER } from "../../../../web/src/render/model_renderer";
import { StageLight } from "../../../../web/src/render/stage_light";
import { windUniforms } from "../../../../web/src/render/wind_shader";
import { grownStand, planned } from "./stands";

function staged() {
	const light = new StageLight();
	return {
		light,
		stage: { root: new Group(), light, wind: windUniforms(), setting: PAPER } as unknown as RendererStage,
	};
}

afterEach(() => void vi.restoreAllMocks());

it("keeps the light fixed to the camera while orbiting and to the stand while walking", async () => {
	const specimen = planned("ground 40 x 40\nplants 3, random\ngrowth/figure-5, crown 1 x 4: steps 1");
	const stand = await grownStand(specimen, { meshes: true });
	const { stage, light } = staged();
	const figure = new StandRenderer(stage);
	figure.show(stand, specimen);
	const camera = new PerspectiveCamera();
	const sunFrom = (eye: readonly number[], towards: readonly number[]) => {
		camera.position.fromArray([...eye]);
		camera.lookAt(towards[0], towards[1], towards[2]);
		camera.updateMatrixWorld();
		light.aim(camera);
		figure.prepare(camera);
		return light.uniforms.keyDirection.value.clone();
	};
	const far = [sunFrom([60, 30, 0], [0, 0, 0]), sunFrom([0, 30, 60], [0, 0, 0])];
	expect(figure.within).toBe(false);
	expect(far[0].distanceTo(far[1])).toBeGreaterThan(0.3);
	const walking = [0, 90, 180].map((right) => {
		const { eye, towards } = gazeOf(turned(atFront(stand), right, 0), stand);
		return sunFrom(eye, towards);
	});
	expect(figure.within).toBe(true);
	for (const sun of walking) expect(sun.distanceTo(walking[0])).toBeLessThan(1e-9);
	expect(sunFrom([60, 30, 0], [0, 0, 0]).distanceTo(far[0])).toBeLessThan(1e-9);
	expect(figure.sway()?.height).toBeGreaterThan(1);
	figure.dispose();
});

it("is shown unmarked, on a ground that reuses the last one's material", async () => {
	const specimen = planned("ground 40 x 40\nplants 3, random\ngrowth/figure-5, crown 1 x 4: steps 1");
	const stand = await grownStand(specimen, { meshes: true });
	const { stage } = staged();
	const figure = new StandRenderer(stage);
	const worn = () => {
		const found: unknown[] = [];
		stage.root.traverse((each: Object3D) => {
			if (each.name === "Ground") found.push((each as Mesh).material);
		});
		return found;
	};
	figure.show(stand, specimen);
	figure.prepare(new PerspectiveCamera());
	const before = worn();
	expect(before).toHaveLength(1);
	/** Brightness of the plants when last drawn: all batches share one object for colours. */
	const reds = new Map<BatchedMesh, Map<number, number>>();
	vi.spyOn(BatchedMesh.prototype, "setColorAt").mockImplementation(function (this: BatchedMesh, id, colour) {
		const own = reds.get(this) ?? new Map<number, number>();
		reds.set(this, own.set(id, (colour as Vector4).x));
		return this;
	});
	const brightest = () => Math.max(...[...reds.values()].flatMap((own) => [...own.values()]));
	figure.mark(1);
	const marked = brightest();
	figure.show(stand, { ...specimen, look: { ...specimen.look, soil: "a03020" } });
	expect(brightest()).toBeCloseTo(marked / 1.9, 6);
	expect(worn()).toEqual(before);
	figure.mark(1);
	expect(brightest()).toBe(marked);
	figure.dispose();
	expect(worn()).toEqual([]);
});
