import { beforeAll, describe, expect, it, vi } from "vitest";
import { Columns, writeContainer } from "../../../web/src/core/container";
import { Core } from "../../../web/src/core/core";
import { CoreError, CoreTrap, UnsupportedError } from "../../../web/src/core/errors";
import type { CoreExports } from "../../../web/src/core/exports";
import { loadCoreFromBytes } from "../../../web/src/core/loader";
import { type Grown, INTERNODE_KINDS, TRAITS } from "../../../web/src/models/bunch/grown";
import { PRESETS } from "../../../web/src/models/bunch/presets/index";
import { encodeRequest } from "../../../web/src/models/bunch/request";
import { BERRY_IDS, type Specimen, specimenFromPreset, withParameters } from "../bunch";
import { TABLE_3 } from "../specimen/table_3";
import { freshCore, growBunch, wasmBytes } from "./wasm";

let core: Core;
beforeAll(async () => {
	core = await freshCore();
});

const grow = (specimen: Specimen, meshes = false) => growBunch(core, specimen, { meshes, meshFingerprint: meshes });
/** A request as bytes. */
const bytesFor = (specimen: Specimen, meshes = true) => writeContainer(encodeRequest(specimen, { meshes }));
/** As links of version 1 mean it: by the paper's procedure. */
const paper = (name?: string) => specimenFromPreset(name, 1);
const PROCEDURES = [
	["natural", (name?: string) => specimenFromPreset(name)],
	["paper", paper],
] as const;

/** All that came back but how long it took, as bytes. */
function bytesOf({ timings: _, ...grown }: Omit<Grown, "timings"> & Partial<Grown>): string {
	return JSON.stringify(grown, (_key, value) =>
		ArrayBuffer.isView(value) ? Array.from(value as Float32Array) : value,
	);
}

/** Something for every function that a module imports. */
function stubsOf(module: WebAssembly.Module): WebAssembly.Imports {
	const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
	for (const { module: from, name } of WebAssembly.Module.imports(module)) {
		imports[from] = { ...imports[from], [name]: () => 0 };
	}
	return imports;
}

