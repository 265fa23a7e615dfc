import { expect, it } from "vitest";
import { finerGround } from "../../../../web/src/models/stand/finer_ground";

it("has more cells, and keeps an open sky fully open", () => {
	const { mesh, grid } = finerGround({
		positions: Float32Array.of(-1, 0, -1, 1, 0, -1, -1, 0, 1, 1, 2, 1),
		normals: Float32Array.of(0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0),
		uvs: new Float32Array(8),
		indices: Uint32Array.of(0, 2, 1, 1, 2, 3),
		sky: Uint8Array.of(255, 255, 254, 254),
	});
	expect(grid).toEqual({ across: 28, deep: 28 });
	expect(mesh.indices).toHaveLength(6 * 28 * 28);
	// Values are rounded to the nearer row, otherwise one row would cover all but the last row.
	const rows = Array.from({ length: 29 }, (_, row) => mesh.sky?.[29 * row + 3]);
	expect(rows).toEqual(rows.map((_, row) => (row <= 14 ? 255 : 254)));
	for (let v = 0; v < mesh.normals.length; v += 3)
		expect(Math.hypot(...mesh.normals.subarray(v, v + 3))).toBeCloseTo(1, 6);
	expect(mesh.positions[3 * (29 * 14 + 14) + 1]).toBeCloseTo(0.5, 6);
});
