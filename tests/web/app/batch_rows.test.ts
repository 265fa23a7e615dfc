import { describe, expect, it } from "vitest";
import {
	acceptedText,
	type BatchRow,
	type BatchSetting,
	constantsOf,
	readRow,
	rowFor,
	settingGroups,
	withVariation,
} from "../../../web/src/app/files/batch_rows";
import { readVary } from "../../../web/src/batch/vary";
import { modelNamed } from "../../../web/src/models/index";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { restore } from "../../../web/src/specimen/restore";

/** The settings of a preset, as the batch dialog offers them. */
async function settingsOf(name: string, preset: string, record = {}) {
	const model = await modelNamed(name);
	const { specimen } = restore(model, record, fromPreset(model, preset));
	const plant = { model, specimen };
	const groups = settingGroups(plant, await constantsOf(plant));
	const setting = (key: string): BatchSetting => {
		const found = groups.flatMap(({ settings }) => settings).find((each) => each.key === key);
		if (!found) throw new Error(`${key} is not offered.`);
		return found;
	};
	/** The values that `--vary` reads from a row. */
	const vary = (row: BatchRow) => {
		const read = readRow(setting(row.key), row);
		if ("problem" in read) return read;
		const { entry: _, ...values } = readVary(model, read.vary, specimen)[0];
		return values;
	};
	return { ...plant, groups, setting, vary };
}

const bunch = await settingsOf("bunch", "lychee");
const range = (key: string, from: string, to: string): BatchRow => ({ key, variation: "range", values: [from, to] });

describe("the settings that a batch can vary", () => {
	it("are those that apply to the plant, by their labels in the groups of the panel", () => {
		expect(bunch.groups.map(({ title }) => title).slice(0, 4)).toEqual(["Shape", "Method", "Berries", "Age"]);
		const labels = bunch.groups.flatMap(({ settings }) => settings).map(({ label }) => label);
		expect(labels).toContain("Sun height");
		expect(labels).toContain("Skin colour");
		// A parameter of the paper's procedure.
		expect(labels).not.toContain("Sagging");
		expect(new Set(labels).size).toBe(labels.length);
	});

	it("include the constants of a grammar, except those that a parameter governs", async () => {
		const { groups, vary } = await settingsOf("grammar", "bush", { grammar: "#define angle 30\naxiom: F(angle)" });
		expect(groups.at(-1)).toMatchObject({ title: "Constants of the grammar", settings: [{ key: "angle" }] });
		expect(vary(range("angle", "-12.345", "30"))).toEqual({ own: true, from: -12.345, to: 30 });
		expect(vary(range("angle", "", "30"))).toEqual({ problem: "Enter a number, for example 0.5.", at: 0 });
		const growth = await settingsOf("growth", "oak");
		expect(growth.groups.map(({ title }) => title)).not.toContain("Constants of the grammar");
	});
});

describe("a row", () => {
	it("is written in degrees and percent as typed, with a decimal comma too", () => {
		expect(bunch.vary(range("sun_height", "12,5", "40"))).toEqual({ from: 12.5, to: 40 });
		expect(bunch.vary(range("age", "60", "110"))).toEqual({ from: 60, to: 110 });
	});

	it("converts the millimetres of the panel to the units of the table", () => {
		const setting = bunch.setting("l");
		if (setting.kind !== "number") throw new Error("The length is a number.");
		const { per, unit } = setting.scale;
		expect(unit).toBe("mm");
		expect(per).not.toBe(1);
		const read = bunch.vary(range("l", String(100 * per), String(200 * per)));
		expect(read).toEqual({ from: 100, to: 200 });
		const shown =
			setting.entry?.max === undefined
				? ""
				: acceptedText(setting, range("l", "", ""), String(setting.entry.max * per));
		expect(bunch.vary(range("l", shown, shown))).toEqual({ from: setting.entry?.max, to: setting.entry?.max });
	});

	it("takes a list, a fixed number, options and colours", async () => {
		expect(bunch.vary({ key: "age", variation: "list", values: ["60; 75 90,5"] })).toEqual({
			values: ["60", "75", "90.5"],
		});
		expect(bunch.vary({ key: "age", variation: "fixed", values: ["60"] })).toEqual({ values: ["60"] });
		expect(bunch.vary({ key: "fruit", variation: "list", values: ["grape", "duku"] })).toEqual({
			values: ["grape", "duku"],
		});
		expect(bunch.vary({ key: "skin", variation: "list", values: ["43264f"] })).toEqual({ values: ["43264f"] });
		const stand = await settingsOf("stand", "orchard");
		expect(stand.vary({ key: "many", variation: "list", values: ["auto 40"] })).toEqual({ values: ["0", "40"] });
	});

	it("says how to correct it, in the units of the panel", () => {
		expect(bunch.vary(range("sun_height", "10", "91"))).toEqual({ problem: "Enter a number from 0 to 90 °.", at: 1 });
		expect(bunch.vary(range("sun_height", "x", "9"))).toEqual({ problem: "Enter a number from 0 to 90 °.", at: 0 });
		expect(bunch.vary(range("sun_height", "50", "40"))).toEqual({
			problem: "The second number must not be smaller than the first. Change one of them.",
			at: 1,
		});
		expect(bunch.vary(range("count", "20.5", "40"))).toMatchObject({
			problem: expect.stringMatching(/^Enter a whole number from \d+ to \d+\.$/),
		});
		expect(bunch.vary({ key: "age", variation: "list", values: ["60 900"] })).toMatchObject({ at: 0 });
		expect(bunch.vary({ key: "age", variation: "list", values: [" "] })).toMatchObject({
			problem: "Enter at least one number.",
		});
		expect(bunch.vary({ key: "fruit", variation: "list", values: [] })).toMatchObject({
			problem: "Choose at least one option.",
		});
	});

	it("shows the accepted number after typing, and unusable text as typed", () => {
		const { setting } = bunch;
		expect(acceptedText(setting("age"), range("age", "", ""), "60,126")).toBe("60.13");
		expect(acceptedText(setting("age"), range("age", "", ""), "900")).toBe("900");
		// Between 0 and 0.3 there is no second bunch.
		expect(acceptedText(setting("wing"), range("wing", "", ""), "0.1")).toBe("0.3");
		const list: BatchRow = { key: "age", variation: "list", values: [""] };
		expect(acceptedText(setting("age"), list, " 60  75;90 ")).toBe("60; 75; 90");
	});

	it("begins with usable values, for every setting of every model", async () => {
		for (const name of ["bunch", "leaf", "tree", "root", "growth", "flower", "stand"]) {
			const model = await modelNamed(name);
			const plant = await settingsOf(name, model.presets.standard);
			for (const setting of plant.groups.flatMap(({ settings }) => settings)) {
				if (setting.kind === "number" && !setting.entry) continue;
				const row = rowFor(plant, setting);
				expect(plant.vary(row), setting.key).not.toHaveProperty("problem");
				const list = setting.kind === "number" ? withVariation(row, "list") : row;
				expect(plant.vary(list), setting.key).not.toHaveProperty("problem");
			}
		}
	});

	it("keeps its numbers when the kind of variation changes", () => {
		const row = range("age", "60", "110");
		expect(withVariation(row, "list").values).toEqual(["60; 110"]);
		expect(withVariation(row, "fixed").values).toEqual(["60"]);
		expect(withVariation(withVariation(row, "fixed"), "range").values).toEqual(["60", "60"]);
		expect(withVariation(withVariation(row, "list"), "fixed").values).toEqual(["60"]);
	});
});
