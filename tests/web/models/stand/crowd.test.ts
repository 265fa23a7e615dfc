import { BatchedMesh, PerspectiveCamera, type Vector4 } from "three";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Crowd, stemOf } from "../../../../web/src/models/stand/render/crowd";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import type { Material } from "../../../../web/src/plant/material";
import type { PackedMesh } from "../../../../web/src/plant/packed_mesh";
import type { LightUniforms } from "../../../../web/src/render/light_shader";
import type { WindUniforms } from "../../../../web/src/render/wind_shader";
import { grownStand, PLAN, planned } from "./stands";

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
async function standing(bare: number, many = 30): Promise<StandPlant> {
	const plan = `ground 20 x 10\nplants ${many}, random\ngrowth/figure-5, crown 0.1 x 4: steps 1`;
	const stand = await grownStand(planned(plan));
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

it("has the finest permitted levels in each view, independently of the view before", async () => {
	const crowd = new Crowd({} as LightUniforms, {} as WindUniforms);
	const stand = await standing(0);
	crowd.show(stand);
	crowd.aim(from(4000));
	const far = crowd.triangles;
	expect(far).toBe(30 * 500);
	crowd.aim(from(5));
	const near = crowd.triangles;
	expect(near).toBeLessThanOrEqual(1_400_000);
	expect(near).toBeGreaterThan(200_000);
	const other = new Crowd({} as LightUniforms, {} as WindUniforms);
	other.show(stand);
	for (const each of [crowd, other]) each.aim(from(14));
	expect(crowd.triangles).toBe(other.triangles);
	other.dispose();
	crowd.aim(from(5));
	expect(crowd.triangles).toBe(near);
	crowd.dispose();
});

it("does not count plants without meshes, and draws the others", async () => {
	const crowd = new Crowd({} as LightUniforms, {} as WindUniforms);
	crowd.show(await standing(3));
	crowd.aim(from(4000));
	expect(crowd.triangles).toBe(27 * 500);
	crowd.mark(0);
	crowd.aim(from(4000));
	crowd.dispose();
});

/** Number of plants whose appearance was changed. */
const given = () => {
	const spy = vi.spyOn(BatchedMesh.prototype, "setColorAt");
	return () => spy.mock.calls.length;
};
afterEach(() => void vi.restoreAllMocks());

it("does no work for an unchanged view, and updates only changed plants", async () => {
	const crowd = new Crowd({} as LightUniforms, {} as WindUniforms);
	crowd.show(await standing(0));
	crowd.aim(from(4000));
	const count = given();
	crowd.aim(camera);
	crowd.aim(from(4001));
	expect(count()).toBe(0);
	crowd.mark(3);
	expect(count()).toBe(1);
	crowd.aim(from(14));
	expect(count()).toBeGreaterThan(20);
	crowd.dispose();
});

interface Drawn {
	visible: boolean;
	red: number;
	share: number;
}

/** The drawn instances of each batch, recorded from the calls: all batches share one object for colours. */
function noted(): Map<BatchedMesh, Drawn[]> {
	const batches = new Map<BatchedMesh, Drawn[]>();
	const of = (batch: BatchedMesh, id: number): Drawn => {
		const all = batches.get(batch) ?? [];
		batches.set(batch, all);
		all[id] ??= { visible: true, red: 0, share: 1 };
		return all[id];
	};
	vi.spyOn(BatchedMesh.prototype, "setColorAt").mockImplementation(function (this: BatchedMesh, id, colour) {
		Object.assign(of(this, id), { red: (colour as Vector4).x, share: (colour as Vector4).w });
		return this;
	});
	vi.spyOn(BatchedMesh.prototype, "setVisibleAt").mockImplementation(function (this: BatchedMesh, id, visible) {
		of(this, id).visible = visible;
		return this;
	});
	return batches;
}

it("has one of two levels that share a plant always whole, so that its stem has no holes", async () => {
	const batches = noted();
	const crowd = new Crowd({} as LightUniforms, {} as WindUniforms);
	crowd.show(await standing(0));
	let shared = 0;
	for (let z = 14; z < 140; z += 2) {
		crowd.aim(from(z));
		for (const all of batches.values()) {
			expect(all).toHaveLength(2 * 30);
			for (let slot = 0; slot < all.length; slot += 2) {
				const shares = [all[slot], all[slot + 1]].filter(({ visible }) => visible).map(({ share }) => share);
				expect(Math.max(...shares)).toBe(1);
				if (Math.min(...shares) < 1) shared++;
			}
		}
	}
	expect(batches.size).toBe(1);
	expect(shared).toBeGreaterThan(20);
	crowd.dispose();
});

it("draws invisible plants by their last level, for their shadows, without counting them", async () => {
	const visible = vi.spyOn(BatchedMesh.prototype, "setVisibleAt");
	const crowd = new Crowd({} as LightUniforms, {} as WindUniforms);
	crowd.show(await standing(0));
	visible.mockClear();
	camera.position.set(0, 2, 100);
	camera.lookAt(0, 2, 200);
	camera.updateMatrixWorld();
	crowd.aim(camera);
	expect(crowd.triangles).toBe(0);
	expect(visible.mock.calls.filter(([, shown]) => shown)).toHaveLength(30);
	crowd.dispose();
});

it("releases data that the GPU has, and rebuilds it after a loss of context", async () => {
	const crowd = new Crowd({} as LightUniforms, {} as WindUniforms);
	const stand = await standing(0);
	crowd.show(stand);
	const lengths = () =>
		crowd.group.children.map((each) => (each as BatchedMesh).geometry.getAttribute("position").array.length);
	const whole = lengths();
	for (const { geometry } of crowd.group.children as BatchedMesh[])
		for (const each of [...Object.values(geometry.attributes), geometry.index])
			(each as unknown as { onUploadCallback(): void }).onUploadCallback();
	expect(lengths()).toEqual([0]);
	crowd.restored(stand);
	expect(lengths()).toEqual(whole);
	expect(whole[0]).toBeGreaterThan(0);
	crowd.dispose();
});

it("restores the highlight after a loss of context", async () => {
	const batches = noted();
	const crowd = new Crowd({} as LightUniforms, {} as WindUniforms);
	const stand = await standing(0);
	crowd.show(stand);
	crowd.aim(from(14));
	crowd.mark(3);
	batches.clear();
	crowd.restored(stand);
	crowd.aim(camera);
	const reds = [...batches.values()].flat().flatMap(({ visible, red }) => (visible ? [red] : []));
	expect(new Set(reds)).toEqual(new Set([material.colour[0], 1.9 * material.colour[0]]));
	crowd.dispose();
});

it("sways attached plants with their parent, and others about their own base", async () => {
	const { places, kinds } = await grownStand(planned(PLAN));
	const size = (plant: number, crown: number) => places.scale[plant] * crown;
	expect(stemOf(places, kinds, 0)).toEqual([0, 0, 0, size(0, 8)]);
	const [x, y, z, large] = stemOf(places, kinds, 12);
	const foot = [...places.at.subarray(27, 30)];
	expect(places.parent[12]).toBe(9);
	for (const [i, off] of [x, y, z].entries()) expect(places.at[36 + i] + off).toBeCloseTo(foot[i], 5);
	expect(large).toBe(size(9, 6));
});

it("shows the nearest of very many members by their finest level, and releases it afterwards", async () => {
	const crowd = new Crowd({} as LightUniforms, {} as WindUniforms);
	crowd.show(await standing(0, 260));
	crowd.aim(from(4000));
	const far = crowd.group.children.length;
	const vertices = () => crowd.group.children.map((each) => (each as BatchedMesh).geometry.getIndex()?.count ?? 0);
	expect(Math.max(...vertices().slice(far))).toBe(-Infinity);
	crowd.aim(from(5));
	const near = vertices().slice(far);
	expect(near).toHaveLength(12);
	expect(near.every((corners) => corners === 3 * LEVELS[0])).toBe(true);
	crowd.aim(from(4.9));
	expect(crowd.group.children.length - far).toBe(12);
	crowd.aim(from(4000));
	expect(crowd.group.children).toHaveLength(far);
	crowd.dispose();
});
