/** The light in a crown's cells (Rodkaew et al. 2003, figure 8) as points of the 3-D view. */
import { beforeAll, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { model } from "../../../../web/src/models/tree/index";
import { lightPoints } from "../../../../web/src/models/tree/light/light_grid";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { particlesCore } from "../particles/boundary/particles";

let core: Core;
beforeAll(async () => {
	core = await particlesCore();
	await model.prepare(fromPreset(model));
});

const grow = (options: object) => {
	const specimen = fromPreset(model, "sphere");
	const small = { ...specimen, parameters: { ...specimen.parameters, particles: 120 } };
	return model.read(core.grow(model.encode(small, options)), small);
};

it("comes with every tree except in a preview, as wide as the crown", () => {
	const { light } = grow({ meshes: false });
	if (!light) throw new Error("no light");
	const [x, y, z] = light.counts;
	expect(light.cells).toHaveLength(x * y * z);
	expect(light.low[0]).toBeLessThan(-1.99);
	expect(light.low[0] + x * light.edge).toBeGreaterThan(1.99);
	expect(grow({ meshes: false, preview: true }).light).toBeUndefined();
});

it("is a point in the middle of each cell: dark where little light comes, and seen through where much does", () => {
	const cells = Uint8Array.from([0, 255, 128, 0, 0, 0, 0, 64]);
	const { positions, colours } = lightPoints({ cells, counts: [2, 2, 2], low: [-1, 0, -1], edge: 1 });
	expect([...positions.subarray(0, 6)]).toEqual([-0.5, 0.5, -0.5, 0.5, 0.5, -0.5]);
	expect([...positions.subarray(21)]).toEqual([0.5, 1.5, 0.5]);
	const opacity = (i: number) => colours[4 * i + 3];
	expect(opacity(0)).toBeGreaterThan(opacity(2));
	expect(opacity(2)).toBeGreaterThan(opacity(1));
	expect(colours[4]).toBeGreaterThan(colours[0]);
});
