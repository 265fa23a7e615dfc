import { afterEach, describe, expect, it, vi } from "vitest";
import type { Core } from "../../../web/src/core/core";
import { CoreCache } from "../../../web/src/core/cores";
import { CoreError, CoreTrap } from "../../../web/src/core/errors";

const SMALL = 1024;
const LARGE = 512 * 1024 * 1024;

/** Cores that return prepared answers, one after the other. */
function reported(...doings: (() => unknown)[]) {
	const grow = vi.fn(() => (doings.shift() ?? (() => "grown"))());
	const memory = { bytes: SMALL };
	const load = vi.fn(
		async () =>
			({
				grow,
				get memoryBytes() {
					return memory.bytes;
				},
			}) as unknown as Core,
	);
	return { cores: new CoreCache(load), load, memory };
}
const fails = (error: Error) => () => {
	throw error;
};
afterEach(() => void vi.restoreAllMocks());

describe("cores of a thread", () => {
	it("are loaded once for each module, also when asked at once", async () => {
		const { cores, load } = reported();
		await Promise.all([cores.grow("a.wasm", []), cores.grow("a.wasm", []), cores.grow("b.wasm", [])]);
		await cores.grow("a.wasm", []);
		expect(load.mock.calls).toEqual([["a.wasm"], ["b.wasm"]]);
	});

	it("stay after a request that cannot be grown, and are replaced once broken", async () => {
		const { cores, load } = reported(fails(new CoreError("syntax", "No.")), fails(new CoreTrap("Broke.")));
		await expect(cores.grow("a.wasm", [])).rejects.toThrow("No.");
		expect(load).toHaveBeenCalledTimes(1);
		await expect(cores.grow("a.wasm", [])).rejects.toThrow("Broke.");
		expect(await cores.grow("a.wasm", [])).toBe("grown");
		expect(load).toHaveBeenCalledTimes(2);
	});

	it.each([
		["grown", () => "grown"],
		["refused", fails(new CoreError("limit", "Too large."))],
	])("are dropped with the memory of a very large plant that is %s", async (_, outcome) => {
		const { cores, load, memory } = reported(outcome);
		memory.bytes = LARGE;
		await cores.grow("a.wasm", []).catch(() => {});
		memory.bytes = SMALL;
		await cores.grow("a.wasm", []);
		await cores.grow("a.wasm", []);
		expect(load).toHaveBeenCalledTimes(2);
	});

	it("that could not be loaded are asked for again", async () => {
		const { cores, load } = reported();
		load.mockRejectedValueOnce(new Error("away"));
		await expect(cores.grow("a.wasm", [])).rejects.toThrow("away");
		expect(await cores.grow("a.wasm", [])).toBe("grown");
	});
});
