import { Vector3 } from "three";
import { beforeAll, expect, it } from "vitest";
import { aboutPlant } from "../../../../web/src/formats/about_plant";
import { exportGlb } from "../../../../web/src/formats/glb";
import { betweenRows } from "../../../../web/src/models/stand/alley";
import { heightAt } from "../../../../web/src/models/stand/ground_grid";
import { model } from "../../../../web/src/models/stand/index";
import { titlesOf } from "../../../../web/src/models/stand/members";
import { firstPlantHit } from "../../../../web/src/models/stand/render/plant_hit";
import { isWalking, shadedBall } from "../../../../web/src/models/stand/render/shaded";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import { atFront, gazeOf, stepped, turned } from "../../../../web/src/models/stand/walker";
import { standInWords } from "../../../../web/src/models/stand/words";
import { packed, reachOf, unpacked } from "../../../../web/src/plant/packed_mesh";
import { STEPS, stepAt } from "../../../../web/src/render/level_choice";
import { documentOf } from "../../formats/reading";
import { grownStand, PLAN, planned } from "./stands";

let stand: StandPlant;
beforeAll(async () => {
	stand = await grownStand(planned(PLAN), { meshes: true });
}, 300_000);

const specimen = planned(PLAN);
const near = { ...specimen, look: { ...specimen.look, detail: 0 } };

it("levels of detail have fewer and fewer triangles, within what the first takes up", () => {
	for (const member of stand.members) {
		const counts = member?.levels.map((level) => level.reduce((sum, { mesh }) => sum + mesh.indices.length, 0)) ?? [];
		expect(counts.length).toBeGreaterThan(1);
		for (const [i, count] of counts.slice(1).entries()) expect(count).toBeLessThanOrEqual(counts[i]);
	}
});

it("files have the ground and each plant once, and shared meshes where plants are alike", async () => {
	const about = await aboutPlant(model, stand, specimen);
	const sizes: number[] = [];
	for (const each of [near, specimen]) {
		const file = exportGlb(model.parts(stand, each), about, { instancing: true });
		const { nodes, extensionsUsed } = documentOf(file) as {
			nodes: { name: string; extensions?: object }[];
			extensionsUsed: string[];
		};
		expect(extensionsUsed).toContain("EXT_mesh_gpu_instancing");
		// Four leaves share a node per part; a single plant has its own node.
		const shared = nodes.filter(({ extensions }) => extensions);
		expect(shared.length).toBeGreaterThan(0);
		for (const { name } of shared) expect(name).toContain("leaf/oak");
		expect(nodes.some(({ name }) => name === "Ground")).toBe(true);
		sizes.push(file.length);
	}
	expect(sizes[1]).toBeLessThan(0.6 * sizes[0]);
});

it("packed meshes are unpacked with an error of at most a thirty-thousandth of their size", () => {
	const mesh = {
		positions: Float32Array.of(0, -10, 3, 1, 2, 5),
		normals: Float32Array.of(0, 1, 0, 0.6, 0, 0.8),
		uvs: new Float32Array(0),
		indices: Uint32Array.of(0, 1, 0),
		sky: Uint8Array.of(3, 250),
	};
	const back = unpacked(packed(mesh, reachOf([mesh])));
	for (const [i, value] of mesh.positions.entries()) expect(Math.abs(back.positions[i] - value)).toBeLessThan(2e-4);
	for (const [i, value] of mesh.normals.entries()) expect(Math.abs(back.normals[i] - value)).toBeLessThan(0.01);
	expect([...back.indices]).toEqual([0, 1, 0]);
	expect([...(back.sky ?? [])]).toEqual([3, 250]);
});

it("a ray hits the nearest crown, and none beside crowns", () => {
	const { at, scale } = stand.places;
	const { extent } = stand.members[0] ?? { extent: { high: 0 } };
	const middle = at[1] + 0.5 * scale[0] * extent.high;
	expect(firstPlantHit(stand, { origin: [at[0], 100, at[2]], direction: [0, -1, 0] })).toBe(0);
	expect(firstPlantHit(stand, { origin: [at[0], middle, 900], direction: [0, 1, 0] })).toBeUndefined();
});

it("chooses a level by size, and dithers between two levels", () => {
	expect(stepAt(2, 4)).toBe(0);
	expect(stepAt(0.001, 4)).toBe(3 * STEPS);
	expect(stepAt(2, 1)).toBe(0);
	let before = 0;
	for (let size = 2; size > 0.01; size *= 0.995) {
		const now = stepAt(size, 4);
		// Levels only become coarser, and gradually.
		expect(now).toBeGreaterThanOrEqual(before);
		expect(now - before).toBeLessThan(0.25 * STEPS);
		before = now;
	}
	expect(before).toBe(3 * STEPS);
});

it("a walker stays on the ground at eye height, and looks in the direction of the turn", () => {
	let pose = { ...atFront(stand), x: 0 };
	for (let i = 0; i < 100; i++) pose = stepped(pose, "forward", stand);
	expect([pose.x, pose.z]).toEqual([0, -5]);
	const { eye, towards } = gazeOf(turned(pose, 90, 0), stand);
	expect(eye[1] - heightAt(stand, 0, -5)).toBeCloseTo(1, 5);
	expect(towards[0] - eye[0]).toBeCloseTo(1, 5);
	expect(stepped(pose, "turn left", stand).yaw).toBe(-12);
	const ground = stand.meshes[0].positions;
	expect(heightAt(stand, ground[30], ground[32])).toBeCloseTo(ground[31], 5);
	expect(turned(pose, 0, 500).pitch).toBe(60);
});

