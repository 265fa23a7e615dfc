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
	const messages: { message: FromWorker; transfer: Transferable[] }[] = [];
	const report = serve((message, transfer) => messages.push({ message, transfer }));
	return { messages, report: (message: ToWorker) => report(message) };
}

const wasm = "bunch.wasm";

it("is ready once the core lives, and answers even what came before", async () => {
	const { messages, report } = worker();
	const blocks = encodeRequest(specimenFromPreset("rubus"));
	await Promise.all([report({ type: "start", wasm, module }), report({ type: "grow", id: 4, wasm, blocks })]);
	expect(messages.map(({ message }) => message.type)).toEqual(["ready", "grown"]);
	const [, { message, transfer }] = messages;
	if (message.type !== "grown") throw new Error("not grown");
	expect(message.id).toBe(4);
	expect(transfer).toEqual([message.container.buffer]);
	// The memory that its cores hold: at least the initial memory of bunch.wasm.
	expect(message.memoryBytes).toBeGreaterThanOrEqual(4 * 1024 * 1024);
	const plant = readPlant({ columns: new Columns(message.container), milliseconds: message.milliseconds });
	expect(plant.counts.berries).toBeGreaterThan(0);
});

it("tells why something cannot be grown, and goes on", async () => {
	const { messages, report } = worker();
	await report({ type: "start", wasm, module });
	const grammar = encodeRequest({ ...specimenFromPreset(), grammar: "axiom: (" });
	await report({ type: "grow", id: 1, wasm, blocks: grammar });
	await report({ type: "grow", id: 2, wasm, blocks: encodeRequest(specimenFromPreset("lychee")) });
	expect(messages[1].message).toMatchObject({
		type: "failed",
		id: 1,
		reason: "syntax",
		line: 1,
		column: expect.any(Number),
	});
	expect(messages[2].message).toMatchObject({ type: "grown", id: 2 });
});

it("keeps a core for each module", async () => {
	const { messages, report } = worker();
	await report({ type: "start", wasm, module });
	await report({ type: "grow", id: 1, wasm: "leaf.wasm", blocks: encodeRequest(specimenFromPreset("rubus")) });
	expect(messages[1].message).toMatchObject({ type: "trapped", id: 1 });
	await report({ type: "start", wasm: "leaf.wasm", module });
	await report({ type: "grow", id: 2, wasm: "leaf.wasm", blocks: encodeRequest(specimenFromPreset("rubus")) });
	expect(messages[3].message).toMatchObject({ type: "grown", id: 2 });
});

it("tells when the core is none", async () => {
	const { messages, report } = worker();
	const empty = await WebAssembly.compile(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0));
	await report({ type: "start", wasm, module: empty });
	expect(messages.map(({ message }) => message.type)).toEqual(["broken"]);
	await report({ type: "grow", id: 1, wasm, blocks: [] });
	expect(messages[1].message).toMatchObject({ type: "trapped", id: 1 });
});
