/** Beds: stands of flowers. */
import { beforeAll, describe, expect, it } from "vitest";
import { aboutPlant } from "../../../../web/src/formats/about_plant";
import { exportGlb } from "../../../../web/src/formats/glb";
import { exportJson } from "../../../../web/src/formats/json";
import { growPlant } from "../../../../web/src/generate/growth";
import { MemberCache } from "../../../../web/src/generate/members";
import { modelNamed } from "../../../../web/src/models/index";
import { model } from "../../../../web/src/models/stand/index";
import { plantGroups, valuesOf } from "../../../../web/src/models/stand/members";
import { type PlantRecord, placementsCsv } from "../../../../web/src/models/stand/record";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { decodeLink } from "../../../../web/src/specimen/link";
import { complaints, documentOf } from "../../formats/reading";
import { grownStand, planned, run } from "./stands";

const FLOWERS = 300;
/** Most triangles of each level, from near to far. */
const MAX_TRIANGLES = [6000, 2200, 800, 260];

const BED = `ground 1.2 x 0.8
plants 12, stratified
flower/tulip, share 3, crown 0.2 x 0.4, scale 0.8 to 1.1: age 0.2 to 1.6
flower/daisy, share 1, crown 0.12 x 0.14: age 0.3 to 1.4
flower/bluebell, share 2, crown 0.2 x 0.34: age 0.6 to 1.3
plants 6, stratified
flower/grass, crown 0.1 x 0.1, scale 0.5 to 1
`;

describe("a flowerbed", () => {
	it("has 300 flowers, no two of them alike, of all ages and mixed by share", async () => {
		const bed = await grownStand(fromPreset(model, "flowerbed"));
		const flowers = bed.members.filter((_, plant) => !/grass/.test(bed.kinds[bed.places.kind[plant]].name));
		expect(flowers).toHaveLength(FLOWERS);
		expect(new Set(flowers.map((member) => member?.fingerprint)).size).toBe(FLOWERS);
		const ages = flowers.map((member) => member?.specimen.parameters.age ?? 0);
		expect(Math.min(...ages)).toBeLessThan(0.3);
		expect(Math.max(...ages)).toBeGreaterThan(1.5);
		const of = (name: string) => flowers.filter((member) => member?.specimen.preset === name).length;
		expect(of("pansy")).toBeGreaterThan(55);
		expect(of("pansy") + of("daisy")).toBe(150);
		expect(bed.notes).toEqual([]);
		// Two lines of poppies and two of daisies form one group each.
		expect(bed.counts.kinds).toBe(9);
		const sorts = plantGroups(bed);
		expect(sorts.map(({ title }) => title).slice(0, 4)).toEqual(["Lily", "Poppy", "Umbel", "Globeflower"]);
		expect(sorts[1].count).toBe(of("poppy"));
		expect(sorts.reduce((sum, { count }) => sum + count, 0)).toBe(bed.places.count);
	}, 300_000);
});

describe("the beds of the thesis (Petrenko 2014, figures 45 and 48)", () => {
	it.each([
		["bluebells-and-daisies", ["flower/bluebell", "flower/daisy", "flower/grass"], 280],
		["sunflowers", ["flower/sunflower", "flower/grass"], 56],
	])("%s: interspersed, each flower with a length and a bend of its own", async (preset, names, flowers) => {
		const specimen = fromPreset(model, preset);
		await model.prepare?.(specimen);
		const plan = model.read(await run(model.wasm, model.encode(specimen, { meshes: false })));
		const nameOf = (plant: number) => plan.kinds[plan.places.kind[plant]].name;
		const plants = Array.from({ length: plan.places.count }, (_, plant) => plant);
		expect(new Set(plants.map(nameOf))).toEqual(new Set(names));
		const some = plants.filter((plant) => nameOf(plant) !== "flower/grass");
		expect(some).toHaveLength(flowers);
		const bends = some.map((plant) => Number(valuesOf(plan, plant).bend));
		expect(Math.min(...bends)).toBeLessThan(-1.5);
		expect(Math.max(...bends)).toBeGreaterThan(1.5);
		expect(new Set(some.map((plant) => valuesOf(plan, plant).length)).size).toBeGreaterThan(0.95 * flowers);
		// Stratified sampling: every quarter of the ground has about a quarter of the plants.
		const quarter = (plant: number) =>
			2 * Number(plan.places.at[3 * plant] > 0) + Number(plan.places.at[3 * plant + 2] > 0);
		for (const each of [0, 1, 2, 3])
			expect(some.filter((plant) => quarter(plant) === each).length / flowers).toBeGreaterThan(0.19);
	});

	it("grow from bud to wilted without a note, in a small part", async () => {
		for (const preset of ["bluebells-and-daisies", "sunflowers"]) {
			const specimen = fromPreset(model, preset);
			await model.prepare?.(specimen);
			const few = { ...specimen, parameters: { ...specimen.parameters, many: 60 } };
			const bed = await grownStand(few);
			expect(bed.notes, preset).toEqual([]);
			expect(bed.members.every((member) => (member?.levels ?? member) !== undefined)).toBe(true);
		}
	}, 120_000);
});

