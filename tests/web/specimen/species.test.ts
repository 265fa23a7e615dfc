/** The document over another model's table and details than the bunch's. */
import { describe, expect, it } from "vitest";
import { withLook, withParameters } from "../../../web/src/specimen/edit";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import * as histories from "../../../web/src/specimen/history";
import {
	decodeLink,
	decodeQuery,
	encodeLink,
	encodeQuery,
	hasPacked,
	modelInQuery,
} from "../../../web/src/specimen/link";
import { modelIn, restore } from "../../../web/src/specimen/restore";
import { growsAlike, sameSpecimen } from "../../../web/src/specimen/same";
import type { Specimen } from "../../../web/src/specimen/specimen";
import { writtenSpecimen } from "../../../web/src/specimen/written";
import { specimenFromPreset } from "../bunch";
import { toy } from "../toy";

const texts = (notes: readonly { text: string }[]) => notes.map(({ text }) => text);

describe("a specimen of any model", () => {
	it("is complete from its preset, details included, and shares nothing with it", () => {
		const march = fromPreset(toy, "märz");
		expect(march).toEqual({
			v: 2,
			model: "toy",
			preset: "märz",
			seed: 1,
			parameters: { height: 4, flag: 1, wind: 7 },
			look: { paint: "ff0000" },
			motto: "Vorwärts",
		});
		march.motto = "Back";
		expect(fromPreset(toy, "märz").motto).toBe("Vorwärts");
		expect(fromPreset(toy, "april")).toEqual(fromPreset(toy));
	});

	it("names its model in links and files, and comes back by them", async () => {
		const tall = { ...withParameters(toy, fromPreset(toy, "märz"), { height: 6.5, wind: 4 }), seed: 9 };
		expect(encodeQuery(toy, tall)).toBe("?v=2&model=toy&preset=märz&seed=9&h=6.5&wind=4");
		expect(decodeQuery(toy, encodeQuery(toy, tall))).toEqual({ specimen: tall, notes: [] });
		const file = JSON.parse(JSON.stringify(writtenSpecimen(toy, tall)));
		expect(file.parameters.flag).toBe("square");
		expect(restore(toy, file)).toEqual({ specimen: tall, notes: [] });
		expect([modelIn(file), modelInQuery(encodeQuery(toy, tall))]).toEqual(["toy", "toy"]);
		expect([modelIn({}), modelIn(null), modelIn({ model: 3 }), modelInQuery("?v=2")]).toEqual(Array(4).fill(undefined));
	});

	it("has its long text in the fragment, where it is not its preset's", async () => {
		expect(await encodeLink(toy, fromPreset(toy, "märz"))).toBe("?v=2&model=toy&preset=märz");
		const link = await encodeLink(toy, { ...fromPreset(toy), motto: "Höher" });
		const hash = link.slice(link.indexOf("#"));
		expect(hash).toMatch(/^#t=[\w-]+$/);
		expect([hasPacked(toy, hash), hasPacked(toy, "#g=abc")]).toEqual([true, false]);
		expect(await decodeLink(toy, "?v=2&model=toy", hash)).toEqual({
			specimen: { ...fromPreset(toy), motto: "Höher" },
			notes: [],
		});
		const damaged = await decodeLink(toy, "?v=2&model=toy", "#t=!");
		expect(texts(damaged.notes)).toEqual(["motto: The link is damaged here. None is used."]);
	});

	it("is read as far as it goes from a record of another model, with a note", () => {
		const { specimen, notes } = restore(toy, { v: 2, model: "bunch", seed: 3, thin: "a" });
		expect(specimen).toEqual({ ...fromPreset(toy), seed: 3 });
		expect(texts(notes)).toEqual([
			"model: There is no model “bunch” here. Using toy.",
			"thin: There is no such parameter. This part was ignored.",
		]);
	});

	it("is edited within its own table alone", () => {
		const pole = fromPreset(toy);
		expect(withParameters(toy, pole, { height: 99, rmin: 3, paint: 1 }).parameters).toEqual({
			height: 9,
			flag: 0,
			wind: 3,
		});
		expect(withLook(toy, pole, { paint: "00ff00", height: 2 }).look).toEqual({ paint: "00ff00" });
	});

	it("isActive what its choices let it", () => {
		const wind = toy.table.entry("wind");
		if (!wind) throw new Error("no wind");
		expect([toy.table.isActive(fromPreset(toy), wind), toy.table.isActive(fromPreset(toy, "märz"), wind)]).toEqual([
			false,
			true,
		]);
	});

	it("is told from another, whatever they hold, and undone to one of another model", () => {
		const pole: Specimen = fromPreset(toy);
		expect(sameSpecimen(pole, fromPreset(toy))).toBe(true);
		for (const other of [
			{ ...pole, motto: "x" },
			{ ...pole, model: "pole" },
			{ ...pole, more: [1] },
		]) {
			expect(sameSpecimen(pole, other)).toBe(false);
			expect(growsAlike(pole, other)).toBe(false);
		}
		expect(sameSpecimen({ ...pole, more: undefined } as Specimen, pole)).toBe(true);
		expect(growsAlike(pole, { ...pole, look: { paint: "000000" } })).toBe(true);
		const bunch: Specimen = specimenFromPreset();
		const history = histories.change(histories.startHistory(bunch), pole);
		expect(histories.undo(history).present).toBe(bunch);
	});
});
