import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../../web/src/core/core";
import { aboutPlant } from "../../../../../web/src/export/about_plant";
import { exportGlb } from "../../../../../web/src/export/glb";
import { exportJson } from "../../../../../web/src/export/json";
import { splineThrough } from "../../../../../web/src/models/particles/boundary/editor/outline";
import { woodColours } from "../../../../../web/src/models/particles/boundary/wood_colours";
import { model } from "../../../../../web/src/models/particles/tree/index";
import { leafColour, leafTints } from "../../../../../web/src/models/particles/tree/leaf_colours";
import type { TreeSpecimen } from "../../../../../web/src/models/particles/tree/specimen";
import { linear, toLch } from "../../../../../web/src/plant/colour";
import type { PartMesh } from "../../../../../web/src/plant/part";
import { fromPreset } from "../../../../../web/src/specimen/from_preset";
import { decodeLink, decodeQuery, encodeLink } from "../../../../../web/src/specimen/link";
import { restore } from "../../../../../web/src/specimen/restore";
import { complaints, documentOf } from "../../../export/reading";
import { particlesCore } from "../boundary/particles";

let core: Core;
beforeAll(async () => {
	core = await particlesCore();
	await Promise.all(model.presets.list.map(({ name }) => model.prepare(fromPreset(model, name))));
});
const grow = (specimen: TreeSpecimen, options = {}) => model.read(core.grow(model.encode(specimen, options)), specimen);
const oak = fromPreset(model);
/** As few particles as still make a tree. */
const small = (specimen = oak, parameters = {}) => ({
	...specimen,
	parameters: { ...specimen.parameters, particles: 120, ...parameters },
});

