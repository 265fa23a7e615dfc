/** Runs before each file of vitest's tests. */
import fc from "fast-check";
import { afterAll, inject, vi } from "vitest";

fc.configureGlobal({ ...fc.readConfigureGlobal(), seed: inject("propertySeed") ?? 1 });

/** Milliseconds, less than a test may take. */
const PATIENCE = 240_000;
const DEFAULT = Symbol.for("panicle.waitFor");
type WaitFor = typeof vi.waitFor & { [DEFAULT]?: true };

/** vitest waits for a second by default: that would fail on a busy machine. The file before may have set this on the same `vi`. */
if (!(vi.waitFor as WaitFor)[DEFAULT]) {
	const { waitFor } = vi;
	const patient: WaitFor = (callback, options) => waitFor(callback, options ?? { timeout: PATIENCE });
	patient[DEFAULT] = true;
	vi.waitFor = patient;
}

// Nothing is left behind for the next file of the thread.
afterAll(() => {
	vi.useRealTimers();
	vi.restoreAllMocks();
	vi.unstubAllGlobals();
	vi.unstubAllEnvs();
});
