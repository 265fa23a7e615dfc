import { beforeAll, expect, it } from "vitest";
import { Columns } from "../../../web/src/core/container";
import type { FromWorker, ToWorker } from "../../../web/src/core/messages";
import { serve } from "../../../web/src/core/serve";
import { encodeRequest } from "../../../web/src/models/bunch/request";
import { readPlant } from "../../../web/src/plant/read_plant";
import { specimenFromPreset } from "../bunch";
import { wasmBytes } from "./wasm";

let module: WebAssembly.Module;
beforeAll(async () => {
	module = await WebAssembly.compile(await wasmBytes());
});

function worker() {
	const said: { message: FromWorker; transfer: Transferable[] }[] = [];
	const tell = serve((message, transfer) => said.push({ message, transfer }));
	return { said, tell: (message: ToWorker) => tell(message) };
}

const wasm = "bunch.wasm";

it("is ready once the core lives, and answers even what came before", async () => {
	const { said, tell } = worker();
	const blocks = encodeRequest(specimenFromPreset("rubus"));
	await Promise.all([tell({ type: "start", wasm, module }), tell({ type: "grow", id: 4, wasm, blocks })]);
	expect(said.map(({ message }) => message.type)).toEqual(["ready", "grown"]);
	const [, { message, transfer }] = said;
	if (message.type !== "grown") throw new Error("not grown");
	expect(message.id).toBe(4);
	expect(transfer).toEqual([message.container.buffer]);
	// The memory that its cores hold: what bunch.wasm begins with at least.
	expect(message.memoryBytes).toBeGreaterThanOrEqual(4 * 1024 * 1024);
	const plant = readPlant({ columns: new Columns(message.container), milliseconds: message.milliseconds });
	expect(plant.counts.berries).toBeGreaterThan(0);
});

it("tells why something cannot be grown, and goes on", async () => {
	const { said, tell } = worker();
	await tell({ type: "start", wasm, module });
	const grammar = encodeRequest({ ...specimenFromPreset(), grammar: "axiom: (" });
	await tell({ type: "grow", id: 1, wasm, blocks: grammar });
	await tell({ type: "grow", id: 2, wasm, blocks: encodeRequest(specimenFromPreset("lychee")) });
	expect(said[1].message).toMatchObject({
		type: "failed",
		id: 1,
		reason: "syntax",
		line: 1,
		column: expect.any(Number),
	});
	expect(said[2].message).toMatchObject({ type: "grown", id: 2 });
});

it("keeps a core for each module", async () => {
	const { said, tell } = worker();
	await tell({ type: "start", wasm, module });
	await tell({ type: "grow", id: 1, wasm: "leaf.wasm", blocks: encodeRequest(specimenFromPreset("rubus")) });
	expect(said[1].message).toMatchObject({ type: "trapped", id: 1 });
	await tell({ type: "start", wasm: "leaf.wasm", module });
	await tell({ type: "grow", id: 2, wasm: "leaf.wasm", blocks: encodeRequest(specimenFromPreset("rubus")) });
	expect(said[3].message).toMatchObject({ type: "grown", id: 2 });
});

it("tells when the core is none", async () => {
	const { said, tell } = worker();
	const empty = await WebAssembly.compile(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0));
	await tell({ type: "start", wasm, module: empty });
	expect(said.map(({ message }) => message.type)).toEqual(["broken"]);
	await tell({ type: "grow", id: 1, wasm, blocks: [] });
	expect(said[1].message).toMatchObject({ type: "trapped", id: 1 });
});
