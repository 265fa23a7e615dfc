import fc from "fast-check";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../../web/src/core/core";
import { outlineOf } from "../../../../../web/src/grammar_editor/outline";
import { type Description, readLine, usual } from "../../../../../web/src/models/flower/design/description";
import { assembled, describedIn, designOf, textOf } from "../../../../../web/src/models/flower/design/design";
import { KNOTS } from "../../../../../web/src/models/flower/design/margin";
import { FIELDS, ORGANS, type Organ, type OrganField } from "../../../../../web/src/models/flower/design/organs";
import { DRAWN, OUTLINES } from "../../../../../web/src/models/flower/design/shapes";
import { type FlowerPlant, readFlowerPlant } from "../../../../../web/src/models/flower/flower_plant";
import { model } from "../../../../../web/src/models/flower/index";
import { fetchTexts } from "../../../../../web/src/models/flower/texts";
import { scan } from "../../../../../web/src/models/flower/ui/language";
import { source } from "../../../../../web/src/models/flower/ui/text";
import { fromPreset } from "../../../../../web/src/specimen/from_preset";
import { inRun } from "../../../../long_run.mjs";
import { freshCore } from "../../../core/wasm";

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("flower.wasm");
});

const grow = (grammar: string, map = false, constants = {}): FlowerPlant =>
	readFlowerPlant(core.grow(model.encode({ ...fromPreset(model), grammar, constants }, { meshes: false, map })));

/** Notes about volumes on faces with other numbers of sides, as whorls on whorls have them. */
const faults = ({ notes }: FlowerPlant) => notes.filter((note) => !note.includes("flower.attached"));

const anyOf = (field: OrganField): fc.Arbitrary<string | number> => {
	if (field.kind === "choice") return fc.constantFrom(...field.options);
	if (field.kind === "colour") return fc.constantFrom("000000", "ffffff", field.usual);
	const { least, most, step, usual: often } = field;
	const steps = Math.floor((most - least) / step);
	return fc.oneof(
		fc.constantFrom(least, most, often),
		fc.integer({ min: 0, max: steps }).map((k) => least + k * step),
	);
};
const anyMargin = fc
	.array(fc.integer({ min: 0, max: 100 }), { minLength: KNOTS, maxLength: KNOTS })
	.map((outs) => outs.map((out, i) => ({ along: i / (KNOTS - 1), out: out / 100 })));
const described = (organ: Organ): fc.Arbitrary<Description> =>
	fc
		.tuple(fc.record(Object.fromEntries(FIELDS[organ].map((field) => [field.key, anyOf(field)]))), anyMargin)
		.map(([values, margin]) => ({ ...usual(organ, values), ...(values.outline === DRAWN && { margin }) }));
const anyFlower = fc.tuple(...ORGANS.map(described));

/** Counts an organ's instances, by the label of its first volume. */
const counted = ({ volumes }: FlowerPlant, label: string, begins: (parent: string) => boolean) =>
	Array.from(volumes.label).filter((of, i) => {
		const parent = volumes.parent[i];
		return volumes.labels[of] === label && parent !== 0xffffffff && begins(volumes.labels[volumes.label[parent]]);
	}).length;

/** Returns the darts at which the map is invalid: an α that is no involution, or a product of two that is none. */
function wrongDarts({ darts }: FlowerPlant): number[] {
	if (!darts) throw new Error("no map");
	const { alpha, volume } = darts;
	const [a0, a1, a2, a3] = alpha;
	const squares = [
		[a0, a2],
		[a0, a3],
		[a1, a3],
	];
	return Array.from(volume.keys()).filter((dart) => {
		const back = alpha.every((a) => a[a[dart]] === dart);
		const free = [a0, a1, a2].some((a) => a[dart] === dart || volume[a[dart]] !== volume[dart]);
		return !back || free || !squares.every(([a, b]) => b[a[b[a[dart]]]] === dart);
	});
}

const numberOf = (descriptions: readonly Description[], organ: Organ, key: string) =>
	Number(descriptions.find((each) => each.organ === organ)?.values[key]);

