import { describe, expect, it, vi } from "vitest";
import { cane } from "../../../../../web/src/models/bunch/ui/cane";
import type { BunchContext } from "../../../../../web/src/models/bunch/ui/context";
import { type Specimen, specimenFromPreset, withParameters } from "../../../bunch";

function contextWith(specimen: Specimen) {
	const set = vi.fn();
	return { context: { state: { specimen }, set } as unknown as BunchContext, set };
}

describe("the cane's button", () => {
	it("hangs a bare bunch on a cane with two leaves, and takes both away again", () => {
		const bare = contextWith(specimenFromPreset("riesling"));
		expect(cane.button?.pressed?.(bare.context)).toBe(false);
		cane.press?.(bare.context);
		expect(bare.set).toHaveBeenCalledWith({ parameters: { cane: 1, leaves: 2 } });
		for (const parameters of [{ cane: 1, leaves: 0 }, { leaves: 4 }]) {
			const hung = contextWith(withParameters(specimenFromPreset("riesling"), parameters));
			expect(cane.button?.pressed?.(hung.context)).toBe(true);
			cane.press?.(hung.context);
			expect(hung.set).toHaveBeenCalledWith({ parameters: { cane: 0, leaves: 0 } });
		}
	});

	it("is there for natural bunches alone, and pressed when the page opens", () => {
		expect(cane.applies?.(specimenFromPreset())).toBe(true);
		expect(cane.button?.pressed?.(contextWith(specimenFromPreset()).context)).toBe(true);
		expect(cane.applies?.(specimenFromPreset(undefined, 1))).toBe(false);
	});
});
