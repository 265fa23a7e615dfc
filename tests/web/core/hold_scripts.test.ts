import { afterEach, expect, it, vi } from "vitest";
import { holdScripts } from "../../../web/src/core/hold_scripts";

const script = "https://plants.example/app/assets/embed-1.js";
afterEach(() => vi.unstubAllGlobals());

it("holds a lock by the script's address, with others, for as long as the page lives", async () => {
	const request = vi.fn((_: string, __: LockOptions, held: () => Promise<unknown>) => held());
	vi.stubGlobal("navigator", { locks: { request } });
	holdScripts(script);
	expect(request).toHaveBeenCalledExactlyOnceWith(script, { mode: "shared" }, expect.any(Function));
	const ended = await Promise.race([
		request.mock.results[0].value,
		new Promise((resolve) => setTimeout(resolve, 5, "held")),
	]);
	expect(ended).toBe("held");
});

it("does without where there are no locks, or a frame may request none", async () => {
	vi.stubGlobal("navigator", {});
	holdScripts(script);
	const request = vi.fn(() => Promise.reject(new DOMException("sandboxed", "SecurityError")));
	vi.stubGlobal("navigator", { locks: { request } });
	holdScripts(script);
	expect(request).toHaveBeenCalledOnce();
	// An unhandled rejection would fail the run.
	await new Promise((resolve) => setTimeout(resolve));
});
