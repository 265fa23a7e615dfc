import { beforeAll, describe, expect, it, vi } from "vitest";
import { Columns, writeContainer } from "../../../web/src/core/container";
import { Core } from "../../../web/src/core/core";
import { CoreError, CoreTrap, UnsupportedError } from "../../../web/src/core/errors";
import type { CoreExports } from "../../../web/src/core/exports";
import { loadCoreFromBytes } from "../../../web/src/core/loader";
import { PRESETS } from "../../../web/src/models/bunch/presets/presets";
import { encodeRequest } from "../../../web/src/models/bunch/request";
import { model as leafModel } from "../../../web/src/models/leaf/index";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { inRun } from "../../long_run.mjs";
import { type Specimen, specimenFromPreset, withParameters } from "../bunch";
import { freshCore, growBunch, wasmBytes } from "./wasm";

let core: Core;
beforeAll(async () => {
	core = await freshCore();
});

const grow = (specimen: Specimen) => growBunch(core, specimen, { meshes: false });
/** A request as bytes. */
const bytesFor = (specimen: Specimen, meshes = true) => writeContainer(encodeRequest(specimen, { meshes }));
/** As links of version 1 mean it: by the paper's procedure. */
const paper = (name?: string) => specimenFromPreset(name, 1);

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

	it("keeps nothing: memory stays level over many growths", async () => {
		const fresh = await freshCore();
		const requests = PRESETS.map(({ name }) => encodeRequest(paper(name), { meshes: false }));
		const grammar = encodeRequest({ ...specimenFromPreset(), grammar: "axiom: F(" });
		for (const request of requests) fresh.grow(request);
		refusal(() => fresh.grow(grammar));
		const level = fresh.memoryBytes;
		for (let turn = 0; turn < inRun(100, 500); turn++) {
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
		expect(refusal(() => core.grow(unknown)).message).toContain("wine");
		expect(grow(specimenFromPreset("rubus")).counts.berries).toBeGreaterThan(0);
	});

	it("refuses any bytes whatever as values, never as traps", () => {
		const request = bytesFor({ ...specimenFromPreset("lychee"), inputs: { m: 3, n: [1, 2] } }, false);
		const values = [0, 1, 0x7fc00000, 0xffffffff, 0x7f800000, 0x80000000, 0x00010000];
		for (let at = 0; at < request.length; at += 4 * inRun(4, 1)) {
			// Each word three of them, by turns.
			for (let turn = at / 4; turn < at / 4 + 3; turn++) {
				const value = values[turn % values.length];
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

	it("says so where a model grows from no grammar, and goes on", async () => {
		const particles = await WebAssembly.compile(await wasmBytes("particles.wasm"));
		expect(WebAssembly.Module.exports(particles).map(({ name }) => name)).not.toContain("panicle_compile");
		const fresh = await Core.instantiate(particles);
		const blocks = leafModel.encode(fromPreset(leafModel), { meshes: false });
		const reported = refusal(() => fresh.grow([...blocks, { name: "grammar", data: "axiom: F(1)" }]));
		expect([reported.reason, reported.message]).toEqual([
			"bad request",
			"This model does not use a grammar. Leave the grammar out.",
		]);
		expect(leafModel.read(fresh.grow(blocks)).segments.count).toBeGreaterThan(0);
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
		expect(() => fresh.grow(request)).toThrow(/crashed before/);
	});

	it("takes nothing but a core", async () => {
		const empty = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);
		for (const bytes of [new Uint8Array(0), new TextEncoder().encode("<!doctype html>"), empty, empty.slice(0, 6)]) {
			await expect(loadCoreFromBytes(bytes)).rejects.toBeInstanceOf(UnsupportedError);
		}
	});
});
