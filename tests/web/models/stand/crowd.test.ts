import { PerspectiveCamera } from "three";
import { beforeEach, expect, it } from "vitest";
import { Crowd } from "../../../../web/src/models/stand/figure/crowd";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import type { Material } from "../../../../web/src/plant/material";
import type { PackedMesh } from "../../../../web/src/plant/packed_mesh";
import type { LightUniforms } from "../../../../web/src/scene/light_shader";
import { grownStand, planned } from "./stands";

const LEVELS = [400_000, 30_000, 4000, 500];
const material: Material = { name: "Wood", colour: [0.4, 0.3, 0.2], roughness: 0.9 };
const mesh = (triangles: number): PackedMesh => ({
	unit: 1,
	positions: new Int16Array(9),
	normals: new Int8Array(9),
	sky: new Uint8Array(3),
	indices: new Uint16Array(3 * triangles),
});

/** Thirty plants close to each other, each heavy from near; some are nothing but a foot. */
async function standing(bare: number): Promise<StandPlant> {
	const stand = await grownStand(planned("ground 20 x 10\nplants 30, random\ngrowth/figure-5, crown 0.1 x 4: steps 1"));
	const levels = LEVELS.map((triangles) => [{ mesh: mesh(triangles), material }]);
	const members = stand.members.map((member, i) => {
		if (!member) throw new Error("it has not grown");
		return { ...member, levels: i < bare ? [] : levels, extent: { low: 0, high: 4, out: 2 } };
	});
	return { ...stand, members };
}

let camera: PerspectiveCamera;
const from = (z: number) => {
	camera.position.set(0, 2, z);
	camera.lookAt(0, 2, 0);
	camera.updateMatrixWorld();
	return camera;
};
beforeEach(() => {
	camera = new PerspectiveCamera(60, 1, 0.1, 10_000);
});

it("is as fine as may be in each view at once, whatever the view before was", async () => {
	const crowd = new Crowd({} as LightUniforms);
	const stand = await standing(0);
	crowd.show(stand);
	crowd.aim(from(4000));
	const far = crowd.triangles;
	expect(far).toBe(30 * 500);
	crowd.aim(from(5));
	const near = crowd.triangles;
	expect(near).toBeLessThanOrEqual(1_400_000);
	expect(near).toBeGreaterThan(200_000);
	const other = new Crowd({} as LightUniforms);
	other.show(stand);
	for (const each of [crowd, other]) each.aim(from(14));
	expect(crowd.triangles).toBe(other.triangles);
	other.dispose();
	crowd.aim(from(5));
	expect(crowd.triangles).toBe(near);
	crowd.dispose();
});

it("counts nothing of a plant that has nothing to draw, and draws the others", async () => {
	const crowd = new Crowd({} as LightUniforms);
	crowd.show(await standing(3));
	crowd.aim(from(4000));
	expect(crowd.triangles).toBe(27 * 500);
	crowd.mark(0);
	crowd.aim(from(4000));
	crowd.dispose();
});
