import { type BufferGeometry, type Mesh, PerspectiveCamera, Vector3 } from "three";
import { expect, it } from "vitest";
import { MarkRing } from "../../../../web/src/models/stand/figure/mark_ring";
import { grownStand } from "./stands";

it("lies about the plant on the ground, as wide in the view from near and from far, and goes with the mark", async () => {
	const stand = await grownStand(undefined, { meshes: true });
	const ring = new MarkRing();
	expect(ring.object.visible).toBe(false);
	ring.show(stand, 2);
	expect(ring.object.visible).toBe(true);
	const { places } = stand;
	const foot = new Vector3().fromArray(places.at, 6);
	const camera = new PerspectiveCamera(24, 1, 0.1, 1000);
	const rays = (distance: number) => {
		camera.position.copy(foot).add(new Vector3(0, distance, 0));
		ring.aim(camera);
		const { geometry } = ring.object.children[0] as Mesh<BufferGeometry>;
		const at = geometry.getAttribute("position");
		const far = Array.from({ length: at.count }, (_, v) => Math.hypot(at.getX(v) - foot.x, at.getZ(v) - foot.z));
		return { least: Math.min(...far), most: Math.max(...far), high: at.getY(0) - foot.y };
	};
	const [near, far] = [rays(10), rays(40)];
	expect((far.most - far.least) / (near.most - near.least)).toBeCloseTo(4, 2);
	expect(near.least).toBeGreaterThan(0.25 * stand.kinds[places.kind[2]].crown.width * places.scale[2]);
	expect(Math.abs(near.high)).toBeLessThan(0.5);
	ring.show(stand, undefined);
	expect(ring.object.visible).toBe(false);
	ring.dispose();
});
