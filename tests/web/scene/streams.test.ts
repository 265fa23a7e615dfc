import { BufferGeometry } from "three";
import { describe, expect, it } from "vitest";
import { fillStreams } from "../../../web/src/scene/streams";

const content = (vertices: number) =>
	[["position", Float32Array.from({ length: 3 * vertices }, (_, i) => i), 3]] as const;

describe("fillStreams", () => {
	it("keeps its buffers while they are large enough, and draws no more than it was given", () => {
		const geometry = new BufferGeometry();
		fillStreams(geometry, content(12), new Uint32Array(30));
		const { position } = geometry.attributes;
		const { index } = geometry;
		fillStreams(geometry, content(18), new Uint32Array(45));
		fillStreams(geometry, content(4), new Uint32Array(6));
		expect(geometry.attributes.position).toBe(position);
		expect(geometry.index).toBe(index);
		expect(geometry.drawRange).toEqual({ start: 0, count: 6 });
		expect([...position.array].slice(0, 12)).toEqual([...content(4)[0][1]]);
	});

	it("has bytes read as shares of 255", () => {
		const geometry = new BufferGeometry();
		fillStreams(geometry, [...content(4), ["sky", Uint8Array.from([0, 51, 255, 102]), 1]], new Uint32Array(6));
		const { sky } = geometry.attributes;
		expect([sky.normalized, sky.array.BYTES_PER_ELEMENT]).toEqual([true, 1]);
		expect([0, 1, 2].map((i) => sky.getX(i))).toEqual([0, 0.2, 1]);
	});

	it("takes new ones with room to spare where they are not, and lets go of the old", () => {
		const geometry = new BufferGeometry();
		fillStreams(geometry, content(4), new Uint32Array(6));
		let disposed = 0;
		geometry.addEventListener("dispose", () => disposed++);
		fillStreams(geometry, content(40), new Uint32Array(60));
		expect(disposed).toBe(1);
		expect(geometry.attributes.position.count).toBe(60);
	});
});
