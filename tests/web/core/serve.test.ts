import { beforeAll, expect, it } from "vitest";
import type { FromWorker, ToWorker } from "../../../web/src/core/messages";
import { encodeRequest } from "../../../web/src/models/bunch/request";
import { serve } from "../../../web/src/core/serve";
import { specimenFromPreset } from "../../../web/src/specimen/from_preset";
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

it("is ready once the core lives, and answers even what came before", async () => {
	const { said, tell } = worker();
	const request = encodeRequest(specimenFromPreset("rubus"));
	await Promise.all([tell({ type: "start", module }), tell({ type: "grow", id: 4, request })]);
	expect(said.map(({ message }) => message.type)).toEqual(["ready", "grown"]);
	expect(said[1].message).toMatchObject({ id: 4, grown: { counts: { berries: expect.any(Number) } } });
	expect(said[1].transfer.length).toBeGreaterThan(10);
});

it("tells why something cannot be grown, and goes on", async () => {
	const { said, tell } = worker();
	await tell({ type: "start", module });
	await tell({ type: "grow", id: 1, request: encodeRequest({ ...specimenFromPreset(), grammar: "axiom: (" }) });
	await tell({ type: "grow", id: 2, request: encodeRequest(specimenFromPreset("lychee")) });
	expect(said[1].message).toMatchObject({
		type: "failed",
		id: 1,
		reason: "syntax",
		line: 1,
		column: expect.any(Number),
	});
	expect(said[2].message).toMatchObject({ type: "grown", id: 2 });
});

it("tells when the core is none", async () => {
	const { said, tell } = worker();
	await tell({ type: "start", module: await WebAssembly.compile(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0)) });
	expect(said.map(({ message }) => message.type)).toEqual(["broken"]);
	await tell({ type: "grow", id: 1, request: new Uint8Array(44) });
	expect(said[1].message).toMatchObject({ type: "trapped", id: 1 });
});
