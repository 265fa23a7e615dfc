import { beforeAll, expect, it } from "vitest";
import { aboutPlant } from "../../../../web/src/formats/about_plant";
import { exportGlb } from "../../../../web/src/formats/glb";
import { exportJson } from "../../../../web/src/formats/json";
import { model } from "../../../../web/src/models/stand/index";
import type { PlantRecord } from "../../../../web/src/models/stand/record";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import { complaints, documentOf } from "../../formats/reading";
import { grownStand, planned } from "./stands";

/** Two rows of three vines on a trellis; more bunches are requested than some vines have positions for. */
const PLAN = `ground 6 x 4, relief 0.4
plants 6, rows 2 x 1.2, towards 30
trellis 2, posts 2.4, wire 0.9, pair 1.4
growth/grapevine, crown 1.2 x 2, scale 0.9 to 1.1, seeds 2
leaf/oak, each 20 to 60, at bunch, scale 0.1, seeds 3
`;

let stand: StandPlant;
beforeAll(async () => {
	stand = await grownStand(planned(PLAN), { meshes: true });
}, 300_000);

it("hanging plants are at one organ of their parent each", () => {
	const { places, memberOf, members } = stand;
	const taken = new Set<string>();
	for (let plant = 0; plant < places.count; plant++) {
		const parent = places.parent[plant];
		if (parent < 0) continue;
		const spots = members[memberOf[parent]]?.spots?.bunch ?? new Float32Array(0);
		const [x, y, z] = [0, 1, 2].map((axis) => places.at[3 * plant + axis] - places.at[3 * parent + axis]);
		const turn = (places.turn[parent] * Math.PI) / 180;
		const size = places.scale[parent];
		const own = [x * Math.cos(turn) + z * Math.sin(turn), y, z * Math.cos(turn) - x * Math.sin(turn)].map(
			(v) => v / size,
		);
		const off = Array.from({ length: spots.length / 3 }, (_, i) =>
			Math.hypot(...own.map((value, axis) => value - spots[3 * i + axis])),
		);
		expect(Math.min(...off)).toBeLessThan(1e-4);
		const key = `${parent} ${off.indexOf(Math.min(...off))}`;
		expect(taken.has(key)).toBe(false);
		taken.add(key);
		expect([...places.transforms.subarray(8 * plant, 8 * plant + 3)]).toEqual([
			...places.at.subarray(3 * plant, 3 * plant + 3),
		]);
	}
	expect(taken.size).toBeGreaterThan(20);
});

it("plants without a free organ are left out with a note, and are not counted", () => {
	const { places, counts, notes } = stand;
	const attached = places.parent.filter((parent) => parent >= 0).length;
	expect(counts).toMatchObject({ plants: places.count, borne: attached });
	expect(notes.join()).toMatch(/\d+ plants? (was|were) left out/);
	const { plants } = exportJson(model, stand, planned(PLAN)) as unknown as { plants: PlantRecord[] };
	expect(plants).toHaveLength(places.count);
});

it("hangs with its parent only when that has grown", async () => {
	const early: StandPlant[] = [];
	const many = PLAN.replace("plants 6", "plants 20").replace(", seeds 2", "").replace("6 x 4", "20 x 12");
	await grownStand(planned(many), { grew: (grown) => early.push(grown as StandPlant) });
	expect(early.length).toBeGreaterThan(0);
	const { places, members, memberOf } = early[0];
	for (let plant = 0; plant < places.count; plant++)
		if (places.parent[plant] >= 0) expect(members[memberOf[places.parent[plant]]]).toBeDefined();
	expect(places.count).toBeGreaterThan(20);
});

it("posts and wires are parts of every file", async () => {
	const specimen = planned(PLAN);
	const file = exportGlb(model.parts(stand, specimen), await aboutPlant(model, stand, specimen), { instancing: true });
	expect(await complaints(file)).toEqual([]);
	const names = (documentOf(file) as { nodes: { name: string }[] }).nodes.map(({ name }) => name);
	expect(names).toEqual(expect.arrayContaining(["Ground", "Posts", "Wires"]));
	expect(stand.counts.posts).toBeGreaterThan(3);
});