function refusal(action: () => unknown): CoreError {
	try {
		action();
	} catch (error) {
		if (error instanceof CoreError) return error;
		throw error;
	}
	throw new Error("nothing was refused");
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

	it("tells seeds and parameters apart", () => {
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

		it("says nothing about a specimen that is in range", () => {
			for (const { name } of PRESETS) expect(grow(start(name)).notes).toEqual([]);
		});
	});

	it("bears a berry or withers on every pedicel of the paper's procedure", () => {
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
	it.each(PROCEDURES)("of procedure=%s come only when asked for, and change nothing else", (procedure, start) => {
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

	it("are as fine as asked for", () => {
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

describe("the border", () => {
	it("lets no view of the core's memory out: the answer is one buffer, which can be given away", () => {
		const { columns } = core.grow(encodeRequest(withParameters(specimenFromPreset(), { age: 5, leaves: 1 })));
		const { bytes } = columns;
		const same = bytes.slice();
		expect(bytes.byteLength).toBe(bytes.buffer.byteLength);
		core.grow(encodeRequest(specimenFromPreset("duku")));
		expect(Buffer.compare(bytes, same)).toBe(0);
		const moved = structuredClone(bytes, { transfer: [bytes.buffer] });
		expect(columns.floats("segments.ends").length).toBe(0);
		expect(new Columns(moved).names).toEqual(columns.names);
	});

	it("keeps nothing: memory stays level over 500 growths", async () => {
		const fresh = await freshCore();
		const requests = PRESETS.map(({ name }) => encodeRequest(paper(name), { meshes: false }));
		const grammar = encodeRequest({ ...specimenFromPreset(), grammar: "axiom: F(" });
		for (const request of requests) fresh.grow(request);
		refusal(() => fresh.grow(grammar));
		const level = fresh.memoryBytes;
		for (let turn = 0; turn < 500; turn++) {
			if (turn % 10 === 9) refusal(() => fresh.grow(grammar));
			else fresh.grow(requests[turn % requests.length]);
		}
		expect(fresh.memoryBytes).toBe(level);
	});

	it("refuses what is no request, and goes on", () => {
		expect(refusal(() => core.growBytes(new Uint8Array(0))).reason).toBe("bad request");
		expect(refusal(() => core.growBytes(new Uint8Array(7))).reason).toBe("bad request");
		expect(refusal(() => core.growBytes(new Uint8Array(400))).reason).toBe("bad request");
		expect(refusal(() => core.growBytes(new Uint8Array(8 << 20))).reason).toBe("limit");
		const cut = bytesFor(specimenFromPreset()).slice(0, -4);
		expect(refusal(() => core.growBytes(cut)).reason).toBe("bad request");
		expect(refusal(() => core.grow([{ name: "model", data: "grapes" }])).reason).toBe("bad request");
		const unknown = [...encodeRequest(specimenFromPreset()), { name: "wine", data: "red" }];
		expect(refusal(() => core.grow(unknown)).message).toContain("“wine”");
		expect(grow(specimenFromPreset("rubus")).counts.berries).toBeGreaterThan(0);
	});

	it("refuses any bytes whatever as values, never as traps", () => {
		const request = bytesFor({ ...specimenFromPreset("lychee"), inputs: { m: 3, n: [1, 2] } }, false);
		const values = [0, 1, 0x7fc00000, 0xffffffff, 0x7f800000, 0x80000000, 0x00010000];
		for (let at = 0; at < request.length; at += 4) {
			for (const value of values) {
				const altered = request.slice();
				new DataView(altered.buffer).setUint32(at, value, true);
				try {
					core.growBytes(altered);
				} catch (error) {
					expect(error).toBeInstanceOf(CoreError);
				}
			}
		}
	});

	it("compiles a grammar once for all growths with its text, and lets go of texts of long ago", async () => {
		const module = await WebAssembly.compile(await wasmBytes());
		const { exports } = await WebAssembly.instantiate(module, stubsOf(module));
		const real = exports as unknown as CoreExports;
		const panicle_compile = vi.fn(real.panicle_compile);
		const panicle_forget = vi.fn(real.panicle_forget);
		const instantiate = vi.spyOn(WebAssembly, "instantiate");
		instantiate.mockResolvedValueOnce({ exports: { ...exports, panicle_compile, panicle_forget } } as never);
		const fresh = await Core.instantiate(module);
		instantiate.mockRestore();
		const text = (length: number) => ({ ...paper("duku"), grammar: `axiom: F(${length})S(9)` });
		const first = growBunch(fresh, text(50)).fingerprint;
		for (let seed = 1; seed < 5; seed++) growBunch(fresh, { ...text(50), seed });
		expect(panicle_compile).toHaveBeenCalledTimes(1);
		for (let length = 1; length <= 20; length++) growBunch(fresh, text(length));
		expect(panicle_compile).toHaveBeenCalledTimes(21);
		expect(panicle_forget).toHaveBeenCalledTimes(13);
		expect(growBunch(fresh, text(50)).fingerprint).toBe(first);
		expect(panicle_compile).toHaveBeenCalledTimes(22);
	});

	it("says where a grammar goes wrong", () => {
		const bad = refusal(() => grow({ ...specimenFromPreset(), grammar: "axiom: A(1)\nA(i) : i>1 --> F(i\n" }));
		expect(bad.reason).toBe("syntax");
		expect(bad.line).toBeGreaterThanOrEqual(2);
		expect(bad.column).toBeGreaterThan(0);
		expect(bad.message).toMatch(/\S/);
		expect(bad.message).not.toMatch(/\n/);
	});

	it("ends a grammar without end as a value", () => {
		const endless = refusal(() => grow({ ...specimenFromPreset(), grammar: "axiom: A\nA --> F(1) A A\n" }));
		expect(endless.reason).toBe("limit");
	});

	it("is no longer used after a trap", async () => {
		const module = await WebAssembly.compile(await wasmBytes());
		const { exports } = await WebAssembly.instantiate(module, stubsOf(module));
		const broken = () => {
			throw new WebAssembly.RuntimeError("unreachable");
		};
		const instantiate = vi.spyOn(WebAssembly, "instantiate");
		instantiate.mockResolvedValueOnce({ exports: { ...exports, panicle_grow: broken } } as never);
		const fresh = await Core.instantiate(module);
		instantiate.mockRestore();
		const request = encodeRequest(specimenFromPreset());
		expect(() => fresh.grow(request)).toThrow(CoreTrap);
		expect(() => fresh.grow(request)).toThrow(/broken before/);
	});

	it("takes nothing but a core", async () => {
		const empty = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);
		for (const bytes of [new Uint8Array(0), new TextEncoder().encode("<!doctype html>"), empty, empty.slice(0, 6)]) {
			await expect(loadCoreFromBytes(bytes)).rejects.toBeInstanceOf(UnsupportedError);
		}
	});
});
