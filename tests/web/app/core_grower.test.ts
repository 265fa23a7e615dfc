import { describe, expect, it, vi } from "vitest";
import { CoreGrower } from "../../../web/src/app/core_grower";
import { Columns, writeContainer } from "../../../web/src/core/container";
import { Superseded } from "../../../web/src/core/errors";
import type { PageModel } from "../../../web/src/models/page_model";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { toy } from "../toy";

const model = toy as unknown as PageModel;
const address = (file: string) => (file === "toy.wasm" ? "/cores/toy.wasm" : undefined);

describe("the core grower", () => {
	it("grows a specimen by its model's core, with the model's encoding and reading", async () => {
		const columns = new Columns(writeContainer([{ name: "fingerprint", data: "0123" }]));
		const grow = vi.fn(async () => ({ columns, milliseconds: 7 }));
		const { signal } = new AbortController();
		const grown = await new CoreGrower(address, { grow, warm: vi.fn(), growMember: vi.fn() }).grow(
			model,
			{ ...fromPreset(model), seed: 5 },
			{ measures: false, signal },
		);
		expect(grown).toMatchObject({ fingerprint: "0123", timings: { grow: 7 } });
		expect(grow).toHaveBeenCalledExactlyOnceWith(
			{
				wasm: "/cores/toy.wasm",
				blocks: [
					{ name: "model", data: "toy" },
					{ name: "seed", data: Uint32Array.of(5) },
				],
			},
			{ signal },
		);
	});

	it("waits for a specimen's files, and grows without those that cannot be fetched", async () => {
		const columns = new Columns(writeContainer([{ name: "fingerprint", data: "0123" }]));
		for (const comes of [true, false]) {
			let there = false;
			const grow = vi.fn(async (_order: { blocks: readonly unknown[] }) => ({ columns, milliseconds: 7 }));
			const needy: PageModel = {
				...model,
				prepare: async () => {
					await Promise.resolve();
					if (!comes) throw new TypeError("Failed to fetch");
					there = true;
				},
				encode: () => [{ name: "there", data: Uint32Array.of(there ? 1 : 0) }],
			};
			await new CoreGrower(address, { grow, warm: vi.fn(), growMember: vi.fn() }).grow(needy, fromPreset(model));
			expect(grow.mock.calls[0][0].blocks).toEqual([{ name: "there", data: Uint32Array.of(comes ? 1 : 0) }]);
		}
	});

	it("waits only for the sketch when sketched, for models that have one", async () => {
		const columns = new Columns(writeContainer([{ name: "fingerprint", data: "0123" }]));
		const client = { grow: async () => ({ columns, milliseconds: 7 }), warm: vi.fn(), growMember: vi.fn() };
		const [prepare, sketch] = [vi.fn(async () => {}), vi.fn(async () => {})];
		const cores = new CoreGrower(address, client);
		await cores.grow({ ...model, prepare, sketch }, fromPreset(model), { sketched: true });
		expect([prepare, sketch].map(({ mock }) => mock.calls.length)).toEqual([0, 1]);
		await cores.grow({ ...model, prepare, sketch }, fromPreset(model));
		await cores.grow({ ...model, prepare }, fromPreset(model), { sketched: true });
		expect([prepare, sketch].map(({ mock }) => mock.calls.length)).toEqual([2, 1]);
	});

	it("does not start an older growth after a newer one", async () => {
		const columns = new Columns(writeContainer([{ name: "fingerprint", data: "0123" }]));
		const grow = vi.fn(async (_order: { blocks: readonly unknown[] }) => ({ columns, milliseconds: 7 }));
		const cores = new CoreGrower(address, { grow, warm: vi.fn(), growMember: vi.fn() });
		let come = () => {};
		const slow: PageModel = { ...model, prepare: () => new Promise((resolve) => (come = resolve)) };
		const older = cores.grow(slow, { ...fromPreset(model), seed: 1 });
		await cores.grow(model, { ...fromPreset(model), seed: 2 });
		come();
		await expect(older).rejects.toThrow(Superseded);
		expect(grow).toHaveBeenCalledOnce();
		expect(grow.mock.calls[0][0].blocks).toContainEqual({ name: "seed", data: Uint32Array.of(2) });
	});

	it("starts fetching cores by known file names only", () => {
		const warm = vi.fn();
		const cores = new CoreGrower(address, { grow: vi.fn(), warm, growMember: vi.fn() });
		cores.warm("plum.wasm");
		expect(warm).not.toHaveBeenCalled();
		cores.warm("toy.wasm");
		expect(warm).toHaveBeenCalledExactlyOnceWith("/cores/toy.wasm");
	});

	it("rejects if the model's core is missing", async () => {
		const cores = new CoreGrower(() => undefined, { grow: vi.fn(), warm: vi.fn(), growMember: vi.fn() });
		await expect(cores.grow(model, fromPreset(model))).rejects.toThrow(
			"This version of the app cannot grow this kind of plant.",
		);
	});
});
