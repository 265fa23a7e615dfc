import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { aboutPlant } from "../../../../web/src/formats/about_plant";
import { exportGlb } from "../../../../web/src/formats/glb";
import { model } from "../../../../web/src/models/tree/index";
import type { TreeSpecimen } from "../../../../web/src/models/tree/specimen";
import { linear, toLch } from "../../../../web/src/plant/colour";
import { leafColour, leafTints } from "../../../../web/src/plant/leaf_colours";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { decodeQuery } from "../../../../web/src/specimen/link";
import { restore } from "../../../../web/src/specimen/restore";
import { documentOf } from "../../formats/reading";
import { particlesCore } from "../particles/boundary/particles";

let core: Core;
beforeAll(async () => {
	core = await particlesCore();
	await Promise.all(model.presets.list.map(({ name }) => model.prepare(fromPreset(model, name))));
});
const grow = (specimen: TreeSpecimen, options = {}) => model.read(core.grow(model.encode(specimen, options)), specimen);
const oak = fromPreset(model);
/** The fewest particles that make a tree. */
const small = (specimen = oak, parameters = {}) => ({
	...specimen,
	parameters: { ...specimen.parameters, particles: 120, ...parameters },
});

/** Six hexadecimal digits of a pixel. */
const hexadecimal = (pixels: ArrayLike<number>, at: number) =>
	[0, 1, 2].map((k) => pixels[at + k].toString(16).padStart(2, "0")).join("");

describe("leaves of a tree", () => {
	it("has the leaf of its kind, with veins in the colours of each tint, in files as in the view", async () => {
		const kinds = model.table.entry("leaf_kind");
		const options = kinds?.kind === "choice" ? kinds.options : [];
		expect(options).toContain("needle");
		const outlines = new Set<number>();
		for (const [kind, name] of options.entries()) {
			const specimen = small(oak, { leaf_kind: kind });
			await model.prepare(specimen);
			const plant = grow(specimen);
			expect(plant.notes).toEqual([]);
			const leaves = [...model.parts(plant, specimen)].slice(1).flatMap(({ shape }) => shape ?? []);
			expect(new Set(leaves.map(({ mesh }) => mesh)).size).toBe(1);
			outlines.add(leaves[0].mesh.positions.length);
			const pictures = leaves.flatMap(({ material }) => material.textures?.colour ?? []);
			if (name === "needle") {
				expect(pictures).toEqual([]);
				continue;
			}
			expect(plant.veins?.side).toBe(64);
			expect(new Set(pictures).size).toBe(6);
			for (const { mesh, material } of leaves) {
				const { pixels = [], width = 0 } = material.textures?.colour ?? {};
				const [u, v] = [mesh.uvs[0], mesh.uvs[1]];
				const at = 3 * (Math.min(width - 1, Math.floor(v * width) - 1) * width + Math.floor(u * width));
				// The midrib is paler than the blade beside the veins.
				expect(linear(hexadecimal(pixels, at))[1]).toBeGreaterThan(1.2 * material.colour[1]);
				expect(linear(hexadecimal(pixels, 0))[1]).toBeCloseTo(material.colour[1], 2);
			}
		}
		expect(outlines.size).toBeGreaterThan(4);
	});

	it("has a few meshes of all its many leaves in files, as large as they are", async () => {
		const specimen = small();
		const plant = grow(specimen);
		const count = plant.counts.leaves;
		expect(count).toBeGreaterThan(300);
		const {
			nodes,
			meshes = [],
			accessors = [],
		} = documentOf(exportGlb(model.parts(plant, specimen), await aboutPlant(model, plant, specimen)));
		const leaves = nodes.filter(({ name, mesh }) => /^Leaf /.test(name) && mesh !== undefined);
		expect(leaves.length).toBeLessThan(13);
		const vertices = leaves.reduce((sum, { mesh = 0 }) => {
			const { POSITION, COLOR_0 } = meshes[mesh].primitives[0].attributes;
			expect(accessors[COLOR_0].count).toBe(accessors[POSITION].count);
			return sum + accessors[POSITION].count;
		}, 0);
		const blade = plant.meshes[plant.organs.mesh[0]].positions.length / 3;
		expect(vertices).toBe(count * blade);
	});

	it("has leaves of every tint in its files, too", async () => {
		const specimen = small();
		const plant = grow(specimen);
		const about = await aboutPlant(model, plant, specimen);
		for (const options of [{}, { compact: true }, { instancing: true }]) {
			const {
				nodes,
				meshes = [],
				materials = [],
			} = documentOf(exportGlb(model.parts(plant, specimen), about, options));
			const worn = new Set<number>();
			for (const { name, mesh } of nodes) {
				if (/^Leaf /.test(name) && mesh !== undefined) worn.add(meshes[mesh].primitives[0].material);
			}
			expect([...worn].map((material) => materials[material].name).sort()).toEqual(
				[1, 2, 3, 4, 5, 6].map((tint) => `Leaf ${tint}`),
			);
			for (const material of worn) expect(materials[material].pbrMetallicRoughness).toHaveProperty("baseColorTexture");
		}
	});

	it("reports where a link or a document requests an unknown leaf", async () => {
		const { specimen, notes } = decodeQuery(model, "?v=2&model=tree&leafkind=holly&leafshape=round");
		expect(specimen.parameters.leaf_kind).toBe(oak.parameters.leaf_kind);
		expect(notes.map(({ text }) => text)).toEqual([
			expect.stringMatching(/holly.*isn’t one of needle, beech/),
			expect.stringMatching(/leafshape/),
		]);
		const document = { ...oak, parameters: { ...oak.parameters, leaf_kind: "holly" } };
		expect(
			restore(model, document)
				.notes.map(({ text }) => text)
				.join(),
		).toMatch(/holly/);
	});
});

describe("leaves through the year", () => {
	const look = { leaf: "4c7a34", autumn: "c9892b", season: 0.4 };
	it("are lighter in spring, their own in summer, and turn one after the other", () => {
		const lightness = (season: number) => toLch(leafColour({ ...look, season })).lightness;
		expect(lightness(0)).toBeGreaterThan(lightness(0.4));
		const hues = (season: number) => leafTints({ ...look, season }).map(({ colour }) => toLch(colour).hue);
		const spread = (season: number) => Math.max(...hues(season)) - Math.min(...hues(season));
		expect(spread(0.75)).toBeGreaterThan(2 * spread(0.4));
		expect(leafTints(look)).toHaveLength(6);
	});
});
