import { describe, expect, it } from "vitest";
import { PROCEDURES } from "../../../web/src/models/bunch/grown";
import { PARAMETERS } from "../../../web/src/models/bunch/parameters.generated";
import { groupsFor } from "../../../web/src/studio/panel_groups";

const keys = (procedure: (typeof PROCEDURES)[number]) =>
	groupsFor(procedure).flatMap(({ infos }) => infos.map(({ key }) => key));

describe("the panel's groups", () => {
	it.each(PROCEDURES)("holds what %s heeds, and nothing else", (procedure) => {
		const heeded = PARAMETERS.filter((info) => info.procedure === undefined || info.procedure === procedure);
		const elsewhere = procedure === "natural" ? ["age"] : [];
		const expected = heeded.map(({ key }) => key).filter((key) => !elsewhere.includes(key));
		expect(keys(procedure).sort()).toEqual(expected.sort());
	});

	it("shows the paper's groups with the paper's procedure alone", () => {
		const groups = (procedure: (typeof PROCEDURES)[number]) => groupsFor(procedure).map(({ group }) => group.key);
		expect(groups("paper")).toContain("interaction");
		expect(groups("natural")).not.toContain("interaction");
		expect(groups("natural")).toContain("age");
		expect(groups("paper")).not.toContain("age");
	});
});
