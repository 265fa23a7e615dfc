import { describe, expect, it } from "vitest";
import { MAX_KNOTS } from "../../../../../web/src/models/particles/boundary/details/profile";
import { TREE } from "../../../../../web/src/models/tree/schema";
import { fromPreset } from "../../../../../web/src/specimen/from_preset";
import { decodeLink, decodeQuery, encodeLink } from "../../../../../web/src/specimen/link";
import { restore } from "../../../../../web/src/specimen/restore";
import { writtenSpecimen } from "../../../../../web/src/specimen/written";
import { growBounded, particlesCore } from "./particles";

const oak = fromPreset(TREE);

const read = (query: string) => decodeQuery(TREE, `?v=2&model=tree&${query}`);
const notesOf = (query: string) => read(query).notes.map(({ text }) => text);

describe("fields of a boundary beyond its numbers", () => {
	it("goes into a link and comes back, under 300 characters for a typical edit", async () => {
		const specimen = {
			...oak,
			profile: [...(oak.profile ?? [])].map(([radius, height], i) => [i === 2 ? 0.87 : radius, height] as const),
			targets: [0, 0, 0, 1.5, 0, -2.25],
			obstacles: [2, 0, -1, 2.5, 4, 1],
			rounds: [3, 2, -3, 9, 8, 3],
		};
		const link = await encodeLink(TREE, specimen);
		expect(link.length).toBeLessThan(300);
		expect(link).toContain("targets=0,0,0,1.5,0,-2.25&obstacles=2,0,-1,2.5,4,1&rounds=3,2,-3,9,8,3");
		expect(await decodeLink(TREE, link)).toEqual({ specimen, notes: [] });
	});

	it("is absent from the link where it is the preset's", async () => {
		expect(await encodeLink(TREE, oak)).toBe("?v=2&model=tree");
	});

	it("goes into files, a mesh too, which no link carries", async () => {
		const volume = { points: [0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0], triangles: [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2] };
		const specimen = { ...oak, volume, obstacles: [0, 0, 0, 1, 1, 1] };
		const written = JSON.parse(JSON.stringify(writtenSpecimen(TREE, specimen)));
		expect(restore(TREE, written)).toEqual({ specimen, notes: [] });
		expect(await encodeLink(TREE, specimen)).toBe("?v=2&model=tree&obstacles=0,0,0,1,1,1");
	});

	it("warns that links omit a mesh: on copying with a way to keep it, on opening that it is missing", () => {
		const entry = TREE.table.entry("shape");
		const shape = entry?.kind === "choice" ? entry.options.indexOf("mesh") : -1;
		const volume = { points: [0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0], triangles: [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2] };
		const meshed = { ...oak, volume, parameters: { ...oak.parameters, shape } };
		const warnings = (specimen: typeof meshed) =>
			TREE.details.flatMap(({ unlinked }) => unlinked?.keep(specimen, fromPreset(TREE, specimen.preset)) ?? []);
		expect(warnings(meshed)).toEqual([expect.stringContaining("Download a JSON or GLB to keep yours")]);
		expect(warnings({ ...oak, volume })).toEqual([]);
		expect(notesOf("shape=mesh")).toEqual([
			expect.stringMatching(/^mesh: The link does not contain a mesh\. Links cannot hold a mesh/),
		]);
		expect(notesOf("shape=box")).toEqual([]);
		expect(restore(TREE, JSON.parse(JSON.stringify(writtenSpecimen(TREE, meshed)))).notes).toEqual([]);
	});

	it("keeps the mesh of the inner boundary in files, and warns that links omit it", () => {
		const hollow = { points: [0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0], triangles: [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2] };
		const hollowed = { ...oak, hollow };
		const keep = TREE.details.flatMap(({ unlinked }) => unlinked?.keep(hollowed, fromPreset(TREE, "oak")) ?? []);
		expect(keep).toEqual([expect.stringContaining("a smaller copy of the outer boundary")]);
		const written = JSON.parse(JSON.stringify(writtenSpecimen(TREE, hollowed)));
		expect(restore(TREE, written)).toEqual({ specimen: hollowed, notes: [] });
		const { specimen, notes } = restore(TREE, { ...written, hollow: { points: [0, 0], triangles: [0] } });
		expect(specimen).not.toHaveProperty("hollow");
		expect(notes.map(({ key }) => key)).toEqual(["hollow"]);
	});

	it("brings a preset's own mesh by the preset's name", async () => {
		const bonsai = fromPreset(TREE, "bonsai");
		const warnings = (specimen: typeof bonsai) =>
			TREE.details.flatMap(({ unlinked }) => unlinked?.keep(specimen, bonsai) ?? []);
		expect(bonsai.volume?.triangles.length).toBeGreaterThan(0);
		expect(await decodeLink(TREE, "?v=2&model=tree&preset=bonsai")).toEqual({ specimen: bonsai, notes: [] });
		expect(warnings(fromPreset(TREE, "bonsai"))).toEqual([]);
		const volume = { points: [0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0], triangles: [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2] };
		expect(warnings({ ...bonsai, volume })).toEqual([expect.stringContaining("it shows the preset’s mesh instead")]);
	});

	it("brings corners of an obstacle into order, and empty lists to nothing", () => {
		expect(read("obstacles=3,2,1,0,0,0").specimen.obstacles).toEqual([0, 0, 0, 3, 2, 1]);
		expect(read("targets=").specimen).not.toHaveProperty("targets");
	});

	it.each([
		[
			"profile=1,2",
			"profile: “1,2” is not a valid profile. Write at least 3 points as pairs of numbers, radius and height, such as “0.5,0,1,0.4,0,1”. The profile of the preset is used instead.",
		],
		["profile=1,0,a,1,0,1", "profile: “1,0,a,1,0,1” is not a valid profile"],
		[
			"profile=9,0,1,0.5,0,1",
			"profile: Radii must be from 0 to 3, and heights from 0 to 1. Values outside this range were moved to the nearest allowed value.",
		],
		[
			"profile=1,0,1,0.7,1,0.4,0,1",
			"profile: Heights must not decrease from point to point. The points were sorted by height.",
		],
		[
			"targets=1,2",
			"targets: “1,2” is not a list of positions like “0,0,0”. The values of the preset are used instead.",
		],
		[
			"targets=1,2,500",
			"targets: Some positions are more than 100 m from the centre. These positions were moved to the nearest allowed ones.",
		],
		[
			"obstacles=1,2,3",
			"obstacles: “1,2,3” is not a list of boxes like “1,0,-2,1.5,4,2”. The values of the preset are used instead.",
		],
	])("notes what it cannot use of %s", (query, note) => {
		expect(notesOf(query)).toHaveLength(1);
		expect(notesOf(query)[0]).toContain(note.slice(0, note.length));
	});

	it("takes as many obstacles and targets as the core grows around, and no more", async () => {
		const box = (i: number) => `${3 + i},0,-1,${3.5 + i},1,1`;
		const boxes = Array.from({ length: 17 }, (_, i) => box(i)).join();
		const places = Array.from({ length: 61 }, (_, i) => `${i / 10},0,0`).join();
		const { specimen, notes } = read(`n=30&obstacles=${boxes}&targets=${places}`);
		expect([specimen.obstacles?.length, specimen.targets?.length]).toEqual([6 * 16, 3 * 60]);
		expect(notes.map(({ key }) => key).sort()).toEqual(["obstacles", "targets"]);
		const plant = growBounded(await particlesCore(), TREE.table, specimen, { meshes: false });
		expect(plant.counts.targets).toBe(60);
	});

	it("takes boxes and round ones together as many as the core grows around", async () => {
		const list = (count: number) => Array.from({ length: count }, (_, i) => `${3 + i},0,-1,${3.5 + i},1,1`).join();
		const { specimen, notes } = read(`n=30&rounds=${list(3)}&obstacles=${list(15)}`);
		expect([specimen.obstacles?.length, specimen.rounds?.length]).toEqual([6 * 15, 6]);
		expect(notes.map(({ text }) => text)).toEqual([
			"rounds: “obstacles” and “rounds” together have more than 16 entries. Only the first 16 entries are used.",
		]);
		expect(growBounded(await particlesCore(), TREE.table, specimen, { meshes: false }).counts.targets).toBe(1);
		expect(read(`obstacles=${list(16)}&rounds=${list(1)}`).specimen).not.toHaveProperty("rounds");
		expect(notesOf(`obstacles=${list(15)}&rounds=${list(1)}`)).toEqual([]);
	});

	it("lets nothing grow in a round obstacle, and no energy be lost", async () => {
		const { specimen } = read("n=300&rounds=1,2,-3,7,8,3");
		const core = await particlesCore();
		const [plant, free] = [specimen, { ...specimen, rounds: undefined }].map((each) =>
			growBounded(core, TREE.table, each, { meshes: false }),
		);
		const within = ({ segments: { count, ends } }: typeof plant) =>
			Array.from({ length: count }, (_, i) => ends.subarray(6 * i + 3, 6 * i + 6)).filter(
				([x, y, z]) => ((x - 4) / 3) ** 2 + ((y - 5) / 3) ** 2 + (z / 3) ** 2 < 1,
			).length;
		expect(within(plant)).toBe(0);
		expect(within(free)).toBeGreaterThan(20);
		expect(plant.counts.energy).toBe(plant.counts.particles);
	});

	it("takes no more points than it can hold, nor a mesh whose corners are not there", () => {
		const many = Array.from({ length: MAX_KNOTS + 2 }, (_, i) => `1,${i / 40}`).join();
		expect(read(`profile=${many}`).specimen.profile).toHaveLength(MAX_KNOTS);
		expect(notesOf(`profile=${many}`)[0]).toContain("more than 24 points");
		const { specimen, notes } = restore(TREE, { model: "tree", volume: { points: [0, 0, 0], triangles: [0, 1, 2] } });
		expect(specimen.volume).toBeUndefined();
		expect(notes[0].text).toContain("is not a mesh of at most 4,000 triangles");
		expect(restore(TREE, { model: "tree", volume: { points: [], triangles: [] } }).specimen.volume).toBeUndefined();
	});
});
