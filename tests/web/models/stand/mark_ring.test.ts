import { type BufferAttribute, type BufferGeometry, type Mesh, PerspectiveCamera, Vector3 } from "three";
import { beforeAll, expect, it } from "vitest";
import { heightAt } from "../../../../web/src/models/stand/ground_grid";
import { MarkRing } from "../../../../web/src/models/stand/render/mark_ring";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import { grownStand } from "./stands";

/** A plant on a slope, and one attached to another plant above the ground. */
const STANDING = 2;
const ATTACHED = 12;

let stand: StandPlant;
beforeAll(async () => {
	stand = await grownStand(undefined, { meshes: true });
}, 300_000);

const placesOf = (ring: MarkRing) =>
	(ring.object.children[0] as Mesh<BufferGeometry>).geometry.getAttribute("position") as BufferAttribute;

/** Positions of a ring's vertices relative to a plant, seen from above. */
function vertices(ring: MarkRing, plant: number, distance: number) {
	const camera = new PerspectiveCamera(24, 1, 0.1, 1000);
	const foot = new Vector3().fromArray(stand.places.at, 3 * plant);
	camera.position.copy(foot).add(new Vector3(0, distance, 0));
	ring.aim(camera);
	const at = placesOf(ring);
	const all = Array.from({ length: at.count }, (_, v) => new Vector3().fromBufferAttribute(at, v));
	const far = all.map(({ x, z }) => Math.hypot(x - foot.x, z - foot.z));
	const high = 2 * distance * Math.tan((24 * Math.PI) / 360);
	return { all, foot, high, least: Math.min(...far), most: Math.max(...far) };
}

it("is on the ground around the plant, with a constant width on the screen, and disappears with the mark", () => {
	const ring = new MarkRing();
	expect(ring.object.visible).toBe(false);
	ring.show(stand, STANDING);
	expect(ring.object.visible).toBe(true);
	const [near, far] = [10, 40].map((distance) => vertices(ring, STANDING, distance));
	expect((far.most - far.least) / (near.most - near.least)).toBeCloseTo(4, 2);
	const crown = stand.kinds[stand.places.kind[STANDING]].crown.width * stand.places.scale[STANDING];
	expect(near.least).toBeGreaterThan(0.25 * crown);
	for (const { all, high } of [near, far])
		for (const { x, y, z } of all) {
			const over = y - heightAt(stand, x, z);
			expect(over).toBeGreaterThan(0);
			expect(over).toBeLessThan(0.005 * high);
		}
	// The ground around the plant is not a plane.
	const heights = near.all.map(({ x, z }) => heightAt(stand, x, z));
	expect(Math.max(...heights) - Math.min(...heights)).toBeGreaterThan(0.02 * near.high);
	ring.show(stand, undefined);
	expect(ring.object.visible).toBe(false);
	ring.dispose();
});

it("has a visible size around the smallest crown", () => {
	const ring = new MarkRing();
	const kinds = stand.kinds.map((kind) => ({ ...kind, crown: { width: 0.001, height: 0.001 } }));
	ring.show({ ...stand, kinds }, STANDING);
	for (const distance of [10, 40]) {
		const { least, most, high } = vertices(ring, STANDING, distance);
		expect(most).toBeGreaterThan(0.015 * high);
		expect(least).toBeGreaterThan(0.01 * high);
		expect(most).toBeLessThan(0.03 * high);
	}
	ring.dispose();
});

it("is level around a hanging plant", () => {
	const ring = new MarkRing();
	ring.show(stand, ATTACHED);
	const { all, foot, high } = vertices(ring, ATTACHED, 10);
	expect(foot.y - heightAt(stand, foot.x, foot.z)).toBeGreaterThan(1);
	for (const { y } of all) {
		expect(y - foot.y).toBeGreaterThan(0);
		expect(y - foot.y).toBeLessThan(0.005 * high);
	}
	ring.dispose();
});

it("is rebuilt for another camera position, angle, plant or stand, and only then", () => {
	const ring = new MarkRing();
	const camera = new PerspectiveCamera(24, 1, 0.1, 1000);
	camera.position.set(0, 10, 0);
	const { version } = placesOf(ring);
	/** Number of times that the ring was built. */
	const aimed = () => {
		ring.aim(camera);
		return placesOf(ring).version - version;
	};
	ring.show(stand, STANDING);
	expect([aimed(), aimed()]).toEqual([1, 1]);
	ring.show(stand, STANDING);
	camera.rotateY(1);
	expect(aimed()).toBe(1);
	camera.position.x++;
	expect(aimed()).toBe(2);
	camera.fov++;
	expect(aimed()).toBe(3);
	ring.show(stand, ATTACHED);
	expect(aimed()).toBe(4);
	ring.show({ ...stand }, ATTACHED);
	expect(aimed()).toBe(5);
	ring.dispose();
});
