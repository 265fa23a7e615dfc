/** Runs before each file of vitest's tests: the seed of property tests, and nothing left behind for the next file of the thread. */
import fc from "fast-check";
import { afterAll, inject, vi } from "vitest";

fc.configureGlobal({ ...fc.readConfigureGlobal(), seed: inject("propertySeed") ?? 1 });

afterAll(() => {
	vi.useRealTimers();
	vi.restoreAllMocks();
	vi.unstubAllGlobals();
	vi.unstubAllEnvs();
});
