import { describe, expect, it } from "vitest";
import { FLOWER_TABLE } from "../../../web/src/models/flower/table";
import { STAND } from "../../../web/src/models/stand/schema";
import {
	displayedNumber,
	displayedText,
	displayScaleOf,
	parseDisplayed,
	rangeInWords,
} from "../../../web/src/specimen/lengths";
import type { NumberEntry, ParameterEntry } from "../../../web/src/specimen/table";
import { BUNCH, entryOf, specimenFromPreset, withParameters } from "../bunch";

const scale = (key: string, unit = 0.25) =>
	displayScaleOf(BUNCH, withParameters(specimenFromPreset(), { unit }), entryOf(key) as ParameterEntry);

describe("lengths in units of the paper", () => {
	it("are read in millimetres, by the specimen's scale", () => {
		expect(displayedNumber(scale("l"), 348)).toBe(150);
		expect(displayedNumber(scale("l", 0.5), 348)).toBe(300);
		expect(displayedNumber(scale("wi"), 15)).toBe(3.75);
		expect(scale("p3w")).toMatchObject({ unit: "mm", decimals: 1 });
	});

	it("are so where the panel explains them; what is in millimetres or no length stays what it is", () => {
		const { parameters } = specimenFromPreset();
		const number = (key: string) => BUNCH.table.entry(key) as NumberEntry;
		expect(rangeInWords(number("l"), scale("l"))).toMatch(/12\.5 … 250 mm\.$/);
		expect(displayedText(number("l"), scale("l"), parameters.l)).toBe("220.7");
		expect(rangeInWords(number("size"), scale("size"))).toMatch(/3 … 60 mm\.$/);
		expect(displayedText(number("density"), scale("density"), parameters.density)).toBe("7");
	});

	it("0 is read as what it leaves to the text, where it does", () => {
		const scale = { per: 1, unit: "", decimals: 2 };
		expect(displayedText(STAND.table.entry("many") as NumberEntry, scale, 0)).toBe("auto");
		expect([displayedText({ zero: "auto" }, scale, 3), displayedText({}, scale, 0)]).toEqual(["3", "0"]);
	});
});

it("a word that stands for 0 is read, told with the range, and typed", () => {
	const entry = FLOWER_TABLE.entry("steps") as NumberEntry;
	const scale = displayScaleOf({}, undefined as never, entry);
	expect(displayedText(entry, scale, 0)).toBe("auto");
	expect(rangeInWords(entry, scale)).toBe("Whole numbers, 0 (auto) … 400.");
	expect([" Auto ", "automatic", "3"].map((text) => parseDisplayed(entry, text, Number(text)))).toEqual([
		0,
		Number.NaN,
		3,
	]);
	const age = FLOWER_TABLE.entry("age") as NumberEntry;
	expect(rangeInWords(age, scale)).toBe("0 … 2.");
	expect(parseDisplayed(age, "auto", Number.NaN)).toBeNaN();
});
