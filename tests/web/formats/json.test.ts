import { readFileSync } from "node:fs";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { exportJson as exportAny, writeJson } from "../../../web/src/formats/json";
import { shortFloat } from "../../../web/src/formats/numbers";
import { model } from "../../../web/src/models/bunch/index";
import { MEASURE_KEYS, MEASURES } from "../../../web/src/models/bunch/measures.generated";
import type { NaturalBerryRecord } from "../../../web/src/models/bunch/record";
import type { Model } from "../../../web/src/models/model";
import { classOf } from "../../../web/src/specimen/measures";
import { exportJson, writtenJson, writtenSpecimen } from "../bunch";
import * as arbitrary from "../models/bunch/arbitrary";
import { fingerprintOfDocument } from "../models/bunch/fingerprint";
import { makeGrown, SKETCH, sampleSpecimen } from "../models/bunch/fixture";
import { makeNatural } from "../models/bunch/natural_fixture";

const grown = makeGrown(SKETCH);
const specimen = sampleSpecimen({ seed: 7 });

const { version } = JSON.parse(readFileSync("package.json", "utf8"));

describe("the JSON document", () => {
	it("has the fields that were promised, and no others", () => {
		const document = exportJson(grown, specimen);
		const fields = ["generator", "specimen", "counts", "measures", "procedure", "form", "plan"];
		fields.push("berries", "thinned", "internodes", "organs", "notes", "fingerprint", "timings");
		expect(Object.keys(document)).toEqual(fields);
		expect(Object.keys(document.plan)).toEqual(["m", "sides", "axes"]);
		expect(document.plan.sides).toHaveLength(4);
		expect(Object.keys(document.plan.sides[0])).toEqual(["w", "r", "n", "rd"]);
		expect(Object.keys(document.counts)).toEqual([
			"endStructures",
			"internodes",
			"pedicels",
			"berries",
			"withered",
			"cut",
		]);
		expect(Object.keys(document.berries[0])).toEqual(["x", "y", "z", "r", "parent"]);
		const internode = ["parent", "kind", "axis", "start", "end", "radius", "radiusEnd", "state"];
		expect(Object.keys(document.internodes[0])).toEqual(internode);
	});

	it("names the program with its version, and the classes of descriptors, that of the skin among them", () => {
		const measured = makeNatural(SKETCH);
		const dark = { ...specimen, look: { ...specimen.look, skin: "1d1c30" } };
		const { generator, classes } = exportAny(model as unknown as Model, measured, dark);
		expect(generator).toBe(`Panicle ${version}`);
		expect(classes?.skin_colour).toEqual({ oiv: 225, class: 6, words: "blue-black" });
		for (const [key, found] of Object.entries(classes ?? {})) {
			if (key === "skin_colour") continue;
			const info = MEASURES.find((each) => each.key === key);
			const value = measured.measures?.[MEASURE_KEYS.indexOf(key as (typeof MEASURE_KEYS)[number])] ?? Number.NaN;
			const { note, words } = classOf(info ?? {}, value) ?? {};
			expect(found).toEqual({ oiv: info?.oiv, class: note, words });
		}
		expect(Object.keys(classes ?? {}).length).toBeGreaterThan(8);
		expect(exportAny(model as unknown as Model, { ...measured, measures: undefined }, dark)).not.toHaveProperty(
			"classes",
		);
	});

	it("is written as JSON.stringify writes it, without being made", () => {
		const place: [number, number, number] = [0.1, -0.2, Math.fround(3e-7)];
		const noted = { ...grown, notes: ["a “note”"], thinned: [{ id: 7, why: "no room" as const, place }] };
		for (const each of [grown, makeNatural(SKETCH, { traits: () => ({ set: 0 }) }), noted])
			expect(writtenJson(each, specimen)).toBe(JSON.stringify(exportJson(each, specimen)));
		const organs = {
			count: 2,
			tag: Uint32Array.of(0, 0),
			tags: ["nœud"],
			segment: Int32Array.of(0, -1),
			mesh: Int32Array.of(0, 0),
			transforms: Float32Array.from({ length: 16 }, (_, i) => i / 10),
		};
		const { record: _, ...plain } = model as unknown as Model;
		const bare = { ...grown, organs };
		const text = writeJson(plain, bare, specimen).toString();
		expect(text).toBe(JSON.stringify(exportAny(plain, bare, specimen)));
		const indented = writeJson(plain, bare, specimen, "\t").toString();
		expect(indented).toBe(JSON.stringify(exportAny(plain, bare, specimen), null, "\t"));
		expect(JSON.parse(text).organs[1]).toEqual({
			kind: "nœud",
			segment: -1,
			position: [0.8, 0.9, 1],
			rotation: [1.1, 1.2, 1.3, 1.4],
			scale: 1.5,
		});
	});

	it("says what the growth says", () => {
		const { specimen: written, plan, counts, notes, fingerprint, timings } = exportJson(grown, specimen);
		expect({ written, plan, counts, notes, fingerprint, timings }).toEqual({
			written: writtenSpecimen(specimen),
			plan: grown.plan,
			counts: grown.counts,
			notes: grown.notes,
			fingerprint: grown.fingerprint,
			timings: grown.timings,
		});
		expect(exportJson({ ...grown, second: grown.plan }, specimen).plan.second).toEqual(grown.plan);
	});

	it("names kinds and states, and berries' parents are grown pedicels", () => {
		const { internodes, berries } = exportJson(grown, specimen);
		expect(internodes[0]).toMatchObject({ parent: -1, kind: "rachis", axis: -1, state: "grown", start: [0, 0, 0] });
		expect(internodes.filter(({ state }) => state === "withered")).toHaveLength(grown.counts.withered);
		for (const { parent } of berries) expect(internodes[parent]).toMatchObject({ kind: "pedicel", state: "grown" });
		internodes.forEach(({ parent }, index) => {
			expect(parent).toBeLessThan(index);
		});
	});

	it("reads back as the same float32 numbers, and gives the fingerprint again, for any growth", () => {
		fc.assert(
			fc.property(arbitrary.sketch, (sketch) => {
				const any = makeGrown(sketch);
				const read: ReturnType<typeof exportJson> = JSON.parse(JSON.stringify(exportJson(any, specimen)));
				const spheres = Float32Array.from(read.berries.flatMap(({ x, y, z, r }) => [x, y, z, r]));
				expect(spheres.map((value) => value + 0)).toEqual(any.berries.spheres.map((value) => value + 0));
				expect(fingerprintOfDocument(read)).toBe(any.fingerprint);
			}),
		);
	});

	it("gives the fingerprint by the function that docs/fingerprint.md prints, and the example's", () => {
		const page = readFileSync("docs/fingerprint.md", "utf8");
		const source = page.match(/```js\n([\s\S]*?)```/)?.[1] ?? "";
		const printed: (document: unknown) => string = new Function(`${source}; return fingerprint;`)();
		for (const any of [grown, makeNatural(SKETCH)]) {
			expect(printed(JSON.parse(JSON.stringify(exportJson(any, specimen))))).toBe(any.fingerprint);
		}
		const example = JSON.parse(page.match(/```json\n([\s\S]*?)```/)?.[1] ?? "");
		expect(page).toContain(`whose fingerprint is \`${printed(example)}\``);
	});

	it("needs no meshes and leaves the growth as it was", () => {
		const { stem, berry, ...skeleton } = grown;
		const before = structuredClone(skeleton);
		expect(exportJson(skeleton, specimen)).toEqual(exportJson(grown, specimen));
		expect(skeleton).toEqual(before);
	});
});

