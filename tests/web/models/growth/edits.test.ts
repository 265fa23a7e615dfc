/** Edits of single branches: in links and files, in requests, and in the plants that grow from them. */
import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../../web/src/core/loader";
import {
	type BranchEdit,
	cutShare,
	MAX_EDITS,
	withEdit,
	withoutEdits,
} from "../../../../web/src/models/growth/edits/branch_edit";
import {
	bent,
	branchesOf,
	lengthOf,
	neighbourOf,
	placeUnderRay,
} from "../../../../web/src/models/growth/edits/branches";
import { model } from "../../../../web/src/models/growth/index";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { decodeQuery, encodeQuery } from "../../../../web/src/specimen/link";
import { restore } from "../../../../web/src/specimen/restore";
import { writtenSpecimen } from "../../../../web/src/specimen/written";

const ADDRESS = "0123456789abcdef";
const EDITS: readonly BranchEdit[] = [
	{ shoot: ADDRESS, kind: "prune", at: 0.4 },
	{ shoot: "fedcba9876543210", kind: "break", at: 0.99 },
	{ shoot: "ffffffffffffffff", kind: "dead" },
	{
		shoot: ADDRESS,
		kind: "curve",
		points: [
			[0.25, 1, -0.5],
			[-300, 0, 300],
		],
	},
];
const plain = fromPreset(model, "oak");
const edited = { ...plain, edits: EDITS };

describe("edits of branches in links and files", () => {
	it("come back from a link and from a file, and add nothing to the link of a plant without them", () => {
		const query = encodeQuery(model, edited);
		expect(query).toMatch(/&edit=1\.p[\w-]+\.b[\w-]+\.d[\w-]+\.c[\w-]+$/);
		expect(decodeQuery(model, query)).toEqual({ specimen: edited, notes: [] });
		expect(restore(model, JSON.parse(JSON.stringify(writtenSpecimen(model, edited)))).specimen).toEqual(edited);
		expect(encodeQuery(model, plain)).not.toContain("edit");
	});

	it("are short: a hundred cuts take less than 1,500 characters", () => {
		const edits = Array.from(
			{ length: 100 },
			(_, i): BranchEdit => ({ ...EDITS[0], shoot: String(i).padStart(16, "0") }) as BranchEdit,
		);
		expect(encodeQuery(model, { ...plain, edits }).length).toBeLessThan(1500);
	});

	it("are left out with a note where a link is damaged, of another version, or has too many", () => {
		const wrong = [
			"2.pAAAA",
			"p",
			"1.",
			"1.x0000000000",
			"1.pAAAAAAAAAAA",
			"1.p!!!!",
			"1.cASNFZ4mrze8",
			"1.dASNFZ4mrze8AAA",
		];
		for (const value of wrong) {
			const { specimen, notes } = decodeQuery(model, `?v=2&model=growth&preset=oak&edit=${value}`);
			expect(specimen.edits).toEqual([]);
			expect(notes).not.toHaveLength(0);
		}
		const [, one] = encodeQuery(model, { ...plain, edits: [EDITS[0]] }).split("edit=1.");
		const many = decodeQuery(model, `?v=2&model=growth&preset=oak&edit=1${`.${one}`.repeat(MAX_EDITS + 1)}`);
		expect(many.specimen.edits).toHaveLength(MAX_EDITS);
		expect(many.notes.map(({ text }) => text).join()).toContain("at most 256");
	});

	it("are left out with a note where a file has other values, and rounded to what links can hold", () => {
		const read = (edits: unknown) => restore(model, { v: 2, model: "growth", preset: "oak", edits });
		for (const wrong of [
			7,
			[7],
			[{ kind: "dead" }],
			[{ shoot: "xyz", kind: "dead" }],
			[{ shoot: ADDRESS, kind: "burn" }],
			[{ shoot: ADDRESS, kind: "prune" }],
			[{ shoot: ADDRESS, kind: "prune", at: 3 }],
			[{ shoot: ADDRESS, kind: "curve", points: [] }],
			[{ shoot: ADDRESS, kind: "curve", points: [[1, 2]] }],
			[{ shoot: ADDRESS, kind: "curve", points: Array.from({ length: 17 }, () => [1, 2, 3]) }],
		]) {
			const { specimen, notes } = read(wrong);
			expect(specimen.edits).toEqual([]);
			expect(notes).toHaveLength(1);
		}
		expect(read([{ shoot: ADDRESS, kind: "prune", at: 0.123 }]).specimen.edits).toEqual([{ ...EDITS[0], at: 0.12 }]);
	});

	it("replace an earlier edit of the same subject on the same branch", () => {
		const broken: BranchEdit = { shoot: ADDRESS, kind: "break", at: 0.2 };
		expect(withEdit(EDITS, broken)).toEqual([...EDITS.slice(1), broken]);
		expect(withoutEdits(EDITS, ADDRESS)).toEqual(EDITS.slice(1, 3));
		expect([cutShare(-1), cutShare(0.333), cutShare(2)]).toEqual([0.01, 0.33, 0.99]);
	});
});

