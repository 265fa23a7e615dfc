import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { type BunchPlant, INTERNODE_KINDS, TRAITS } from "../../../../web/src/models/bunch/bunch_plant";
import { PRESETS } from "../../../../web/src/models/bunch/presets/presets";
import { encodeRequest } from "../../../../web/src/models/bunch/request";
import { BERRY_IDS, type Specimen, specimenFromPreset, withParameters } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";
import { TABLE_3 } from "../../specimen/table_3";

let core: Core;
beforeAll(async () => {
	core = await freshCore();
});

const grow = (specimen: Specimen, meshes = false) => growBunch(core, specimen, { meshes, meshFingerprint: meshes });
/** Specimens of links of version 1, which use the paper's procedure. */
const paper = (name?: string) => specimenFromPreset(name, 1);
const PROCEDURES = [
	["natural", (name = "short-conical") => specimenFromPreset(name)],
	["paper", paper],
] as const;

/** Returns a growth as bytes, without its timings. */
function bytesOf({ timings: _, ...grown }: Omit<BunchPlant, "timings"> & Partial<BunchPlant>): string {
	return JSON.stringify(grown, (_key, value) =>
		ArrayBuffer.isView(value) ? Array.from(value as Float32Array) : value,
	);
}

describe("growing", () => {
	it("gives the same bytes every time, from the same instance and from another", async () => {
		const request = encodeRequest(specimenFromPreset("shouldered-conical"));
		const first = core.grow(request).columns.bytes;
		grow(specimenFromPreset("duku"));
		grow(paper("duku"));
		expect(Buffer.compare(core.grow(request).columns.bytes, first)).toBe(0);
		expect(Buffer.compare((await freshCore()).grow(request).columns.bytes, first)).toBe(0);
	});

	it("differs by seeds and parameters", () => {
		const prints = [
			specimenFromPreset(),
			{ ...specimenFromPreset(), seed: 2 },
			withParameters(specimenFromPreset(), { size: 17 }),
			specimenFromPreset("cylindrical"),
			paper(),
			withParameters(paper(), { rmax: 31 }),
		].map((specimen) => grow(specimen).fingerprint);
		expect(new Set(prints).size).toBe(6);
		for (const print of prints) expect(print).toMatch(/^[0-9a-f]{16}$/);
	});

	it.each(PROCEDURES)("gives the sky visibility of every vertex, by procedure=%s", (_, start) => {
		const specimen = withParameters(start(), { leaves: 2 });
		const { berries, surfaces, berry, stem, foliage } = grow(specimen, true);
		const skin = surfaces ?? berry;
		expect(skin?.sky).toHaveLength((berries.count * (skin?.uvs.length ?? 0)) / 2);
		expect(stem?.sky).toHaveLength(stem?.internode.length ?? 0);
		if (foliage) expect(foliage.sky).toHaveLength(foliage.uvs.length / 2);
		expect(foliage !== undefined).toBe(surfaces !== undefined);
		for (const sky of [skin?.sky, stem?.sky]) {
			const mean = Array.from(sky ?? []).reduce((sum, byte) => sum + byte, 0) / (sky?.length ?? 0);
			expect(mean).toBeGreaterThan(10);
			expect(mean).toBeLessThan(245);
		}
		const without = growBunch(core, specimen, { sky: false, meshFingerprint: true });
		expect((without.surfaces ?? without.berry)?.sky).toBeUndefined();
		expect(without.stem?.sky).toBeUndefined();
		expect(without.meshFingerprint).toBe(grow(specimen, true).meshFingerprint);
	});

	describe.each(PROCEDURES)("by procedure=%s", (procedure, start) => {
		it.each(PRESETS.map(({ name }) => name))("%s gives lists that agree with its counts", (name) => {
			const grown = grow(start(name));
			const { counts, internodes, berries } = grown;
			expect(grown.procedure).toBe(procedure);
			expect(internodes.count).toBe(counts.internodes);
			expect(internodes.ends.length).toBe(6 * internodes.count);
			expect(internodes.radii.length).toBe(2 * internodes.count);
			expect(berries.count).toBe(counts.berries);
			expect(berries.directions.length).toBe(3 * berries.count);
			expect(berries.parent.length).toBe(berries.count);
			expect(berries.traits.length).toBe(TRAITS.length * berries.count);
			expect(new Set(berries.ids).size).toBe(berries.count);
			for (const id of berries.ids) expect(id).toBeLessThan(BERRY_IDS);
			expect(counts.berries).toBeGreaterThan(0);
			const pedicel = INTERNODE_KINDS.indexOf("pedicel");
			expect(internodes.kind.filter((kind) => kind === pedicel)).toHaveLength(counts.pedicels);
			for (const parent of berries.parent) expect(internodes.kind[parent]).toBe(pedicel);
			internodes.parent.forEach((parent, index) => {
				expect(parent).toBeLessThan(index);
			});
		});

		it("adds no notes to a specimen that is in range", () => {
			for (const { name } of PRESETS) expect(grow(start(name)).notes).toEqual([]);
		});
	});

	it("grows a berry or withers on every pedicel of the paper's procedure", () => {
		for (const { name } of PRESETS) {
			const { counts, plan, thinned } = grow(paper(name));
			expect(counts.berries + counts.withered).toBe(counts.pedicels);
			expect(plan.axes).toHaveLength(plan.m - 1);
			expect(thinned).toEqual([]);
		}
	});

	it("reproduces Table 3 but for the one value that print and formula disagree on", () => {
		const differing = TABLE_3.flatMap(({ name, m, sides }) => {
			const { plan } = grow(paper(name));
			const derived = [
				["m", plan.m, m],
				...sides.flatMap(([, , n, rd], side) => [
					[`p${side + 3} n`, plan.sides[side].n, n],
					[`p${side + 3} rd`, plan.sides[side].rd, rd],
				]),
			];
			return derived.filter(([, ours, printed]) => ours !== printed).map((each) => [name, ...each]);
		});
		expect(differing).toEqual([["grape-15c", "p4 rd", 6, 5]]);
	});

	it("grows a second bunch where there is one", () => {
		expect(grow(paper("long-conical")).second).toBeUndefined();
		const { plan, second, internodes } = grow(paper("double-bunch-winged"));
		expect(second?.m).toBeLessThan(plan.m);
		expect(Math.max(...internodes.axis)).toBeGreaterThanOrEqual(plan.m - 1);
	});

	it("finds room for the second bunch, whatever the seed", () => {
		for (let seed = 1; seed <= 20; seed++) {
			const { plan, internodes, berries } = grow({ ...paper("double-bunch-winged"), seed });
			const ofSecond = berries.parent.filter((pedicel) => internodes.axis[pedicel] >= plan.m - 1);
			expect(ofSecond.length).toBeGreaterThan(15);
		}
	});

	it("takes the grammar's inputs in place of the profile's", () => {
		const { plan, counts } = grow({ ...paper(), inputs: { m: 3, n: [1, 2] } });
		expect([plan.m, plan.axes]).toEqual([3, [2, 1]]);
		expect(counts.endStructures).toBe(4);
	});
});

