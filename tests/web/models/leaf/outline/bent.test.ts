import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../../web/src/core/core";
import { model } from "../../../../../web/src/models/leaf/index";
import { bent } from "../../../../../web/src/models/leaf/outline/bent";
import { curveOf } from "../../../../../web/src/models/leaf/outline/spline";
import { leafFromPreset } from "../../../../../web/src/models/leaf/schema";
import type { LeafSpecimen } from "../../../../../web/src/models/leaf/specimen";
import { freshCore } from "../../../core/wasm";

let core: Core;
beforeAll(async () => {
	core = await freshCore("particles.wasm");
});

describe("an outline on its leaf", () => {
	it.each([
		[0, 0],
		[0, 60],
		[25, 0],
		[20, -45],
		[20, 90],
	])("lies at the margin of a leaf folded by %d° and curled by %d°", (fold, curl) => {
		const birch = leafFromPreset("birch");
		const specimen: LeafSpecimen = {
			...birch,
			parameters: { ...birch.parameters, fold, curl, undulation: 0, teeth: 0, particles: 100 },
		};
		const metres = specimen.parameters.length / 1000;
		const { meshes } = model.read(core.grow(model.encode(specimen)));
		const vertices = meshes.flatMap(({ positions }) =>
			Array.from({ length: positions.length / 3 }, (_, i) => positions.slice(3 * i, 3 * i + 3)),
		);
		for (const place of curveOf(specimen.outline, 2)) {
			const at = bent(place, { fold, curl }).at.map((value) => value * metres);
			const nearest = Math.min(...vertices.map(([x, y, z]) => Math.hypot(x - at[0], y - at[1], z - at[2])));
			expect(nearest / metres).toBeLessThan(0.025);
		}
	});

	it("moves right and up along its tangents", () => {
		const bend = { fold: 20, curl: 70 };
		const [x, y, little] = [-0.3, 0.6, 1e-5];
		const { at, along, stretch } = bent({ x, y }, bend);
		const moved = [bent({ x: x + little, y }, bend).at, bent({ x, y: y + little }, bend).at];
		for (const [i, stretched] of [1, stretch].entries())
			for (const k of [0, 1, 2]) expect((moved[i][k] - at[k]) / little).toBeCloseTo(along[i][k] * stretched, 3);
	});
});
