import { describe, expect, it } from "vitest";
import { DEFAULT_PRESET, PRESETS } from "../../../web/src/models/bunch/presets/presets";
import { entryOf, presetNamed, restore, specimenFromPreset } from "../bunch";
import { TABLE_3 } from "./table_3";

describe("presets", () => {
	it("begin with the paper's fifteen, in the order of the gallery", () => {
		const names =
			"short-conical shouldered-conical long-conical cylindrical winged-cylindrical double-bunch-winged grape-15a " +
			"grape-15b grape-15c grape-15d redcurrant rubus lychee longan duku";
		const published = PRESETS.slice(0, 15);
		expect(published.map((preset) => preset.name).join(" ")).toBe(names);
		expect(published.map((preset) => preset.kind)).toEqual([
			...Array(6).fill("shape"),
			...Array(4).fill("figure"),
			...Array(5).fill("fruit"),
		]);
		for (const { figure } of published) expect(figure).toMatch(/^\d/);
	});

	it("go on with named varieties, each with a name and a title of its own", () => {
		const varieties = PRESETS.slice(15);
		expect(varieties.length).toBeGreaterThanOrEqual(12);
		for (const variety of varieties) {
			expect(variety.kind).toBe("variety");
			expect(variety.name).toMatch(/^[a-z]+(-[a-z]+)*$/);
			expect(variety.about).toMatch(/^[^\n]{10,90}\.$/);
			expect(variety.look.skin).toBeDefined();
		}
		expect(new Set(PRESETS.map(({ name }) => name)).size).toBe(PRESETS.length);
		expect(new Set(PRESETS.map(({ title }) => title)).size).toBe(PRESETS.length);
	});

	it.each(TABLE_3)("$name has the profile of Table 3", ({ name, l, sides }) => {
		const { parameters } = specimenFromPreset(name);
		expect(parameters.l).toBe(l);
		expect([parameters.p3w, parameters.p3r]).toEqual(sides[0].slice(0, 2));
		expect([parameters.p4w, parameters.p4r]).toEqual(sides[1].slice(0, 2));
		expect([parameters.p5w, parameters.p5r]).toEqual(sides[2].slice(0, 2));
		expect([parameters.p6w, parameters.p6r]).toEqual(sides[3].slice(0, 2));
		expect(parameters.wing).toBe(0);
	});

	it.each(PRESETS)("$name holds only what differs from the table, all of it in range", (preset) => {
		for (const [key, value] of Object.entries({ ...preset.parameters, ...preset.look })) {
			expect(entryOf(key)?.default).not.toBe(value);
		}
		expect(restore(preset.parameters).notes).toEqual([]);
		expect(restore(preset.look).notes).toEqual([]);
		expect(restore({ v: 2, preset: preset.name })).toEqual({ specimen: specimenFromPreset(preset.name), notes: [] });
	});

	it("double-bunch-winged has a second bunch of six tenths", () => {
		expect(presetNamed("double-bunch-winged")?.parameters.wing).toBe(0.6);
	});

	it("fruits other than grapes come out at their own size, in millimetres across", () => {
		const across = (name: string) => {
			const { unit, rmin, rmax } = specimenFromPreset(name).parameters;
			return (rmin + rmax) * unit;
		};
		expect(across(DEFAULT_PRESET)).toBeCloseTo(12.5);
		expect(across("redcurrant")).toBeCloseTo(9);
		expect(across("rubus")).toBeCloseTo(14);
		expect(across("lychee")).toBeCloseTo(30);
		expect(across("longan")).toBeCloseTo(25);
		expect(across("duku")).toBeCloseTo(34.4);
	});

	it("gives fresh specimens that share nothing", () => {
		const one = specimenFromPreset("duku");
		one.parameters.l = 100;
		one.look.skin = "000000";
		expect(specimenFromPreset("duku")).not.toEqual(one);
		expect(specimenFromPreset("no such preset")).toEqual(specimenFromPreset(DEFAULT_PRESET));
	});
});