describe("meshes", () => {
	it.each(PROCEDURES)("of procedure=%s exist only if requested, and change nothing else", (procedure, start) => {
		const bare = grow(start());
		expect([bare.stem, bare.berry, bare.surfaces, bare.meshFingerprint]).toEqual(Array(4).fill(undefined));
		const { stem, berry, surfaces, meshFingerprint, ...rest } = grow(start(), true);
		expect(bytesOf({ ...rest, meshes: [] })).toBe(bytesOf(bare));
		expect(meshFingerprint).toMatch(/^[0-9a-f]{16}$/);
		expect([berry !== undefined, surfaces !== undefined]).toEqual([procedure === "paper", procedure === "natural"]);
		for (const mesh of procedure === "paper" ? [stem, berry] : [stem]) {
			if (!mesh) throw new Error("no mesh");
			const vertices = mesh.positions.length / 3;
			expect(mesh.normals.length).toBe(3 * vertices);
			expect(mesh.uvs.length).toBe(2 * vertices);
			expect(mesh.indices.length % 3).toBe(0);
			expect(mesh.indices.length).toBeGreaterThan(0);
			expect(mesh.indices.reduce((most, index) => Math.max(most, index), 0)).toBe(vertices - 1);
			expect(mesh.positions.every(Number.isFinite)).toBe(true);
		}
	});

	it("have parts that cover the stem from end to end", () => {
		const { stem } = grow(paper(), true);
		let vertex = 0;
		let index = 0;
		for (const part of stem?.parts ?? []) {
			expect([part.firstVertex, part.firstIndex]).toEqual([vertex, index]);
			vertex += part.vertexCount;
			index += part.indexCount;
		}
		expect([vertex * 3, index]).toEqual([stem?.positions.length, stem?.indices.length]);
		expect(stem?.internode.length).toBe(vertex);
	});

	it("have the requested resolution", () => {
		const vertices = (stemSides: number, berrySegments: number) => {
			const grown = growBunch(core, paper(), { stemSides, berrySegments });
			return [grown.stem?.positions.length ?? 0, grown.berry?.positions.length ?? 0];
		};
		const coarse = vertices(5, 8);
		const fine = vertices(16, 32);
		expect(fine[0]).toBeGreaterThan(coarse[0]);
		expect(fine[1]).toBeGreaterThan(coarse[1]);
	});
});
