import { Group, type Mesh } from "three";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { cutRenderer } from "../../../../web/src/models/root/cut_renderer";
import { model } from "../../../../web/src/models/root/index";
import { buildPit } from "../../../../web/src/models/root/soil";
import type { RootSpecimen } from "../../../../web/src/models/root/specimen";
import { PAPER } from "../../../../web/src/render/model_renderer";
import { PaperShadow } from "../../../../web/src/render/paper_shadow";
import { StageLight } from "../../../../web/src/render/stage_light";
import { windUniforms } from "../../../../web/src/render/wind_shader";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { decodeLink, encodeLink } from "../../../../web/src/specimen/link";
import { growBounded, particlesCore } from "../particles/boundary/particles";

let core: Core;
beforeAll(async () => {
	core = await particlesCore();
});
const grow = (specimen = fromPreset(model), options = {}) => growBounded(core, model.table, specimen, options);

describe("a root's presets", () => {
	it.each(model.presets.list.map(({ name }) => name))(
		"%s comes through its link and grows below ground without a note",
		async (name) => {
			const specimen = fromPreset(model, name);
			expect(await decodeLink(model, await encodeLink(model, specimen))).toEqual({ specimen, notes: [] });
			const plant = grow(specimen, { meshes: false });
			expect(plant.notes).toEqual([]);
			const heights = plant.segments.ends.filter((_, i) => i % 3 === 1);
			expect(heights.reduce((most, y) => Math.max(most, y))).toBeLessThan(1e-3);
			expect(heights.reduce((least, y) => Math.min(least, y))).toBeGreaterThan(-1.005 * specimen.parameters.reach);
			expect(model.summary(plant)).toMatch(/^[\d.]+ c?m deep, [\d,]+ root tips$/);
		},
	);
});

it("comes through its link to a millimetre of thickness, however fine", async () => {
	const specimen = fromPreset(model, "fibrous");
	specimen.parameters.girth = 0.7;
	const { specimen: back } = await decodeLink(model, await encodeLink(model, specimen));
	expect(back.parameters.girth).toBe(0.7);
	const { radii } = grow(back, { meshes: false }).segments;
	expect(2 * Math.max(...radii)).toBeCloseTo(0.007, 6);
});

describe("the pit about a root", () => {
	const bounds = { low: [-1, -2, -0.5], high: [1, 0, 0.5] } as const;

	it("holds the root, reaches up to the ground, and faces inwards", () => {
		const { positions, normals, indices } = buildPit(bounds, "5a4636");
		const along = (axis: number) => positions.filter((_, i) => i % 3 === axis);
		expect(Math.max(...along(0))).toBeGreaterThan(1);
		expect(Math.min(...along(1))).toBeLessThan(-2);
		expect(Math.max(...along(1))).toBeCloseTo(0);
		for (let i = 0; i < indices.length; i += 3) {
			const [a, b, c] = [0, 1, 2].map((k) => positions.subarray(3 * indices[i + k], 3 * indices[i + k] + 3));
			const [u, v] = [b, c].map((p) => [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
			const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
			const inwards = -normal[0] * a[0] - normal[1] * (a[1] + 1) - normal[2] * a[2];
			expect(inwards).toBeGreaterThan(-1e-9);
		}
		expect(normals).toHaveLength(positions.length);
	});

	it("is darker above than below", () => {
		const { positions, colours = new Float32Array() } = buildPit(bounds, "5a4636");
		const mean = (from: number, to: number) => {
			let [sum, count] = [0, 0];
			for (let i = 0; i < positions.length; i += 3) {
				if (positions[i + 1] < from || positions[i + 1] >= to) continue;
				sum += colours[i];
				count++;
			}
			return sum / count;
		};
		expect(mean(-0.12, 0)).toBeLessThan(0.7 * mean(-2, -1));
	});

	it("is drawn around the root, casts no shadow, and is removed with it", () => {
		const stage = {
			root: new Group(),
			light: new StageLight(),
			shadow: new PaperShadow(),
			wind: windUniforms(),
			setting: PAPER,
		};
		const figure = cutRenderer(stage);
		const specimen = fromPreset(model, "carrot");
		const plant = grow(specimen);
		figure.show(plant, specimen);
		figure.show(plant, specimen);
		const soil = stage.root.children.filter((child): child is Mesh => child.name === "Soil");
		expect(soil).toHaveLength(1);
		expect(soil[0].castShadow).toBe(false);
		// Files contain only the root.
		expect([...model.parts(plant, specimen)].map(({ name }) => name)).not.toContain("Soil");
		const { points } = figure.bounds();
		expect(points.length).toBeGreaterThan(3 * 1000);
		figure.dispose();
		expect(stage.root.children.filter((child) => "isMesh" in child)).toEqual([]);
	});

	it("is not dug anew while particles run, and is dug for the whole root when they rest", () => {
		const stage = {
			root: new Group(),
			light: new StageLight(),
			shadow: new PaperShadow(),
			wind: windUniforms(),
			setting: PAPER,
		};
		const figure = cutRenderer(stage);
		const at = (age: number, reach = 1) => {
			const specimen = fromPreset(model, "tap");
			const { parameters } = specimen;
			return { ...specimen, parameters: { ...parameters, particles: 300, age, reach: reach * parameters.reach } };
		};
		const pitOf = (specimen: RootSpecimen, preview: boolean) => {
			figure.show(grow(specimen, { preview }), specimen);
			return stage.root.children.find(({ name }) => name === "Soil");
		};
		const pits = [40, 100, 0, 41, 60, 100].map((age) => pitOf(at(age), age < 100));
		expect(pits[0]).toBeDefined();
		// Moving particles start within the bounds of the grown root.
		expect(new Set(pits).size).toBe(1);
		// The pit also holds a smaller root while it grows.
		expect(pitOf(at(60, 0.5), true) === pits[0]).toBe(true);
		expect(pitOf(at(100, 0.5), false) === pits[0]).toBe(false);
		pits[1] = pitOf(at(100), false);
		const young = at(40);
		figure.show(grow(young, { preview: true }), { ...young, look: { ...young.look, soil: "ffffff" } });
		expect(stage.root.children.find(({ name }) => name === "Soil") === pits[1]).toBe(false);
		figure.dispose();
	});
});