/** Every triangle has an area, and looks where its corners' normals do. */
function facesOutwards({ positions, normals, indices }: PartMesh): void {
	for (let i = 0; i < indices.length; i += 3) {
		const [a, b, c] = [0, 1, 2].map((k) => positions.slice(3 * indices[i + k], 3 * indices[i + k] + 3));
		const [u, v] = [b, c].map((p) => [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
		const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
		for (let corner = 0; corner < 3; corner++) {
			const facing = cross.reduce((sum, value, k) => sum + value * normals[3 * indices[i + corner] + k], 0);
			expect(facing).toBeGreaterThan(0);
		}
	}
}

/** Six hexadecimal digits of a pixel. */
const hexadecimal = (pixels: ArrayLike<number>, at: number) =>
	[0, 1, 2].map((k) => pixels[at + k].toString(16).padStart(2, "0")).join("");

describe("a tree's presets", () => {
	it.each(model.presets.list.map(({ name }) => name))(
		"%s comes through its link and grows without a note",
		async (name) => {
			const specimen = fromPreset(model, name);
			expect(await decodeLink(model, await encodeLink(model, specimen))).toEqual({ specimen, notes: [] });
			expect(restore(model, JSON.parse(JSON.stringify(specimen)))).toEqual({ specimen, notes: [] });
			const { counts, notes, arrived } = grow(specimen, { meshes: false });
			expect(notes).toEqual([]);
			expect(counts.particles).toBeGreaterThan(0.8 * specimen.parameters.particles);
			expect(arrived.reduce((sum, energy) => sum + energy)).toBe(counts.particles);
			expect(arrived).toHaveLength(specimen.parameters.crowns * specimen.parameters.stems);
		},
	);

	it("say what they are in one sentence", () => {
		for (const { about, title } of model.presets.list) {
			expect(about).toMatch(/^[A-Z].*[^.]\.$/);
			expect(title.length).toBeLessThan(20);
		}
	});
});

describe("a tree", () => {
	it("heeds a profile, targets, obstacles and a mesh", () => {
		const fingerprint = (specimen: TreeSpecimen) => grow(specimen, { meshes: false }).fingerprint;
		const usual = fingerprint(small());
		const mesh = { points: [0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0], triangles: [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2] };
		const others = [
			{ ...small(), profile: [[1, 0], [0.2, 0.5], [1, 1]] as [number, number][] }, // biome-ignore format: a table
			{ ...small(), targets: [3, 0, 0] },
			{ ...small(), obstacles: [-6, 0, -6, -1, 12, 6] },
			{ ...small(oak, { shape: 5 }), volume: mesh },
		];
		expect(new Set([usual, ...others.map(fingerprint)]).size).toBe(5);
		// Nothing but the shape that it is for heeds a profile.
		const box = small(fromPreset(model, "box"));
		expect(fingerprint({ ...box, profile: [[1, 0], [1, 0.5], [1, 1]] })).toBe(fingerprint(box)); // biome-ignore format: a table
	});

	it("has the profile that the core takes where none is given", () => {
		const bare = small({ ...fromPreset(model, "twin") }, { shape: 4, crowns: 1 });
		expect(bare.profile).toBeUndefined();
		const egg: [number, number][] = [[0.1, 0], [0.8, 0.2], [1, 0.45], [0.7, 0.8], [0.08, 1]]; // biome-ignore format: a table
		expect(grow({ ...bare, profile: egg }, { meshes: false }).fingerprint).toBe(
			grow(bare, { meshes: false }).fingerprint,
		);
	});

	it("keeps its twigs' ends inside the outline that the editor draws", () => {
		const { profile = [], parameters } = oak;
		const outline = splineThrough(profile);
		const { organs } = grow(small(oak, { particles: 400 }), {});
		for (let i = 0; i < organs.count; i++) {
			const [x, y, z] = organs.transforms.subarray(8 * i);
			const height = (y - parameters.trunk) / parameters.height;
			const radius = (2 * Math.hypot(x, z)) / parameters.width;
			const widest = outline.reduce((most, [r, h]) => (Math.abs(h - height) < 0.06 ? Math.max(most, r) : most), 0);
			expect(radius).toBeLessThan(widest + 0.03);
		}
	});

	it("is made of bark and of leaves in their tints, each leaf once and, where they are few, by a name of its own", () => {
		const specimen = small(oak, { n: 150, leaves: 1 });
		const plant = grow(specimen);
		const parts = [...model.parts(plant, specimen)];
		expect(parts[0].shape?.material.name).toBe("Bark");
		const leaves = parts.slice(1).flatMap(({ shape }) => shape?.instances ?? []);
		expect(leaves.length).toBeGreaterThan(3);
		const count = leaves.reduce((sum, { transforms }) => sum + transforms.length / 8, 0);
		expect(count).toBe(plant.counts.leaves);
		const names = leaves.flatMap(({ transforms, each }) =>
			Array.from({ length: transforms.length / 8 }, (_, i) => each?.(i).name),
		);
		expect(new Set(names).size).toBe(count);
		expect(names[0]).toMatch(/^Leaf \d+$/);
		expect(leaves[0].sky).toHaveLength(leaves[0].transforms.length / 8);
		// Balls that nobody bears are not there.
		expect(parts.some(({ name }) => /ball/i.test(name))).toBe(false);
	});

	it("bears the leaf that its kind says, with its veins in the colours of each tint, in files as in the view", async () => {
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
				// Where the midrib is, it is paler than beside all veins.
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

	it("says where a link or a document asks for a leaf that there is none of", async () => {
		const { specimen, notes } = decodeQuery(model, "?v=2&model=tree&leafkind=holly&leafshape=round");
		expect(specimen.parameters.leaf_kind).toBe(oak.parameters.leaf_kind);
		expect(notes.map(({ text }) => text)).toEqual([
			expect.stringMatching(/holly.*none of needle, beech/),
			expect.stringMatching(/leafshape/),
		]);
		const document = { ...oak, parameters: { ...oak.parameters, leaf_kind: "holly" } };
		expect(
			restore(model, document)
				.notes.map(({ text }) => text)
				.join(),
		).toMatch(/holly/);
	});

	it("stands beside its obstacles, whose faces look outwards", () => {
		const specimen = { ...small(), obstacles: [2, 0, -1, 3, 4, 1, -5, 0, 0, -4, 1, 1], rounds: [3, 2, -3, 9, 8, 2] };
		const walls = [...model.parts(grow(specimen), specimen)].filter(({ name }) => /obstacle/i.test(name));
		expect(walls.map(({ name }) => name)).toEqual(["Obstacle 1", "Obstacle 2", "Round obstacle 1"]);
		const { positions, normals, indices } = walls[0].shape?.mesh ?? { positions: [], normals: [], indices: [] };
		expect(indices).toHaveLength(36);
		for (let i = 0; i < positions.length; i++) {
			if (normals[i] !== 0) expect(positions[i]).toBe([2, 0, -1, 3, 4, 1][(i % 3) + (normals[i] > 0 ? 3 : 0)]);
		}
		for (const { shape } of walls) facesOutwards(shape?.mesh as PartMesh);
	});

	it("keeps each leaf's tint while particles run, and shows those as balls", () => {
		const specimen = small();
		const young = small(oak, { age: 95 });
		const tints = (each: TreeSpecimen) => {
			const found = new Map<string, string>();
			for (const { name, shape } of model.parts(grow(each), each)) {
				const { transforms = new Float32Array() } = shape?.instances ?? {};
				// Wherever they are of whatever size: young leaves are still unfolding.
				for (let at = 0; at < transforms.length; at += 8) found.set(transforms.subarray(at, at + 7).join(), name);
			}
			return found;
		};
		const [before, after] = [tints(young), tints(specimen)];
		let kept = 0;
		for (const [place, name] of before) {
			if (!after.has(place)) continue;
			expect(after.get(place)).toBe(name);
			kept++;
		}
		expect([...tints(small(oak, { age: 40 })).values()]).toContain("Particle");
		expect([...after.values()]).not.toContain("Particle");
		expect(kept).toBeGreaterThan(0);
	});

	it("has young bark on its twigs, but not in passing", () => {
		const plant = grow(small());
		const stems = plant.meshes[0];
		const bark = { old: [1, 1, 1], young: [0, 0, 0], from: 0.008, to: 0.05 } as const;
		const shades = woodColours(plant, stems, { ...bark, old: [1, 1, 1], young: [0, 0, 0] });
		expect(Math.min(...(shades ?? []))).toBe(0);
		expect(Math.max(...(shades ?? []))).toBe(1);
		const passing = grow(small(), { passing: true });
		expect(woodColours(passing, passing.meshes[0], { ...bark, old: [1, 1, 1], young: [0, 0, 0] })).toBeUndefined();
	});

	it("has a white trunk with dark marks that is dark at the foot, in files as in the view, and a furrowed oak's", () => {
		const bark = (name: string) => {
			const specimen = small(fromPreset(model, name), { leaves: 0 });
			const plant = grow(specimen);
			const [{ shape }] = [...model.parts(plant, specimen)];
			const { colours = new Float32Array(), positions = new Float32Array() } = shape?.mesh ?? {};
			const { colour = [1], textures } = shape?.material ?? {};
			expect(textures?.repeats).toBe(true);
			// Of what goes around the trunk.
			const thick = Array.from(plant.bearing ?? [], (segment, i) => ({
				height: positions[3 * i + 1],
				radius: plant.segments.radii[2 * segment + 1],
				shade: colours[3 * i] / colour[0],
			})).filter(({ radius }) => radius > 0.06);
			const shades = (low: number, high: number) =>
				thick.filter(({ height }) => height >= low && height <= high).map(({ shade }) => shade);
			return {
				foot: Math.min(...shades(0, 0.1)),
				paper: Math.min(...shades(1.2, 2)),
				picture: textures?.colour?.pixels,
			};
		};
		const birch = bark("birch");
		expect(birch.foot).toBeLessThan(0.5);
		expect(birch.paper).toBeGreaterThan(0.95);
		const dark = birch.picture?.reduce((least, value) => Math.min(least, value), 255);
		const pale = mean(birch.picture);
		expect(dark).toBeLessThan(80);
		expect(pale).toBeGreaterThan(190);
		const oak = bark("oak");
		expect(oak.foot).toBeGreaterThan(0.9);
		expect(mean(oak.picture)).toBeLessThan(pale);
		expect(bark("oak").picture).toBe(oak.picture);
	});

	it("is exported as GLB to which Khronos' validator has nothing to say, and as JSON as the issue wants it", async () => {
		const specimen = small(oak, { particles: 40 });
		const plant = grow(specimen);
		const about = await aboutPlant(model, plant, specimen);
		for (const options of [{}, { instancing: true }]) {
			expect(await complaints(exportGlb(model.parts(plant, specimen), about, options))).toEqual([]);
		}
		const json = JSON.parse(JSON.stringify(exportJson(model, plant, specimen)));
		expect(Object.keys(json)).toEqual(
			expect.arrayContaining(["counts", "segments", "targets", "measures", "notes", "fingerprint"]),
		);
		expect(json.segments[0]).toMatchObject({ parent: -1, energy: expect.any(Number), radius: expect.any(Number) });
		expect(json.counts).toMatchObject({ targets: 1, energy: json.counts.particles, segments: json.segments.length });
		expect(json.measures.height.value ?? json.measures.height).toBeGreaterThan(5);
	});

	it("is described in a few words", () => {
		expect(model.words(grow(small(), { meshes: false }))).toMatch(/^[\d.]+ m tall, [\d,]+ leaves$/);
		expect(model.words(grow(small(oak, { leaves: 0 }), { meshes: false }))).toMatch(/m tall, bare$/);
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

function mean(values: Uint8Array = new Uint8Array()): number {
	return values.reduce((sum, value) => sum + value, 0) / values.length;
}
