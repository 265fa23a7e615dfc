import { describe, expect, it } from "vitest";
import { titleOf } from "../../../../web/src/app/title";
import type { Leaf } from "../../../../web/src/models/leaf/grown";
import { model } from "../../../../web/src/models/leaf/index";
import { leafFromPreset } from "../../../../web/src/models/leaf/schema";
import { leafInWords } from "../../../../web/src/models/leaf/words";
import type { Model } from "../../../../web/src/models/model";

const maple = leafFromPreset("maple");
const traced = { ...maple, outline: leafFromPreset("oak").outline };
const leaf = { chart: new Float32Array(4), margin: Float32Array.of(0, 0, 1, 0, 0, 1), counts: { particles: 1 } };

describe("a leaf's name", () => {
	it("has its preset's name as long as it has its outline", () => {
		const longer = { ...maple, parameters: { ...maple.parameters, length: 50 } };
		expect(leafInWords(leaf as unknown as Leaf, longer)).toMatch(/^Maple leaf, 13 cm²/);
		expect(leafInWords(leaf as unknown as Leaf, traced)).toMatch(/^Leaf with an outline of its own, 66 cm²/);
	});

	it("is altered in title and tab with another outline, not with another seed", () => {
		const leafModel = model as unknown as Model;
		expect(titleOf({ ...maple, seed: 9 }, leafModel)).toBe("Maple");
		expect(titleOf(traced, leafModel)).toBe("Maple (edited)");
	});
});
