import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../../web/src/core/core";
import { exportJson } from "../../../../../web/src/formats/json";
import type { Area } from "../../../../../web/src/models/grammar/areas/area";
import type { GrammarPlant } from "../../../../../web/src/models/grammar/grammar_plant";
import { model } from "../../../../../web/src/models/grammar/index";
import type { GrammarSpecimen } from "../../../../../web/src/models/grammar/specimen";
import { fetchTexts, textOf } from "../../../../../web/src/models/grammar/texts";
import { fromPreset } from "../../../../../web/src/specimen/from_preset";
import { inRun } from "../../../../long_run.mjs";
import { freshCore } from "../../../core/wasm";
import { clothed, holds, lateralTips, leafBases, leafLengths, surfacePlaces } from "./clothing";

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("grammar.wasm");
});

const grow = (specimen: GrammarSpecimen): GrammarPlant =>
	model.read(core.grow(model.encode(specimen, { meshes: false })), specimen);
const presets = model.presets.list.filter(({ kind }) => kind === "topiary").map(({ name }) => name);
const own = (name: string, changes: Partial<GrammarSpecimen> = {}) => ({ ...fromPreset(model, name), ...changes });

describe.each(presets.filter((_, i) => i % inRun(3, 1) === 0))("%s", (name) => {
	it("is clothed, by leaves of about a fifteenth of each area, and nowhere grows out of them", () => {
		const specimen = own(name);
		const plant = grow(specimen);
		expect(plant.segments.count).toBeGreaterThanOrEqual(500);
		expect(plant.segments.count).toBeLessThanOrEqual(20_000);
		expect(plant.notes).toEqual([]);
		const areas = specimen.areas ?? [];
		const lengths = leafLengths(plant);
		expect([...lengths.keys()]).toEqual(areas.map((_, i) => i + 1));
		const bases = leafBases(plant);
		for (const [i, area] of areas.entries()) {
			// All leaves of an area are as long as each other: 1/12 to 1/18 of it.
			const [shortest, longest] = lengths.get(i + 1) ?? [0, 0];
			expect(longest / shortest).toBeLessThan(1.0001);
			expect(Math.max(...area.size) / longest).toBeGreaterThan(12);
			expect(Math.max(...area.size) / longest).toBeLessThan(18);
			const share = clothed(surfacePlaces(area, 800), bases, longest);
			expect(share).toBeGreaterThanOrEqual(0.9);
			// The core's measure samples other points, with each leaf's own length.
			expect(Math.abs((plant.areaMeasures?.clothed[i] ?? 0) - share)).toBeLessThan(0.06);
		}
		const tips = lateralTips(plant);
		expect(tips.length).toBeGreaterThan(100);
		// A point in a mesh costs as much as all of its triangles; tests/core/models/grammar/areas_test.cpp checks all.
		const sampled = tips.filter(({ area }, i) => areas[area - 1]?.kind !== "mesh" || i % 5 === 0);
		const outside = sampled.filter(({ at, area }) => area < 1 || !holds(areas[area - 1], at));
		expect(outside).toEqual([]);
	});
});

describe("a topiary follows its text", () => {
	const text = async () => (await textOf(own("topiary-one-cube"))).replace("#define part 15", "#define part 8.5");
	const ofText = async (change: (text: string) => string, changes: Partial<GrammarSpecimen> = {}) => {
		const before = await text();
		const after = change(before);
		if (after === before) throw new Error("The text is as it was.");
		return grow(own("topiary-one-cube", { constants: {}, grammar: after, ...changes }));
	};
	const plain = async () => grow(own("topiary-one-cube", { constants: {}, grammar: await text() }));

	it("has laterals of the given length and number", async () => {
		const [before, younger] = [
			await plain(),
			await ofText((each) => each.replace("#define oldest 26", "#define oldest 4")),
		];
		expect(younger.segments.count).toBeLessThan(0.3 * before.segments.count);
		const lone = await ofText((each) =>
			each.replace("[ Area(a) /(120) &(spread*(1-vary+ran(2*vary))) A(1,a,l) ?P(0,0,0) ?H(0,0,0) ]\n", "\n"),
		);
		expect(lone.segments.count).toBeLessThan(0.85 * before.segments.count);
	});

	it("ends short of the surface where its last segment is not shortened to it", async () => {
		const clothes = (plant: GrammarPlant) =>
			clothed(surfacePlaces(own("topiary-one-cube").areas?.[0] as Area, 800), leafBases(plant), 0.06);
		const cut = await ofText((each) => each.replace("r<l && r>0.15*l --> F(r) J(0,l)", "r<l && r>0.15*l --> J(0,l)"));
		expect(clothes(cut)).toBeLessThan(clothes(await plain()) - 0.1);
	});

	it("stays in its first area where it is not to pass on", async () => {
		const areas = own("topiary-two-cubes").areas as Area[];
		const both = await ofText((each) => `${each} `, { areas });
		expect(new Set(both.belongs?.area)).toEqual(new Set([0, 1, 2]));
		const one = await ofText((each) => each.replace("!in && e && a<areas", "!in && e && a<1"), { areas });
		expect(new Set(one.belongs?.area)).toEqual(new Set([0, 1]));
		expect(one.notes).toEqual([expect.stringContaining("grammar.area_not_reached")]);
	});

	it("grows out of its area if the text does not use it", async () => {
		const wild = await ofText((each) =>
			each.replaceAll("reach(x,y,z,u,v,w,a,3*l)", "(3*l)").replace("#define oldest 26", "#define oldest 9"),
		);
		const box = own("topiary-one-cube").areas?.[0] as Area;
		expect(lateralTips(wild).filter(({ at }) => !holds(box, at)).length).toBeGreaterThan(50);
	});

	it("draws the given leaves", async () => {
		const bare = await ofText((each) => each.replaceAll("~elliptic(l/0.85)", ""));
		expect(leafBases(bare)).toEqual([]);
		expect(bare.segments.count).toBe((await plain()).segments.count);
	});
});

