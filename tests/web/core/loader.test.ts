import { afterEach, expect, it, vi } from "vitest";
import { UnsupportedError } from "../../../web/src/core/errors";
import { compileCore } from "../../../web/src/core/loader";

/** The smallest module there is. */
const EMPTY = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

const serve = (body: Uint8Array<ArrayBuffer> | string, type: string | null, status = 200) => {
	const headers = new Headers();
	if (type !== null) headers.set("content-type", type);
	const response = new Response(typeof body === "string" ? new TextEncoder().encode(body) : body, { status, headers });
	vi.stubGlobal("fetch", async () => response);
};

afterEach(() => vi.unstubAllGlobals());

it("compiles what is served under its own type, without a word", async () => {
	serve(EMPTY, "application/wasm");
	const note = vi.fn();
	expect(await compileCore("core.wasm", note)).toBeInstanceOf(WebAssembly.Module);
	expect(note).not.toHaveBeenCalled();
});

it("compiles what is served under another type, and notes it", async () => {
	for (const type of ["application/octet-stream", "text/plain", "application/wasm; charset=utf-8", null]) {
		serve(EMPTY, type);
		const note = vi.fn();
		expect(await compileCore("core.wasm", note)).toBeInstanceOf(WebAssembly.Module);
		expect(note).toHaveBeenCalledOnce();
		expect(note.mock.calls[0][0]).toContain("application/wasm");
	}
});

it("names a page that came in the core's place", async () => {
	for (const type of ["text/html", "application/wasm"]) {
		serve("<!doctype html>", type);
		const loading = compileCore("core.wasm");
		await expect(loading).rejects.toMatchObject({ name: "UnsupportedError", missing: "core" });
		await expect(loading).rejects.toThrow(type);
	}
});

it("names a server that has no core", async () => {
	serve("not here", "text/plain", 404);
	await expect(compileCore("core.wasm")).rejects.toMatchObject({
		missing: "fetch",
		message: expect.stringContaining("404"),
	});
});

it("names a connection that fails", async () => {
	vi.stubGlobal("fetch", async () => {
		throw new TypeError("Failed to fetch");
	});
	await expect(compileCore("core.wasm")).rejects.toMatchObject({ missing: "fetch" });
});

it("names a browser without WebAssembly", async () => {
	vi.stubGlobal("WebAssembly", undefined);
	await expect(compileCore("core.wasm")).rejects.toBeInstanceOf(UnsupportedError);
	await expect(compileCore("core.wasm")).rejects.toMatchObject({ missing: "webassembly" });
});

it("names a connection that breaks half-way", async () => {
	for (const type of ["application/wasm", "text/plain"]) {
		const body = new ReadableStream({
			start(controller) {
				controller.enqueue(EMPTY.slice(0, 4));
				controller.error(new TypeError("network error"));
			},
		});
		vi.stubGlobal("fetch", async () => new Response(body, { headers: { "content-type": type } }));
		await expect(compileCore("core.wasm")).rejects.toMatchObject({ missing: "fetch" });
	}
});

it("names what begins as a core does and is none", async () => {
	for (const type of ["text/plain", "application/wasm"]) {
		serve(Uint8Array.of(...EMPTY.slice(0, 4), 9, 9, 9, 9), type);
		const loading = compileCore("core.wasm");
		await expect(loading).rejects.toMatchObject({ name: "UnsupportedError", missing: "core" });
		await expect(loading).rejects.toThrow(type);
	}
});
