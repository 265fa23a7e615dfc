import { type BufferAttribute, BufferGeometry, type InstancedBufferAttribute, InstancedBufferGeometry } from "three";
import { describe, expect, it } from "vitest";
import { fillInstances, fillStreams } from "../../../web/src/render/streams";

const content = (vertices: number) =>
	[["position", Float32Array.from({ length: 3 * vertices }, (_, i) => i), 3]] as const;

describe("fillStreams", () => {
	it("reuses buffers that are large enough, and draws only the given content", () => {
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

	it("uploads only new content to the GPU", () => {
		const geometry = new BufferGeometry();
		fillStreams(geometry, content(12), new Uint32Array(30));
		const position = geometry.attributes.position as BufferAttribute;
		const sent = [position.version, geometry.index?.version ?? 0];
		fillStreams(geometry, content(4), new Uint32Array(6));
		expect(position.version).toBe(sent[0] + 1);
		expect(geometry.index?.version).toBe(sent[1] + 1);
		expect(position.updateRanges).toEqual([{ start: 0, count: 12 }]);
	});

	it("does the same for instances", () => {
		const geometry = new InstancedBufferGeometry();
		fillInstances(geometry, "place", [1, 2, 3, 4], 2);
		const place = geometry.attributes.place as InstancedBufferAttribute;
		const { version } = place;
		fillInstances(geometry, "place", [5, 6], 2);
		expect(geometry.attributes.place).toBe(place);
		expect(place.version).toBe(version + 1);
		expect([...place.array].slice(0, 2)).toEqual([5, 6]);
		fillInstances(
			geometry,
			"place",
			Array.from({ length: 40 }, (_, i) => i),
			2,
		);
		expect(geometry.attributes.place.getY(19)).toBe(39);
	});

	it("reads bytes as shares of 255", () => {
		const geometry = new BufferGeometry();
		fillStreams(geometry, [...content(4), ["sky", Uint8Array.from([0, 51, 255, 102]), 1]], new Uint32Array(6));
		const { sky } = geometry.attributes;
		expect([sky.normalized, sky.array.BYTES_PER_ELEMENT]).toEqual([true, 1]);
		expect([0, 1, 2].map((i) => sky.getX(i))).toEqual([0, 0.2, 1]);
	});

	it("allocates larger buffers when needed, and disposes of the old ones", () => {
		const geometry = new BufferGeometry();
		fillStreams(geometry, content(4), new Uint32Array(6));
		let disposed = 0;
		geometry.addEventListener("dispose", () => disposed++);
		fillStreams(geometry, content(40), new Uint32Array(60));
		expect(disposed).toBe(1);
		expect(geometry.attributes.position.count).toBe(60);
	});
});