describe("the main branch", () => {
	it("is one line from the ground, through the areas in their order, across the gaps", () => {
		const specimen = own("topiary-three-spheres");
		const { segments, belongs } = grow(specimen);
		const main = Array.from({ length: segments.count }, (_, i) => i).filter((i) => belongs?.main[i] === 1);
		expect(main.length).toBeGreaterThan(10);
		for (const [k, i] of main.slice(1).entries()) expect(segments.parent[i]).toBe(main[k]);
		expect(segments.parent[main[0]]).toBe(-1);
		const passed = main.map((i) => belongs?.area[i]).filter((area, k, all) => area !== all[k - 1]);
		expect(passed).toEqual([0, 1, 0, 2, 0, 3]);
	});

	it("follows a drawn path", () => {
		const path = [0.6, 0.5, 0, 0.8, 1, 0.1, 0.2, 1.4, 0, 0, 2, 0];
		const { segments, belongs } = grow(own("topiary-two-cubes", { path }));
		for (let place = 0; place < path.length - 3; place += 3) {
			const near = Array.from({ length: segments.count }, (_, i) => i)
				.filter((i) => belongs?.main[i] === 1)
				.map((i) => Math.hypot(...[0, 1, 2].map((k) => segments.ends[6 * i + 3 + k] - path[place + k])));
			expect(Math.min(...near)).toBeLessThan(0.15);
		}
	});

	it("forks: each branch passes its own areas, and all of them are clothed", () => {
		const areas = [
			{ kind: "sphere", centre: [0, 0.75, 0] },
			{ kind: "sphere", centre: [-0.75, 1.75, 0] },
			{ kind: "sphere", centre: [0.75, 1.75, 0] },
			{ kind: "sphere", centre: [0, 2.3, 0] },
		].map((area) => ({ ...area, size: [0.8, 0.8, 0.8], rotation: [0, 0, 0, 1] })) as unknown as Area[];
		const path = [0, 0.75, 0, 0, 1.2, 0, -0.75, 1.75, 0, 0.75, 1.75, 0, 0, 2.3, 0];
		const from = [0, 1, 2, 2, 2];
		const specimen = own("topiary-three-spheres", { areas, path, from });
		const plant = grow(specimen);
		const { segments, belongs } = plant;
		const main = Array.from({ length: segments.count }, (_, i) => i).filter((i) => belongs?.main[i] === 1);
		const children = new Map<number, number>();
		for (const i of main) children.set(segments.parent[i], (children.get(segments.parent[i]) ?? 0) + 1);
		// One line but at the fork, where three go on.
		expect([...children.values()].filter((many) => many > 1)).toEqual([3]);
		expect(new Set(main.map((i) => belongs?.area[i]))).toEqual(new Set([0, 1, 2, 3, 4]));
		for (const [i, area] of areas.entries())
			expect(
				clothed(surfacePlaces(area, 500), leafBases(plant), 0.8 / specimen.constants.part),
				`area ${i + 1}`,
			).toBeGreaterThan(0.85);
		expect(lateralTips(plant).filter(({ at, area }) => area < 1 || !holds(areas[area - 1], at))).toEqual([]);
		// Without the forks the same places are one line.
		const { segments: line, belongs: of } = grow({ ...specimen, from: undefined });
		const single = Array.from({ length: line.count }, (_, i) => i).filter((i) => of?.main[i] === 1);
		for (const [k, i] of single.slice(1).entries()) expect(line.parent[i]).toBe(single[k]);
	});

	it("moves with its areas: a moved area has branches at its new place", () => {
		const before = own("topiary-two-cubes");
		const areas = before.areas?.map((area, i) =>
			i === 1 ? { ...area, centre: [0.9, 1.9, 0.2] as const } : area,
		) as Area[];
		const plant = grow({ ...before, areas });
		expect(lateralTips(plant).filter(({ at, area }) => !holds(areas[area - 1], at))).toEqual([]);
		expect(clothed(surfacePlaces(areas[1], 800), leafBases(plant), 1 / before.constants.part)).toBeGreaterThan(0.85);
	});

	it("has areas and the main branch's segments in the JSON document", () => {
		const specimen = own("topiary-two-cubes");
		const json = exportJson(model, grow(specimen), specimen);
		expect(json).toMatchObject({ areas: specimen.areas });
		const segments = [...(json.segments as Iterable<{ area: number; main: number }>)];
		expect(new Set(segments.map(({ area }) => area))).toEqual(new Set([0, 1, 2]));
		expect(new Set(segments.map(({ main }) => main))).toEqual(new Set([0, 1]));
	});
});
