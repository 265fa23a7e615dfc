import { describe, expect, it } from "vitest";
import { LEAF_TABLE } from "../../../../web/src/models/leaf/table";
import { ROOT_TABLE } from "../../../../web/src/models/root/table";
import { TREE_TABLE } from "../../../../web/src/models/tree/table";
import type { CoreEntry } from "../../../../web/src/specimen/table";

describe.each([LEAF_TABLE, TREE_TABLE, ROOT_TABLE])("the energies of a table", (table) => {
	it("add up exactly in float32 where they are whole, however many there are", () => {
		const [particles, energy] = ["particles", "energy"].map((key) => (table.entry(key) as CoreEntry).max);
		expect(particles * energy).toBeLessThan(2 ** 24);
	});
});
