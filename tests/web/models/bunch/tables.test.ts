import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { skinClass } from "../../../../web/src/models/bunch/measures";
import { MEASURES } from "../../../../web/src/models/bunch/measures.generated";
import { berriesCsv, measuresCsv } from "../../../../web/src/models/bunch/tables";
import * as arbitrary from "./arbitrary";
import { makeGrown, SKETCH, sampleSpecimen } from "./fixture";
import { makeNatural } from "./natural_fixture";

const grown = makeNatural(SKETCH, { traits: (i) => ({ exposure: 0.25 * i, turned: 0.5 }) });
const specimen = sampleSpecimen({ preset: "short-conical", seed: 7 });

/** RFC 4180, read by a way of our own: records end with CRLF, quoted cells may hold anything. */
function parse(text: string): string[][] {
	const cell = /("(?:[^"]|"")*"|[^",\r\n]*)(,|\r\n)/gy;
	const rows: string[][] = [[]];
	for (const [, written, end] of text.matchAll(cell)) {
		rows[rows.length - 1].push(written.startsWith('"') ? written.slice(1, -1).replaceAll('""', '"') : written);
		if (end === "\r\n") rows.push([]);
	}
	expect(rows.pop()).toEqual([]);
	return rows;
}

const records = (text: string) => {
	const [header, ...rows] = parse(text);
	return rows.map((row) => Object.fromEntries(row.map((cell, i) => [header[i], cell])));
};

describe("the CSV of berries", () => {
	it("has one header row and one row per berry, all of equal length, each ending with CRLF", () => {
		const text = berriesCsv(grown, specimen);
		expect(text.startsWith("preset,seed,berry,id,x_mm,y_mm,z_mm,width_mm,length_mm,")).toBe(true);
		expect(text.split("\r\n")).toHaveLength(grown.berries.count + 2);
		expect(new Set(parse(text).map((row) => row.length)).size).toBe(1);
	});

	it("gives the growth's metres in millimetres, for any growth", () => {
		fc.assert(
			fc.property(arbitrary.sketch, fc.boolean(), (sketch, natural) => {
				const any = natural ? makeNatural(sketch) : makeGrown(sketch);
				const rows = records(berriesCsv(any, specimen));
				expect(rows).toHaveLength(any.berries.count);
				rows.forEach((row, i) => {
					const [x, y, z, r] = any.berries.spheres.subarray(4 * i, 4 * i + 4);
					const given = [row.x_mm, row.y_mm, row.z_mm, row.radius_mm].map(Number);
					[x, y, z, r].forEach((metres, k) => {
						expect(Math.abs(given[k] - 1000 * metres)).toBeLessThanOrEqual(5.001e-4);
					});
					const [width, length] = any.berries.traits.subarray(8 * i, 8 * i + 2);
					expect(Math.abs(Number(row.width_mm) - 1000 * width)).toBeLessThanOrEqual(5.001e-4);
					expect(Math.abs(Number(row.length_mm) - 1000 * length)).toBeLessThanOrEqual(5.001e-4);
					[row.direction_x, row.direction_y, row.direction_z].forEach((cell, k) => {
						expect(Math.abs(Number(cell) - any.berries.directions[3 * i + k])).toBeLessThanOrEqual(5.001e-5);
					});
					expect(Number(row.id)).toBe(any.berries.ids[i]);
					expect(Number(row.pedicel)).toBe(any.berries.parent[i]);
					expect(Number(row.axis)).toBe(any.internodes.axis[any.berries.parent[i]]);
				});
			}),
		);
	});

	it("has volumes, pedicels' lengths and traits, with no more digits than they are worth", () => {
		const [first, second] = records(berriesCsv(grown, specimen));
		expect(first).toMatchObject({ preset: "short-conical", seed: "7", berry: "1", exposure: "0", turned: "0.5" });
		expect(Number(first.volume_mm3)).toBeCloseTo((4 / 3) * Math.PI * 6 ** 3, 0);
		expect(first.pedicel_length_mm).toBe("12");
		expect(second.exposure).toBe("0.25");
		for (const row of parse(berriesCsv(grown, specimen)).slice(1)) {
			for (const cell of row) expect(cell.length).toBeLessThan(14);
		}
	});

	it("is a header alone where there are no berries", () => {
		expect(parse(berriesCsv(makeNatural({ axes: [] }), specimen))).toHaveLength(1);
	});
});

describe("the CSV of measures", () => {
	it("has a row for each, with unit and class, and an empty value where one does not apply", () => {
		const rows = records(measuresCsv(grown, specimen));
		expect(rows.map(({ key }) => key)).toEqual([...MEASURES.map(({ key }) => key), "skin_colour"]);
		rows.slice(0, -1).forEach((row, i) => {
			expect(row.value).toBe(i % 7 === 3 ? "" : String(Number((0.1 * i).toFixed(6))));
			expect(row.class === "").toBe(!MEASURES[i].classes || row.value === "");
		});
		expect(rows.some((row) => row.class !== "" && row.oiv !== "")).toBe(true);
		const { oiv, class: note, value, class_words } = rows[rows.length - 1];
		const found = skinClass(specimen.look);
		expect([oiv, note, value, class_words]).toEqual(["225", String(found.note), String(found.note), found.words]);
	});

	it("has only a header without measures", () => {
		expect(parse(measuresCsv({ ...grown, measures: undefined }, specimen))).toHaveLength(1);
	});

	it("quotes characters that would end a cell", () => {
		const odd = sampleSpecimen({ preset: 'a "b", c' });
		expect(berriesCsv(grown, odd)).toContain('"a ""b"", c",1,1,');
		expect(records(berriesCsv(grown, odd))[0].preset).toBe('a "b", c');
	});
});