it("a walk starts clear of crowns, as close to the centre of the front as possible", () => {
	const planted = (...across: number[]) => ({
		...stand,
		ground: { width: 40, depth: 40, relief: 0 },
		places: {
			...stand.places,
			count: across.length,
			at: Float32Array.from(across.flatMap((x) => [x, 0, 18])),
			scale: new Float32Array(across.length).fill(1),
			kind: new Uint32Array(across.length),
			parent: new Int32Array(across.length).fill(-1),
		},
		kinds: stand.kinds.map((kind) => ({ ...kind, crown: { width: 4, height: 8 } })),
	});
	expect(atFront(planted())).toEqual({ x: 0, z: 19.2, yaw: 0, pitch: 0 });
	expect(Math.abs(atFront(planted(0)).x)).toBeCloseTo(5.6, 5);
	expect(atFront(planted(0, 4, 8, 12, 16)).x).toBeCloseTo(-5.6, 5);
	const attached = planted(0);
	attached.places.parent[0] = 0;
	expect(atFront(attached).x).toBe(0);
});

it("a walk in a plantation starts between the two middle rows and looks along them, in any direction", () => {
	/** Five rows of twelve plants, 2.2 m apart, in a direction from +x to +z. */
	const rows = (degrees: number, gap = 2.2) => {
		const [cosine, sine] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
		const at = [-2, -1, 0, 1, 2].flatMap((row) =>
			Array.from({ length: 12 }, (_, i) => [1.2 * (i - 5.5), gap * row] as const).flatMap(([along, across]) => [
				along * cosine - across * sine,
				0,
				along * sine + across * cosine,
			]),
		);
		const count = at.length / 3;
		return {
			...stand,
			ground: { width: 20, depth: 20, relief: 0 },
			places: {
				...stand.places,
				count,
				at: Float32Array.from(at),
				scale: new Float32Array(count).fill(1),
				kind: new Uint32Array(count),
				parent: new Int32Array(count).fill(-1),
			},
			kinds: stand.kinds.map((kind) => ({ ...kind, crown: { width: 1.2, height: 2 } })),
		};
	};
	for (const degrees of [0, 30, 90, 135]) {
		const planted = rows(degrees);
		const pose = betweenRows(planted);
		if (!pose) throw new Error("no rows");
		// The view is parallel to the rows, both ways alike.
		expect((((pose.yaw - 90 - degrees) % 180) + 180) % 180).toBeCloseTo(0, 5);
		const angle = (degrees * Math.PI) / 180;
		expect(Math.abs(pose.z * Math.cos(angle) - pose.x * Math.sin(angle))).toBeCloseTo(1.1, 3);
		expect(Math.max(Math.abs(pose.x), Math.abs(pose.z))).toBeLessThan(10);
		// The alley lies ahead: a long way, past the middle of the ground.
		let ahead = pose;
		for (let i = 0; i < 12; i++) ahead = stepped(ahead, "forward", planted);
		expect(Math.hypot(ahead.x, ahead.z)).toBeLessThan(Math.hypot(pose.x, pose.z));
	}
	expect(betweenRows(rows(0, 1.2))).toBeUndefined();
	expect(betweenRows(stand)).toBeUndefined();
	expect(betweenRows({ ...rows(0), places: { ...rows(0).places, count: 0 } })).toBeUndefined();
});

it("the caption counts attached plants separately, and the map uses the kinds' titles", () => {
	expect(standInWords(stand)).toBe("10 plants with 4 attached plants of 4 kinds on 20 × 10 m");
	const titles = titlesOf(stand);
	expect(titles[3]).toBe("Oak");
	expect(titles.join()).not.toContain("/");
	// Before a plant of the kind has grown, by the name in the plan.
	expect(titlesOf({ ...stand, members: [] })[3]).toBe("Oak");
	const kinds = stand.kinds.map((kind) => ({ ...kind, preset: "long-conical" }));
	expect(titlesOf({ ...stand, kinds, members: [] })[0]).toBe("Long conical");
});

it("shadows cover the stand or, while walking, the area ahead, in steps", () => {
	const wide = { ...stand, ground: { width: 200, depth: 200, relief: 0 }, meshes: [] };
	const whole = { centre: new Vector3(), radius: 150 };
	const ahead = new Vector3(0, 0, -1);
	const at = (x: number, y: number, z: number) => shadedBall(wide, whole, new Vector3(x, y, z), ahead);
	expect([isWalking(wide, new Vector3(0, 30, 0)), isWalking(wide, new Vector3(99, 1.65, 0))]).toEqual([false, true]);
	expect(at(0, 30, 0)).toBe(whole);
	expect(at(0, 1.65, 101)).toBe(whole);
	const { centre, radius } = at(0, 1.65, 0);
	expect(radius).toBeLessThan(50);
	expect(centre.z).toBeLessThan(-0.4 * radius);
	expect(at(0, 1.65, -0.4).centre).toEqual(centre);
	const places = new Set(Array.from({ length: 100 }, (_, i) => at(0, 1.65, -0.5 * i).centre.z));
	expect(places.size).toBeGreaterThan(4);
	expect(places.size).toBeLessThan(8);
	expect(shadedBall(stand, { centre: new Vector3(), radius: 1 }, new Vector3(0, 1, 0), ahead).radius).toBe(1);
});
