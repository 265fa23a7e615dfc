/** A stand on the stage: its light, as who turns it and who walks in it have it. */
import { Group, PerspectiveCamera } from "three";
import { expect, it } from "vitest";
import { StandFigure } from "../../../../web/src/models/stand/figure/stand_figure";
import { atFront, gazeOf, turned } from "../../../../web/src/models/stand/walker";
import type { FigureStage } from "../../../../web/src/scene/figure";
import { StageLight } from "../../../../web/src/scene/stage_light";
import { windUniforms } from "../../../../web/src/scene/wind";
import { grownStand, planned } from "./stands";

it("is turned in the light, and walked through under a sun that stays", async () => {
	const specimen = planned("ground 40 x 40\nplants 3, random\ngrowth/figure-5, crown 1 x 4: steps 1");
	const stand = await grownStand(specimen, { meshes: true });
	const light = new StageLight();
	const stage = { root: new Group(), light, wind: windUniforms() } as unknown as FigureStage;
	const figure = new StandFigure(stage);
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