describe("the JSON document of a natural bunch", () => {
	const natural = makeNatural(SKETCH, { traits: (i) => ({ turned: i / 3, exposure: 0.1 * i }) });

	it("says of each berry what it is, and of each that is not there why", () => {
		const document = exportJson(natural, specimen);
		expect(Object.keys(document.berries[0])).toEqual(
			"x y z r parent id width length direction exposure turned opened set shrivel seeds".split(" "),
		);
		document.berries.forEach((berry, i) => {
			const [dx, dy, dz] = natural.berries.directions.subarray(3 * i, 3 * i + 3);
			const { width, length, direction, id, turned } = berry as NaturalBerryRecord;
			expect([width, length].map(Math.fround)).toEqual([...natural.berries.traits.subarray(8 * i, 8 * i + 2)]);
			expect(direction.map(Math.fround)).toEqual([dx, dy, dz].map((value) => value + 0));
			expect([id, Math.fround(turned)]).toEqual([natural.berries.ids[i], Math.fround(i / 3)]);
		});
		expect(document.thinned[0]).toEqual({ id: 3, why: "no room", x: 0.001, y: -0.02, z: 0.003 });
		expect(document).toMatchObject({
			procedure: "natural",
			form: { fruit: "grape", taper: 0.1, blunt: 0, curve: 0.3 },
		});
	});

	it("tells berries from flowers that have not begun to set", () => {
		const half = makeNatural(SKETCH, { traits: (i) => ({ set: i === 0 ? 0 : 0.5 }) });
		const { organs } = exportJson(half, specimen);
		expect(organs.map(({ kind }) => kind)).toEqual(organs.map((_, i) => (i === 0 ? "flower" : "berry")));
		expect(organs.length).toBeGreaterThan(1);
	});

	it("has every measure by its key, null where one does not apply, and none where none were asked for", () => {
		const { measures } = exportJson(natural, specimen);
		expect(Object.keys(measures ?? {})).toEqual(MEASURE_KEYS);
		expect(measures?.spill).toBe(0.1);
		expect(measures?.coverage_side).toBeNull();
		expect(exportJson({ ...natural, measures: undefined }, specimen).measures).toEqual({});
	});

	it("gives the fingerprint again, for any growth", () => {
		fc.assert(
			fc.property(arbitrary.sketch, (sketch) => {
				const any = makeNatural(sketch);
				expect(fingerprintOfDocument(JSON.parse(JSON.stringify(exportJson(any, specimen))))).toBe(any.fingerprint);
			}),
		);
	});
});

describe("short float32 numbers", () => {
	it("read back as themselves and are never longer than nine digits", () => {
		fc.assert(
			fc.property(fc.float({ noNaN: true, noDefaultInfinity: true }), (value) => {
				const short = JSON.parse(JSON.stringify(shortFloat(value)));
				expect(Math.fround(short)).toBe(value + 0);
				if (Math.abs(value) < 1e9)
					expect(String(short).replace(/^-?0*\.?0*|e.*$|\./g, "").length).toBeLessThanOrEqual(9);
			}),
		);
	});

	it.each([
		[0.1, 0.1],
		[-0.0125, -0.0125],
		[1 / 3, 0.33333334],
		[-0, 0],
	])("prints %d as float32 as %d", (value, short) => {
		expect(shortFloat(Math.fround(value))).toBe(short);
	});
});
