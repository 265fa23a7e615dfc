import { describe, expect, it } from "vitest";
import { applying, groupsFor } from "../../../web/src/app/panel_groups";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { NO_PARAMETER } from "../../../web/src/ui/quantity";
import type { Tool } from "../../../web/src/ui/tool";
import { BUNCH, specimenFromPreset } from "../bunch";
import { toy } from "../toy";
import { studioWith } from "./context";

const keysOf = (groups: ReturnType<typeof groupsFor>) => groups.map(({ group }) => group.key);
const entriesOf = (groups: ReturnType<typeof groupsFor>) =>
	groups.flatMap(({ entries }) => entries.map(({ key }) => key));

describe("the panel's groups", () => {
	it("hold the active parameters in the table's order, and no empty group", () => {
		expect(entriesOf(groupsFor(toy.table, fromPreset(toy), []))).toEqual(["height", "flag", "paint"]);
		expect(entriesOf(groupsFor(toy.table, fromPreset(toy, "märz"), []))).toEqual(["height", "flag", "wind", "paint"]);
		expect(keysOf(groupsFor(toy.table, fromPreset(toy), []))).toEqual(["pole"]);
	});

	it("leave out parameters of tools, and place the tools above or below", () => {
		const above: Tool = {
			name: "a",
			initial: 0,
			parameters: ["height"],
			panel: { group: "pole", place: "above", draw: () => "" },
		};
		const below: Tool = { name: "b", initial: 0, panel: { group: "rest", place: "below", draw: () => "" } };
		const [pole, rest] = groupsFor(toy.table, fromPreset(toy), [above, below]);
		expect(pole.entries.map(({ key }) => key)).toEqual(["flag", "paint"]);
		expect([pole.above, pole.below]).toEqual([[above], []]);
		expect([rest.entries, rest.below]).toEqual([[], [below]]);
	});

	it("of tools come before the table's, or at the end", () => {
		const brought = (key: string, last: boolean): Tool => ({
			name: key,
			initial: 0,
			panel: { group: { key, title: key, help: "", last }, place: "above", draw: () => "" },
		});
		const tools = [brought("end", true), brought("front", false)];
		expect(keysOf(groupsFor(toy.table, fromPreset(toy), tools))).toEqual(["front", "pole", "end"]);
	});

	it("begin with the basics in their order, which no other group repeats", () => {
		const quantity: Tool = {
			name: "size",
			initial: 0,
			quantities: () => [
				{
					...NO_PARAMETER,
					key: "girth",
					label: "Girth",
					help: "",
					kind: "number",
					unit: "m",
					min: 0,
					max: 9,
					step: 1,
					read: () => 2,
					change: () => ({}),
				},
			],
		};
		const specimen = specimenFromPreset();
		const groups = groupsFor(BUNCH.table, specimen, [quantity]);
		expect(keysOf(groups)[0]).toBe("basics");
		expect(groups[0].entries.map(({ key }) => key)).toEqual([
			"girth",
			"l",
			"count",
			"size",
			"density",
			"elongation",
			"skin",
			"stem",
		]);
		const others = entriesOf(groups.slice(1));
		expect(others).toEqual(expect.arrayContaining(["p3w", "seeds"]));
		for (const { key } of groups[0].entries) expect(others).not.toContain(key);
	});

	it("of a bunch show the parameters of its procedure; the age is in the bar below the view", async () => {
		const { studio } = await studioWith(specimenFromPreset());
		const shown = (version: number) => {
			const specimen = specimenFromPreset(undefined, version);
			return groupsFor(BUNCH.table, specimen, applying(studio.state.modelUi?.tools, specimen));
		};
		expect(keysOf(shown(1))).toEqual(expect.arrayContaining(["interaction", "branching"]));
		expect(keysOf(shown(1))).not.toContain("age");
		expect(keysOf(shown(2))).not.toContain("interaction");
		expect(keysOf(shown(2))).toContain("age");
		expect(entriesOf(shown(2))).not.toContain("age");
		expect(entriesOf(shown(2))).toContain("sun");
		expect(keysOf(shown(2))[0]).toBe("basics");
	});
});
