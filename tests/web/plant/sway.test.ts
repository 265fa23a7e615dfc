/** How wind moves plants: laws that hold of every model's. */
import { beforeAll, describe, expect, it } from "vitest";
import { modelNamed } from "../../../web/src/models/index";
import type { Vector } from "../../../web/src/plant/part";
import type { Plant } from "../../../web/src/plant/plant";
import { swing } from "../../../web/src/plant/point_sway";
import { type Sway, swayOf } from "../../../web/src/plant/sway";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { restore } from "../../../web/src/specimen/restore";
import { freshCore } from "../core/wasm";

/** How far it comes from where it stands, at most. */
function farthest({ sine, cosine }: ReturnType<typeof swing>): number {
	const angles = Array.from({ length: 64 }, (_, i) => (2 * Math.PI * i) / 64);
	return Math.max(...angles.map((a) => Math.hypot(...sine.map((s, k) => s * Math.sin(a) + cosine[k] * Math.cos(a)))));
}

const at = (values: ArrayLike<number>, i: number): Vector => [values[i], values[i + 1], values[i + 2]];

describe.each([
	["bunch", "riesling", {}, -1],
	["leaf", "maple", { n: 300 }, 1],
	["tree", "oak", { n: 200 }, 1],
	["grammar", "lilac", {}, 1],
	["growth", "table-1-sigma1", { steps: 5 }, 1],
] as const)("the sway of %s/%s", (name, preset, changed, up) => {
	let plant: Plant;
	let sway: Sway;
	beforeAll(async () => {
		const model = await modelNamed(name);
		const { specimen } = restore(model, changed, fromPreset(model, preset));
		await model.prepare?.(specimen);
		const core = await freshCore(model.wasm);
		plant = model.read(core.grow(model.encode(specimen, { meshes: false, measures: false })), specimen);
		sway = swayOf(plant) as Sway;
	});

	it("knows what stands and what hangs, and leaves the foot where it is", () => {
		expect(sway.up).toBe(up);
		const first = at(plant.segments.ends, 0);
		expect(farthest(swing(sway, [first[0], sway.foot[1], first[2]]))).toBe(0);
		for (let i = 0; i < plant.segments.count; i++)
			if (plant.segments.parent[i] < 0 && plant.segments.ends[6 * i + 1] === sway.foot[1])
				expect(farthest(swing(sway, at(plant.segments.ends, 6 * i)))).toBe(0);
	});

	it("is calm: the top goes 2 to 3 hundredths of the height, nothing more than that and as much of the reach", () => {
		const top: Vector = [sway.foot[0], sway.foot[1] + sway.up * sway.height, sway.foot[2]];
		const share = farthest(swing(sway, top)) / sway.height;
		expect(share).toBeGreaterThan(0.02);
		expect(share).toBeLessThan(0.03);
		const most = 0.03 * sway.height + 0.03 * sway.reach;
		let moves = 0;
		for (let i = 3; i < plant.segments.ends.length; i += 6) {
			const far = farthest(swing(sway, at(plant.segments.ends, i)));
			expect(far).toBeLessThan(most);
			if (far > 0.002 * sway.height) moves++;
		}
		expect(moves).toBeGreaterThan(plant.segments.count / 10);
	});

	it("holds matter together: ends on ends, organs' feet on what bears them, and nothing is drawn out", () => {
		const { ends, count, parent } = plant.segments;
		const { transforms } = plant.organs;
		for (let i = 0; i < transforms.length; i += 8) {
			const foot = at(transforms, i);
			expect(swing(sway, foot, foot)).toEqual(swing(sway, foot));
		}
		const place = (swings: ReturnType<typeof swing>, from: Vector, a: number) =>
			from.map((value, k) => value + swings.sine[k] * Math.sin(a) + swings.cosine[k] * Math.cos(a));
		for (let i = 0; i < count; i++) {
			if (parent[i] < 0) continue;
			const [start, end] = [at(ends, 6 * i), at(ends, 6 * i + 3)];
			const [s, e] = [swing(sway, start), swing(sway, end)];
			const length = Math.hypot(...start.map((value, k) => end[k] - value));
			for (const a of [0, 1, 2, 3, 4, 5]) {
				const [from, to] = [place(s, start, a), place(e, end, a)];
				const now = Math.hypot(...from.map((value, k) => to[k] - value));
				expect(Math.abs(now - length)).toBeLessThan(0.2 * length + 1e-9);
			}
		}
	});

	it("turns what is held about its foot, as stiff as it is", () => {
		const held: Vector = [sway.foot[0] + 0.4 * sway.reach, sway.foot[1] + 0.7 * sway.up * sway.height, sway.foot[2]];
		const tip: Vector = [held[0], held[1], held[2] + 0.05];
		const [foot, far] = [swing(sway, held), swing(sway, tip, held)];
		const apart = Math.max(
			...far.sine.map((value, k) => Math.abs(value - foot.sine[k])),
			...far.cosine.map((value, k) => Math.abs(value - foot.cosine[k])),
		);
		expect(apart).toBeGreaterThan(0.05 * 0.02);
		expect(apart).toBeLessThan(0.05 * 0.11);
	});
});

it("is none of what has no extent", () => {
	const none = {
		count: 0,
		parent: new Int32Array(0),
		tag: new Uint32Array(0),
		tags: [],
		ends: new Float32Array(0),
		radii: new Float32Array(0),
	};
	const organs = {
		count: 0,
		tag: new Uint32Array(0),
		tags: [],
		segment: new Int32Array(0),
		mesh: new Int32Array(0),
		transforms: new Float32Array(0),
	};
	expect(swayOf({ segments: none, organs })).toBeUndefined();
	const point = { ...none, count: 1, parent: Int32Array.of(-1), ends: new Float32Array(6) };
	expect(swayOf({ segments: point, organs })).toBeUndefined();
});
