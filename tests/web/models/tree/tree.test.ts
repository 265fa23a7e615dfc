import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { exportJson } from "../../../../web/src/formats/json";
import { splineThrough } from "../../../../web/src/models/particles/boundary/editor/outline";
import { model } from "../../../../web/src/models/tree/index";
import type { TreeSpecimen } from "../../../../web/src/models/tree/specimen";
import { linear } from "../../../../web/src/plant/colour";
import type { PartMesh } from "../../../../web/src/plant/part";
import { woodColours } from "../../../../web/src/plant/wood/wood_colours";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { decodeLink, encodeLink } from "../../../../web/src/specimen/link";
import { restore } from "../../../../web/src/specimen/restore";
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

/** Every triangle has an area and faces the same way as its normals. */
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

	it("describe themselves in one sentence", () => {
		for (const { about, title } of model.presets.list) {
			expect(about).toMatch(/^[A-Z].*[^.]\.$/);
			expect(title.length).toBeLessThan(20);
		}
	});
});

describe("a tree", () => {
	it("uses a profile, targets, obstacles and a mesh", () => {
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
		// Only the shape `spline` uses a profile.
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
		// Unused ball meshes are not exported.
		expect(parts.some(({ name }) => /ball/i.test(name))).toBe(false);
	});

	it("exports its obstacles with faces outwards", () => {
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
				// Sizes differ where leaves are still unfolding.
				for (let at = 0; at < transforms.length; at += 8) found.set(transforms.subarray(at, at + 7).join(), name);
			}
			return found;
		};
		const [before, after] = [tints(young), tints(specimen)];
		let found = 0;
		for (const [place, name] of before) {
			if (!after.has(place)) continue;
			expect(after.get(place)).toBe(name);
			found++;
		}
		expect([...tints(small(oak, { age: 40 })).values()]).toContain("Particle");
		expect([...after.values()]).not.toContain("Particle");
		expect(found).toBeGreaterThan(0);
	});

	it("has young bark on its twigs, also in previews", () => {
		const plant = grow(small());
		const stems = plant.meshes[0];
		const bark = { old: [1, 1, 1], young: [0, 0, 0], from: 0.008, to: 0.05 } as const;
		const shades = woodColours(plant, stems, { ...bark, old: [1, 1, 1], young: [0, 0, 0] });
		expect(Math.min(...(shades ?? []))).toBe(0);
		expect(Math.max(...(shades ?? []))).toBe(1);
		const preview = grow(small(), { preview: true });
		const draft = woodColours(preview, preview.meshes[0], { ...bark, old: [1, 1, 1], young: [0, 0, 0] });
		expect(draft?.length).toBe(preview.meshes[0].positions.length);
		expect(Math.max(...(draft ?? []))).toBeGreaterThan(0.9);
	});

	it("has a white trunk with dark marks that is dark at the foot, in files as in the view, and a furrowed oak's", () => {
		const bark = (name: string) => {
			const specimen = small(fromPreset(model, name), { leaves: 0 });
			const plant = grow(specimen);
			const [{ shape }] = [...model.parts(plant, specimen)];
			const { colours = new Float32Array(), positions = new Float32Array() } = shape?.mesh ?? {};
			// Vertices have the bark's colour over the picture's mean, which is the material's colour.
			const { colour: pictureMean = [1], textures } = shape?.material ?? {};
			const own = linear(String(specimen.look.bark))[0];
			expect(textures?.repeats).toBe(true);
			// Vertices around the trunk.
			const thick = Array.from(plant.vertexSegments ?? [], (segment, i) => ({
				height: positions[3 * i + 1],
				radius: plant.segments.radii[2 * segment + 1],
				shade: (colours[3 * i] * pictureMean[0]) / own,
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

	it("is exported as JSON with its counts, segments, targets, measures and notes", async () => {
		const specimen = small(oak, { particles: 40 });
		const plant = grow(specimen);
		const json = JSON.parse(JSON.stringify(exportJson(model, plant, specimen)));
		expect(Object.keys(json)).toEqual(
			expect.arrayContaining(["counts", "segments", "targets", "measures", "notes", "fingerprint"]),
		);
		expect(json.segments[0]).toMatchObject({ parent: -1, energy: expect.any(Number), radius: expect.any(Number) });
		expect(json.counts).toMatchObject({ targets: 1, energy: json.counts.particles, segments: json.segments.length });
		expect(json.measures.height.value ?? json.measures.height).toBeGreaterThan(5);
	});

	it("is described in a few words", () => {
		expect(model.summary(grow(small(), { meshes: false }))).toMatch(/^[\d.]+ m tall, [\d,]+ leaves$/);
		expect(model.summary(grow(small(oak, { leaves: 0 }), { meshes: false }))).toMatch(/m tall, bare$/);
	});
});

function mean(values: Uint8Array = new Uint8Array()): number {
	return values.reduce((sum, value) => sum + value, 0) / values.length;
}
