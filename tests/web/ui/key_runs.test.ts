import { describe, expect, it, vi } from "vitest";
import { HeldKey } from "../../../web/src/ui/held_key";
import { KeyRuns } from "../../../web/src/ui/key_runs";

describe("runs of key presses", () => {
	it("continue while presses follow each other on one object, and have unique names", () => {
		const [runs, others] = [new KeyRuns(), new KeyRuns()];
		const first = runs.press("p3", 0);
		expect(runs.press("p3", 900)).toBe(first);
		expect(runs.press("p3", 1800)).toBe(first);
		const later = runs.press("p3", 2900);
		const elsewhere = runs.press("p4", 3000);
		expect(new Set([first, later, elsewhere, others.press("p4", 3000)]).size).toBe(4);
	});

	it("of a slider include its keys, but not its drags", () => {
		const settle = vi.fn();
		const held = new HeldKey(settle);
		const down = (key: string) => held.down({ key } as KeyboardEvent);
		down("a");
		expect(held.run).toBeUndefined();
		down("ArrowRight");
		const run = held.run;
		held.up();
		expect([held.run, settle.mock.calls.length]).toEqual([undefined, 1]);
		down("ArrowRight");
		expect(held.run).toBe(run);
		held.up();
		down("ArrowLeft");
		expect(held.run).toBe(run);
		held.up();
		down("PageUp");
		expect(held.run).not.toBe(run);
	});
});