describe("a small bed", () => {
	let bed: StandPlant;
	beforeAll(async () => {
		bed = await grownStand(planned(BED), { meshes: true });
	}, 300_000);

	it("shows each flower at four distances, in its own colours", () => {
		for (const [plant, member] of bed.members.entries()) {
			const { name } = bed.kinds[bed.places.kind[plant]];
			expect(member?.levels).toHaveLength(4);
			for (const [k, level] of (member?.levels ?? []).entries()) {
				const triangles = level.reduce((sum, { mesh }) => sum + mesh.indices.length / 3, 0);
				expect(triangles).toBeLessThanOrEqual(MAX_TRIANGLES[k]);
				expect(triangles).toBeGreaterThan(30);
				for (const { mesh } of level) expect(mesh.colours).toHaveLength(mesh.positions.length);
			}
			const petals = member?.levels[0].find(({ material }) => material.name === "petal");
			if (name === "flower/grass") expect(petals).toBeUndefined();
			else expect(petals?.material.sheet).toBeDefined();
		}
		// Translucent parts share one finish, so they are drawn together.
		const finishes = new Set(bed.members.flatMap((member) => member?.levels[0].map(({ material }) => material) ?? []));
		expect(finishes.size).toBeLessThan(12);
	});

	it("does not grow its flowers again when only their surroundings change", async () => {
		let grown = 0;
		const counted: typeof run = (wasm, blocks) => {
			if (wasm === "flower.wasm") grown++;
			return run(wasm, blocks);
		};
		const cache = new MemberCache();
		await grownStand(planned(BED), { cache });
		const wider = await grownStand(planned(BED.replace("0.2 x 0.4", "0.6 x 0.9")), { cache, run: counted });
		expect(wider.places.surroundings).not.toEqual(bed.places.surroundings);
		expect(grown).toBe(0);
	});

	it("never requests a flower's map", async () => {
		for (const meshes of [false, true]) {
			const outputs = new Set<unknown>();
			await grownStand(planned("plants 2, stratified\nflower/tulip"), {
				meshes,
				run: async (wasm, blocks) => {
					if (wasm === "flower.wasm") outputs.add(blocks.find(({ name }) => name === "outputs")?.data);
					return run(wasm, blocks);
				},
			});
			expect([...outputs]).toEqual([meshes ? "levels" : ""]);
		}
	});

	it("opens each flower alone by its link, as the same flower", async () => {
		const flower = await modelNamed("flower");
		const { plants } = exportJson(model, bed, planned(BED)) as unknown as { plants: PlantRecord[] };
		expect(plants).toHaveLength(18);
		for (const { link = "", fingerprint, values } of plants.slice(0, 4)) {
			const { specimen, notes } = await decodeLink(flower, link);
			expect(notes).toEqual([]);
			expect(specimen.parameters.age).toBeCloseTo(values.age as number, 2);
			expect((await growPlant(flower, specimen, { meshes: false, measures: false }, run)).fingerprint).toBe(
				fingerprint,
			);
		}
	});

	it("draws values for what its texts call their own, which each plant's link and the table of plants have", async () => {
		const flower = await modelNamed("flower");
		const plan = (setting: string) => planned(`plants 6, stratified\nflower/tulip: age 0.5 to 1, ${setting}`);
		const some = await grownStand(plan("length 200 to 400, bend -2"));
		const { plants } = exportJson(model, some, plan("")) as unknown as { plants: PlantRecord[] };
		const lengths = plants.map(({ values }) => values.length as number);
		expect(Math.min(...lengths)).toBeGreaterThanOrEqual(200);
		expect(new Set(lengths).size).toBe(6);
		const alone = async (link = "") =>
			growPlant(flower, (await decodeLink(flower, link)).specimen, { meshes: false }, run);
		for (const { link, values, fingerprint } of plants) {
			expect(link).toContain(`define=bend:-2,length:${values.length}`);
			const grown = await alone(link);
			expect(grown.fingerprint).toBe(fingerprint);
			// Only its length differs.
			const taller = await alone(link?.replace(/length:[\d.]+/, "length:500"));
			const height = ({ measures }: typeof grown) => measures?.[0] ?? 0;
			expect(height(taller)).toBeGreaterThan(height(grown));
		}
		expect(placementsCsv(some, plan("")).split("\r\n")[0]).toContain("age,length,bend,fingerprint");
		const error = await grownStand(plan("\n  lenght 3")).catch((reason: unknown) => reason);
		expect(error).toMatchObject({
			message: expect.stringMatching(
				/no parameter lenght \(its parameters are steps, age, smooth\)\. In tulip: .*It defines length, bend/,
			),
			...{ line: 3, column: 3 },
		});
		await expect(grownStand(plan('length "tall"'))).rejects.toThrow("no parameter length");
	});

	it("is a valid GLB (Khronos validator) at each level of detail", async () => {
		for (const detail of [0, 3]) {
			const specimen = { ...planned(BED), look: { ...planned(BED).look, detail } };
			const about = await aboutPlant(model, bed, specimen);
			const file = exportGlb(model.parts(bed, specimen), about, { instancing: true });
			expect(await complaints(file)).toEqual([]);
			const { nodes } = documentOf(file) as { nodes: { name: string }[] };
			expect(nodes.filter(({ name }) => /^flower\/grass/.test(name)).length).toBeGreaterThanOrEqual(6);
		}
	});
});
