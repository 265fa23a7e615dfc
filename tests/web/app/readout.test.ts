import { expect, it } from "vitest";
import { inWords, shownNotes } from "../../../web/src/app/parts/readout";
import type { Specimen } from "../../../web/src/specimen/specimen";

it.each([
	["leaves", "Leaves"],
	["endStructures", "End structures"],
	["end_structures", "End structures"],
])("has words for a count called %s", (key, words) => expect(inWords(key)).toBe(words));

it("leaves out notes on lines of a preset's text, which the user has not seen", () => {
	const onLine = {
		code: "core.expression.at_line",
		args: { line: 42, problem: "unjoined" },
		text: "Line 42: unjoined",
	};
	const limit = { code: "core.flower.limit", args: {}, text: "The limit was reached" };
	const plant = { notes: [onLine.text, limit.text, "Another note"], noteMessages: [onLine, limit] };
	const preset = { model: "flower", preset: "tulip" } as Specimen;
	expect(shownNotes(plant, preset)).toEqual([limit.text, "Another note"]);
	expect(shownNotes(plant, { ...preset, grammar: "#axiom: A" } as Specimen)).toEqual(plant.notes);
});
