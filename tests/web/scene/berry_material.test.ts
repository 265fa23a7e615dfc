import { describe, expect, it } from "vitest";
import { capMesh } from "../../../web/src/scene/berry_material";

describe("capMesh", () => {
	const { positions, indices } = capMesh();
	const flat = (i: number): [number, number] => {
		const angle = 2 * Math.PI * positions[3 * i];
		return [positions[3 * i + 1] * Math.cos(angle), positions[3 * i + 1] * Math.sin(angle)];
	};

	it("covers the disc once, every triangle facing the eye", () => {
		let area = 0;
		for (let t = 0; t < indices.length; t += 3) {
			const [a, b, c] = [flat(indices[t]), flat(indices[t + 1]), flat(indices[t + 2])];
			const twice = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
			expect(twice).toBeGreaterThan(0);
			area += twice / 2;
		}
		const rim = Array.from({ length: positions.length / 3 }, (_, i) => i).filter(
			(i) => positions[3 * i + 1] === 1,
		).length;
		expect(area).toBeCloseTo((rim / 2) * Math.sin((2 * Math.PI) / rim), 5);
	});

	it("has no seam: every inner edge is shared by two triangles", () => {
		const edges = new Map<string, number>();
		for (let t = 0; t < indices.length; t += 3) {
			for (let k = 0; k < 3; k++) {
				const [a, b] = [indices[t + k], indices[t + ((k + 1) % 3)]];
				const edge = `${Math.min(a, b)}-${Math.max(a, b)}`;
				edges.set(edge, (edges.get(edge) ?? 0) + 1);
			}
		}
		const open = [...edges].filter(([, uses]) => uses === 1);
		for (const [edge] of open) for (const end of edge.split("-")) expect(positions[3 * Number(end) + 1]).toBe(1);
		expect([...edges.values()].every((uses) => uses <= 2)).toBe(true);
	});
});
