import { expect, it, vi } from "vitest";
import { SharedPool } from "../../../web/src/core/page_pool";
import type { Pool } from "../../../web/src/core/pool";
import { PageRuntime } from "../../../web/src/library/page_runtime";

function runtimes() {
	const run = vi.fn(async () => {});
	return { run, runtime: new PageRuntime(new SharedPool(() => ({ run, close: vi.fn() }) as unknown as Pool)) };
}

it("requests a core by its address, and passes the signal that cancels", () => {
	const { runtime, run } = runtimes();
	const { signal } = new AbortController();
	void runtime.grow("bunch.wasm", [], signal);
	expect(run).toHaveBeenCalledWith({ wasm: expect.stringMatching(/bunch.*\.wasm/), blocks: [] }, { signal });
});

it("rejects a core that was not built", async () => {
	const { runtime } = runtimes();
	await expect(runtime.grow("fern.wasm", [])).rejects.toThrow("There is no core fern.wasm.");
});
