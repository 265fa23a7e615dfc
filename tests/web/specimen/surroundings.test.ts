/** The surroundings of a plant in links and files. */
import { describe, expect, it } from "vitest";
import { model } from "../../../web/src/models/growth/index";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { decodeQuery, encodeQuery } from "../../../web/src/specimen/link";
import { restore } from "../../../web/src/specimen/restore";
import { writtenSpecimen } from "../../../web/src/specimen/written";

const ABOUT = [39, 0, 12, 90, 0, 0, 0, 5, 2.25, 99, 0.01, 3, 4, 5, 6, 7.5];
const among = { ...fromPreset(model, "oak"), surroundings: ABOUT };
const read = (about: unknown) => restore(model, { v: 2, model: "growth", preset: "oak", about });
const messages = (about: unknown) => read(about).notes.map(({ text }) => text);

describe("what stands about a plant", () => {
	it("is in its link, and comes back by it and by files", () => {
		const query = encodeQuery(model, among);
		expect(query).toContain("about=39,0,12,90,0,0,0,5,2.25,99,0.01,3,4,5,6,7.5");
		expect(decodeQuery(model, query)).toEqual({ specimen: among, notes: [] });
		expect(restore(model, JSON.parse(JSON.stringify(writtenSpecimen(model, among)))).specimen).toEqual(among);
		expect(encodeQuery(model, fromPreset(model, "oak"))).not.toContain("about");
	});

	it("is brought into range and to what links can say, and told so", () => {
		expect(read([...ABOUT.slice(0, 15), 7.512]).specimen.surroundings?.[15]).toBe(7.51);
		expect(messages([...ABOUT.slice(0, 15), 7.512])).toEqual([]);
		const { specimen, notes } = read([91, ...ABOUT.slice(1, 8), 0, ...ABOUT.slice(9, 15), 1e9]);
		expect(specimen.surroundings).toEqual([90, ...ABOUT.slice(1, 8), 0.01, ...ABOUT.slice(9, 15), 99]);
		expect(notes).toHaveLength(1);
	});

	it("is nothing where it is not sixteen numbers, or empty", () => {
		for (const wrong of ["1,2", "a".repeat(16), ABOUT.slice(1), 7]) {
			expect(read(wrong).specimen.surroundings).toBeUndefined();
			expect(messages(wrong)[0]).toMatch(/is not a list of 16 numbers.*grows without neighbours/);
		}
		expect(restore(model, { about: "" }, among)).toEqual({ specimen: fromPreset(model, "oak"), notes: [] });
	});
});
