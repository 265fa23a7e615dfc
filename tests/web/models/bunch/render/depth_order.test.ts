import { describe, expect, it } from "vitest";
import { DepthOrder } from "../../../../../web/src/models/bunch/render/depth_order";

const spheres = Float32Array.from([0, 0, 5, 1, 0, 0, -3, 1, 4, 0, 0, 1]);

describe("DepthOrder", () => {
	it("puts the nearest to the eye first", () => {
		const order = new DepthOrder();
		order.reset(spheres);
		order.sort({ x: 0, y: 0, z: 10 });
		expect(order.indices).toEqual([0, 2, 1]);
		order.sort({ x: 0, y: 0, z: -10 });
		expect(order.indices).toEqual([1, 2, 0]);
	});

	it("sorts again only for another eye or other spheres", () => {
		const order = new DepthOrder();
		order.reset(spheres);
		expect([order.sort({ x: 0, y: 0, z: 10 }), order.sort({ x: 0, y: 0, z: 10 })]).toEqual([true, false]);
		expect(order.sort({ x: 0, y: 0, z: 11 })).toBe(true);
		order.reset(spheres.slice());
		expect(order.sort({ x: 0, y: 0, z: 11 })).toBe(true);
	});

	it("knows each thing once, however many there were before", () => {
		const order = new DepthOrder();
		order.reset(spheres);
		order.sort({ x: 0, y: 0, z: -10 });
		order.reset(spheres.subarray(0, 8));
		order.sort({ x: 0, y: 0, z: 0 });
		expect(order.indices).toEqual([1, 0]);
	});
});
