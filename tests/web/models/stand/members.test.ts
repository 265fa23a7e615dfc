import { afterEach, beforeAll, describe, expect, it, vi } from "vitest";
import { CoreError } from "../../../../web/src/core/errors";
import { aboutPlant } from "../../../../web/src/formats/about_plant";
import { exportGlb } from "../../../../web/src/formats/glb";
import { exportJson } from "../../../../web/src/formats/json";
import { growPlant } from "../../../../web/src/generate/growth";
import { grownMembers, MemberCache } from "../../../../web/src/generate/members";
import { readGrowthPlant } from "../../../../web/src/models/growth/growth_plant";
import type { GrowthSpecimen } from "../../../../web/src/models/growth/specimen";
import { modelNamed } from "../../../../web/src/models/index";
import { model } from "../../../../web/src/models/stand/index";
import { type PlantRecord, placementsCsv } from "../../../../web/src/models/stand/record";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import { decodeLink } from "../../../../web/src/specimen/link";
import type { Specimen } from "../../../../web/src/specimen/specimen";
import { grownStand, PLAN, planned, run } from "./stands";

let stand: StandPlant;
beforeAll(async () => {
	stand = await grownStand();
}, 300_000);

const prints = ({ members }: StandPlant) => members.map((member) => member?.fingerprint);
const refused = async (plan: string) => {
	const error = await grownStand(planned(plan)).catch((reason: unknown) => reason);
	expect(error).toBeInstanceOf(CoreError);
	const { message, line, column } = error as CoreError;
	return { message, line, column };
};

describe("the members of a stand", () => {
	it("do not depend on the order in which they grow", async () => {
		let turn = 0;
		// Some responses are late: others overtake them.
		const uneven: typeof run = async (wasm, blocks) => {
			const answer = await run(wasm, blocks);
			await new Promise((resolve) => setTimeout(resolve, (turn++ % 3) * 7));
			return answer;
		};
		const again = await grownStand(planned(PLAN), { concurrency: 5, run: uneven });
		expect(prints(again)).toEqual(prints(stand));
		expect(again.fingerprint).toBe(stand.fingerprint);
		expect(stand.fingerprint).toMatch(/^[0-9a-f]{16}$/);
	});

	it("can each be grown alone by the link in the stand's record", async () => {
		const growth = await modelNamed("growth");
		const member = stand.members[4];
		if (!member) throw new Error("it has not grown");
		const { plants } = exportJson(model, stand, planned(PLAN)) as unknown as { plants: PlantRecord[] };
		const { link = "", fingerprint } = plants[4];
		expect(link.length).toBeLessThan(200);
		const { specimen, notes } = await decodeLink(growth, link);
		expect(notes).toEqual([]);
		expect(specimen).toEqual(member.specimen);
		const alone = async (of: Specimen) => growPlant(growth, of, { meshes: false, measures: false }, run);
		expect((await alone(specimen)).fingerprint).toBe(fingerprint);
		const { surroundings: _, ...lone } = specimen as GrowthSpecimen;
		expect((await alone(lone)).fingerprint).not.toBe(fingerprint);
	});

	it("differ by seed and by what is drawn for them, and are alike where a line has so many seeds", () => {
		expect(stand.places.count).toBe(14);
		expect(new Set(prints(stand)).size).toBe(11);
		expect([...stand.memberOf.slice(10)]).toEqual([10, 10, 10, 10]);
		expect([...stand.places.parent.slice(10)]).toEqual([8, 8, 9, 9]);
		const steps = stand.members.slice(0, 8).map((member) => member?.specimen.parameters.steps);
		for (const each of steps) expect([3, 4, 5]).toContain(each);
		expect(new Set(steps).size).toBeGreaterThan(1);
	});

	it("depend on their neighbours", async () => {
		const close = "ground 4 x 4\nplants 4, rows 2 x 2\ngrowth/table-1-star, crown 8 x 12: steps 6";
		const alone = close.replace("crown 8 x 12", "crown 0.1 x 0.1");
		expect(prints(await grownStand(planned(close)))).not.toEqual(prints(await grownStand(planned(alone))));
	});

	it("are not grown again for the same request", async () => {
		let grown = 0;
		const counted: typeof run = (wasm, blocks) => {
			if (wasm !== model.wasm) grown++;
			return run(wasm, blocks);
		};
		const cache = new MemberCache();
		for (const counts of [11, 0]) {
			grown = 0;
			const { members: _, ...bare } = stand;
			const plan = { ...bare, members: [] };
			const whole = (await grownMembers(model, plan, counted, { meshes: false, cache })) as StandPlant;
			expect(prints(whole)).toEqual(prints(stand));
			expect(grown).toBe(counts);
		}
	});

	it("are listed in JSON and in a table", () => {
		const { plants, counts } = exportJson(model, stand, planned(PLAN)) as unknown as {
			plants: Record<string, unknown>[];
			counts: Record<string, number>;
		};
		expect(counts).toEqual({ plants: 14, kinds: 4, borne: 4 });
		expect(plants).toHaveLength(14);
		expect(plants[0]).toMatchObject({ model: "growth", seed: stand.places.seed[0], fingerprint: prints(stand)[0] });
		expect(plants[13]).toMatchObject({ model: "leaf", preset: "oak", bearer: 9 });
		const [head, ...rows] = placementsCsv(stand, planned(PLAN)).trimEnd().split("\r\n");
		expect(head.split(",").slice(0, 6)).toEqual(["stand", "stand_seed", "plant", "model", "preset", "seed"]);
		expect(rows).toHaveLength(14);
		expect(rows[0]).toContain(prints(stand)[0]);
	});
});

