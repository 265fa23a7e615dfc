import { describe, expect, it } from "vitest";
import { DepthOrder } from "../../../../../web/src/models/bunch/figure/depth_order";

const spheres = Float32Array.from([0, 0, 5, 1, 0, 0, -3, 1, 4, 0, 0, 1]);

describe("DepthOrder", () => {
	it("puts the nearest to the eye first", () => {
		const order = new DepthOrder();
		order.reset(3);
		expect([...order.sorted(spheres, { x: 0, y: 0, z: 10 })]).toEqual([0, 2, 1]);
		expect([...order.sorted(spheres, { x: 0, y: 0, z: -10 })]).toEqual([1, 2, 0]);
	});

	it("knows each thing once, however many there were before", () => {
		const order = new DepthOrder();
		order.reset(3);
		order.sorted(spheres, { x: 0, y: 0, z: -10 });
		order.reset(2);
		expect([...order.sorted(spheres, { x: 0, y: 0, z: 0 })]).toEqual([1, 0]);
		expect(order.count).toBe(2);
	});
});