describe("an assembled flower", () => {
	it("grows for any choices: the requested number of organs, a valid map, and no notes", () => {
		fc.assert(
			fc.property(anyFlower, (flower) => {
				const grown = grow(assembled(flower), true);
				expect(faults(grown)).toEqual([]);
				expect(wrongDarts(grown)).toEqual([]);
				const ringed = counted(grown, "VEIN", (parent) => parent.startsWith("RING"));
				const leaves = counted(grown, "VEIN", (parent) => /^(?:NODE\d|STALK)/.test(parent));
				const stamens = counted(grown, "FILAMENT", (parent) => parent.startsWith("RING"));
				const ovaries = counted(grown, "OVARY", (parent) => parent.startsWith("RING"));
				expect(leaves).toBe(numberOf(flower, "leaf", "count"));
				expect(ringed).toBe(
					numberOf(flower, "sepal", "count") + numberOf(flower, "petal", "count") * numberOf(flower, "petal", "whorls"),
				);
				expect(stamens).toBe(numberOf(flower, "stamen", "count") * numberOf(flower, "stamen", "whorls"));
				const carpels = numberOf(flower, "pistil", "count");
				const joined = flower[5].values.fusion === "syncarpous";
				expect(ovaries).toBe(joined ? Math.min(1, carpels) : carpels);
			}),
			{ numRuns: inRun(6, 25) },
		);
	});

	it("grows with each choice of each organ", () => {
		for (const organ of ORGANS)
			for (const field of FIELDS[organ])
				if (field.kind === "choice")
					for (const option of field.options) {
						const margin = [0, 0.25, 0.5, 0.75, 1].map((along) => ({ along, out: 1 - along }));
						const one = { ...usual(organ, { [field.key]: option }), ...(option === DRAWN && { margin }) };
						expect(faults(grow(assembled([one]))), `${organ} ${field.key} ${option}`).toEqual([]);
					}
	});

	it("grows wherever the sliders of its constants go", () => {
		for (const section of ["round", "triangular"]) {
			const grammar = assembled([usual("stem", { section }), usual("leaf", { count: 8, arrangement: "basal" })]);
			const { constants } = outlineOf(grammar, scan(grammar));
			const own = constants.filter(({ name }) => !source.governed?.has(name));
			expect(own.map(({ name, min }) => [name, min])).toEqual([
				["sides", 3],
				["thick", 0.8],
				["length", 10],
				["bend", -5],
			]);
			for (const { name, min, max, step } of own)
				for (const value of [min, min + step, max])
					expect(faults(grow(grammar, false, { [name]: value })), `${name} ${value}`).toEqual([]);
		}
	});

	it("has leaves on stalks of the given length, which have the leaf's rise", () => {
		const leaf = (values: Description["values"]) => grow(assembled([usual("leaf", { count: 3, ...values })]));
		expect(counted(leaf({}), "STALK", () => true)).toBe(0);
		const grown = leaf({ stalk: 40, angle: 30 });
		expect(faults(grown)).toEqual([]);
		const { labels, label, values, parent } = grown.volumes;
		const stalks = [...label.keys()].filter((at) => labels[label[at]] === "STALK");
		const riseAndLength = stalks.map((at) => [values[9 * at + 2], Math.round(10 * values[9 * at + 5]) / 10]);
		expect(riseAndLength).toEqual([
			[-30, 40],
			[-30, 36.8],
			[-30, 33.6],
		]);
		const feet = [...label.keys()].filter((at) => stalks.includes(parent[at]));
		expect(feet.map((at) => labels[label[at]])).toEqual(["VEIN", "VEIN", "VEIN"]);
		for (const at of feet) expect(Math.abs(values[9 * at + 2])).toBeLessThanOrEqual(3);
		const [first, , third] = feet.map((at) => values[9 * at + 5]);
		expect(third / first).toBeGreaterThan(0.7);
		expect(third / first).toBeLessThan(0.95);
	});

	it("is read from its text as it was described", () => {
		fc.assert(
			fc.property(anyFlower, (flower) => {
				const text = assembled(flower, "/* Mine */\n");
				const design = designOf(text);
				if (!design) throw new Error("no design");
				expect(textOf(design)).toBe(text);
				for (const each of flower) expect(describedIn(design, each.organ)).toEqual(each);
			}),
			{ numRuns: inRun(20, 50) },
		);
	});

	it("has as many lobes to a side as a width can show", () => {
		const lobes = (width: number) => {
			const { volumes } = grow(assembled([usual("petal", { length: 40, width }), usual("leaf", { count: 0 })]));
			const grown = Array.from(volumes.label, (of) => volumes.labels[of]);
			return ["RU1", "RU2", "RU3", "RU4"].filter((label) => grown.includes(label)).length;
		};
		expect([lobes(3), lobes(8), lobes(30)]).toEqual([1, 2, 3]);
	});

	it("is none where an organ is missing, twice, or out of its place", () => {
		const text = assembled();
		const without = text.replace(/@organ leaf[^@]*@\n/, "");
		expect(designOf(without)).toBeUndefined();
		expect(designOf(text + text)).toBeUndefined();
		expect(designOf("#define A(4)\n#axiom: A")).toBeUndefined();
	});

	it("is looked for in any text, however long a line or a word in it is", () => {
		const word = "a".repeat(2 ** 18);
		for (const text of [
			`@organ ${word}`,
			`@organ ${word}@`,
			`@organ leaf ${word}@`,
			`@organ leaf@${"\t".repeat(2 ** 18)}x`,
		])
			expect(designOf(text)).toBeUndefined();
		expect(readLine(`@organ leaf ${word} 1${word}count=3@`)).toEqual(usual("leaf"));
		expect(readLine("@organ leaf 1count=3@")).toEqual(usual("leaf", { count: 3 }));
	});

	it("knows every outline that an organ may have", () => {
		for (const organ of ["leaf", "sepal", "petal"] as const)
			expect(FIELDS[organ].find(({ key }) => key === "outline")).toMatchObject({ options: OUTLINES });
	});
});