describe("an unknown model, preset or setting in a plan", () => {
	it("is reported with its position and the known names", async () => {
		const some = "plants 3, random\n";
		expect(await refused(`${some}trees/oak`)).toEqual({
			message: expect.stringMatching(/^There is no model trees\. The models are bunch, .*growth/),
			line: 2,
			column: 1,
		});
		expect(await refused(`${some}growth/baobab`)).toMatchObject({
			message: expect.stringMatching(/figure-5/),
			line: 2,
		});
		expect(await refused(`${some}growth/figure-5: stepps 3`)).toMatchObject({
			message: expect.stringMatching(/no parameter stepps\. Its parameters are .*steps/),
			line: 2,
			column: 18,
		});
		expect(await refused(`${some}stand/orchard`)).toMatchObject({
			message: expect.stringMatching(/cannot contain plants of the same model/),
		});
	});

	it("is clamped with a note where it is out of range", async () => {
		const { notes } = await grownStand(planned("plants 2, random\ngrowth/figure-5: steps 3, flare 900"));
		expect(notes).toEqual([expect.stringMatching(/^growth\/figure-5: .*flare/)]);
	});
});

describe("problems with members", () => {
	afterEach(() => {
		vi.restoreAllMocks();
	});

	it("reports a plant that cannot grow at the line that requests it", async () => {
		const failing: typeof run = (wasm, blocks) =>
			wasm === "growth.wasm"
				? Promise.reject(new CoreError("evaluation", "There is no sun.", 40, 7))
				: run(wasm, blocks);
		const error = await grownStand(planned("plants 2, random\ngrowth/figure-5: steps 3"), { run: failing }).catch(
			(reason: unknown) => reason,
		);
		const report = { reason: "evaluation", message: "growth/figure-5: There is no sun.", line: 2, column: 1 };
		expect(error).toMatchObject(report);
	});

	it("reports data that could not be fetched once per line, and grows the affected plants again", async () => {
		const growth = await modelNamed("growth");
		const prepare = vi.spyOn(growth, "prepare").mockRejectedValue(new Error("No network."));
		const cache = new MemberCache();
		const plan = planned("plants 6, random\ngrowth/figure-5: steps 1 to 3\ngrowth/table-1-star: steps 2");
		const lacking = await grownStand(plan, { cache });
		expect(prepare).toHaveBeenCalledTimes(2);
		const why = "Data for this plant could not be loaded: No network.";
		expect(lacking.notes).toContain(`growth/figure-5: ${why}`);
		expect(lacking.notes).toContain(`growth/table-1-star: ${why}`);
		expect(cache.retain(model.members.requests(lacking), false).every((member) => member === undefined)).toBe(true);
		prepare.mockRestore();
		const { notes, members } = await grownStand(plan, { cache });
		expect(notes).toEqual([]);
		expect(cache.retain(model.members.requests(lacking), false)).toEqual(members);
	});

	it("reports each core's notes once", async () => {
		const growth = await modelNamed("growth");
		const read = vi.spyOn(growth, "read");
		read.mockImplementation((answer, specimen) => ({
			...readGrowthPlant(answer, specimen as GrowthSpecimen),
			notes: ["It is dry."],
		}));
		const cache = new MemberCache();
		const plan = planned("plants 3, random\ngrowth/figure-5: steps 2");
		const notes = [(await grownStand(plan, { cache })).notes, (await grownStand(plan, { cache })).notes];
		expect(read).toHaveBeenCalledTimes(3);
		read.mockRestore();
		for (const each of notes) expect(each).toEqual(["growth/figure-5: It is dry."]);
	});

	it("reports too much memory at the line that exceeds the limit", async () => {
		const plan = planned("plants 4, random\ngrowth/figure-5: steps 3");
		const error = await grownStand(plan, { meshes: true, most: 1000 }).catch((reason: unknown) => reason);
		expect(error).toMatchObject({ reason: "limit", message: expect.stringMatching(/seeds 20/), line: 2, column: 1 });
	});

	it("notes missing members until all have grown", async () => {
		const early: (readonly string[])[] = [];
		const plan = planned("plants 40, random\ngrowth/figure-5: steps 1");
		const { notes } = await grownStand(plan, { grew: (grown) => early.push(grown.notes) });
		expect(early).toEqual([
			["Only 16 of 40 different plants have grown."],
			["Only 32 of 40 different plants have grown."],
		]);
		expect(notes).toEqual([]);
	});
});

it("files do not depend on the stand before", async () => {
	const cache = new MemberCache();
	const plan =
		"plants 4, rows 2 x 2\ngrowth/table-1-sigma1, crown 1 x 1: steps 3\ngrowth/table-1-star, crown 1 x 1: steps 3";
	await grownStand(planned(plan.replace(/3$/, "2")), { meshes: true, cache });
	const specimen = planned(plan);
	const [after, fresh] = [
		await grownStand(specimen, { meshes: true, cache }),
		await grownStand(specimen, { meshes: true }),
	];
	const about = await aboutPlant(model, fresh, specimen);
	const file = (stand: StandPlant) => exportGlb(model.parts(stand, specimen), about, { instancing: true });
	expect(Buffer.compare(file(after), file(fresh))).toBe(0);
});