describe("a grown tree", () => {
	let core: Core;
	beforeAll(async () => {
		core = await loadCoreFromBytes(readFileSync(new URL("../../../../build/core/growth.wasm", import.meta.url)));
		await model.prepare(plain);
	});
	const grow = (edits: readonly BranchEdit[]) => {
		const specimen = { ...plain, edits };
		return model.read(core.grow(model.encode(specimen)), specimen);
	};
	const notesOf = (edits: readonly BranchEdit[]) => grow(edits).notes;

	it("loses a pruned branch and keeps the others; edits of branches that it does not have are noted", () => {
		const whole = grow([]);
		const { trunks, byAddress } = branchesOf(whole);
		const limb = byAddress.get(trunks[0])?.children[1] ?? "";
		const pruned = grow([{ shoot: limb, kind: "prune", at: 0.3 }]);
		expect(pruned.counts.branches).toBeLessThan(whole.counts.branches);
		expect(pruned.meshes.some(({ name }) => name === "cuts")).toBe(true);
		const broken = grow([{ shoot: limb, kind: "break", at: 0.3 }]);
		expect(broken.meshes.some(({ name }) => name === "splinters")).toBe(true);
		expect(broken.deadSegments?.some((dead) => dead === 1)).toBe(true);
		const dead = grow([{ shoot: limb, kind: "dead" }]);
		expect(dead.counts.leaves).toBeLessThan(whole.counts.leaves);
		const unknown = grow([{ shoot: ADDRESS, kind: "dead" }]);
		expect(unknown.fingerprint).toBe(whole.fingerprint);
		expect(notesOf([{ shoot: ADDRESS, kind: "dead" }]).length).toBe(whole.notes.length + 1);
	});

	it("shows its dead wood and cut faces as parts with materials of their own", () => {
		const { trunks } = branchesOf(grow([]));
		const specimen = { ...plain, edits: [{ shoot: trunks[0], kind: "break", at: 0.6 }] as const };
		const plant = model.read(core.grow(model.encode(specimen)), specimen);
		const materials = [...model.parts(plant, specimen)].map(({ shape }) => shape?.material.name);
		expect(materials).toContain("Broken wood");
	});

	it("follows a drawn trunk", () => {
		const { trunks } = branchesOf(grow([]));
		const points = [1, 2, 3, 4].map((i) => [0.5 * i * i, 2 * i, 0] as const);
		const drawn = branchesOf(grow([{ shoot: trunks[0], kind: "curve", points }])).byAddress.get(trunks[0]);
		const line = drawn?.line ?? [];
		const tip = line[line.length - 1].map((value, k) => value - line[0][k]);
		expect(tip[0]).toBeCloseTo(8, 1);
		expect(tip[1]).toBeCloseTo(8, 1);
	});

	it("lists its branches with their parents, and finds the one that a ray meets", () => {
		const plant = grow([]);
		const branches = branchesOf(plant);
		const [trunk] = branches.trunks;
		expect(branches.byAddress.size).toBe(plant.counts.branches + branches.trunks.length);
		const first = neighbourOf(branches, trunk, "child") ?? "";
		expect(neighbourOf(branches, first, "parent")).toBe(trunk);
		expect(neighbourOf(branches, neighbourOf(branches, first, "next"), "previous")).toBe(first);
		expect(neighbourOf(branches, undefined, "next")).toBe(trunk);
		const place = placeUnderRay(plant, { origin: [30, 0.5, 0], direction: [-2, 0, 0] }, 0.002);
		expect(place?.address).toBe(trunk);
		expect(place?.at).toBeGreaterThan(0);
		expect(place?.at).toBeLessThan(0.2);
		expect(placeUnderRay(plant, { origin: [30, 0.5, 0], direction: [1, 0, 0] }, 0.002)).toBeUndefined();
	});
});

it("a bent line keeps its base and puts its tip where it is dragged", () => {
	const line = [0, 1, 2, 3, 4].map((y) => [1, y, 0] as const);
	const points = bent(line, 1, [3, 3, 1], 4);
	expect(points[3]).toEqual([2, 3, 1]);
	expect(points[0][0]).toBeLessThan(0.5);
	const bowed = bent(line, 0.5, [2, 2, 0], 4);
	expect(bowed[1][0]).toBeCloseTo(1);
	expect(bowed[3][0]).toBeCloseTo(0);
	expect(lengthOf(line)).toBe(4);
});
