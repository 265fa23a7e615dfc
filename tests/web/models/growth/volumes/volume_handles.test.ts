import { describe, expect, it } from "vitest";
import {
	axisOf,
	type GrowthVolume,
	placeIn,
	radiusAt,
	surfaceOf,
} from "../../../../../web/src/models/growth/volumes/volume";
import { volumeHandles } from "../../../../../web/src/models/growth/volumes/volume_handles";
import type { Change } from "../../../../../web/src/ui/editor_context";
import type { PlantHandle } from "../../../../../web/src/ui/handles/plant_handle";

const ONE: GrowthVolume = { id: 1, base: 4, height: 10, top: 2, middle: 3, gradient: 0, towards: 0, at: [1, 2] };
const TWO: GrowthVolume = { id: 2, base: 3, height: 6, top: 1, middle: 3, gradient: 30, towards: 90, at: [-3, 0] };

/** Volumes after a drag. */
const put = (volumes: readonly GrowthVolume[]): Change => ({ details: { volumes } });
const left = ({ details }: Change) => details?.volumes as readonly GrowthVolume[];
const handle = (id: string, chosen = 0): PlantHandle => {
	const found = volumeHandles([ONE, TWO], chosen, put).handles.find((each) => each.id === id);
	if (!found) throw new Error(`no handle ${id}`);
	return found;
};
const near = (one: readonly number[], other: readonly number[]) =>
	one.forEach((value, k) => {
		expect(value).toBeCloseTo(other[k], 9);
	});

describe("a growth volume", () => {
	it("has its position and lean", () => {
		near(axisOf(TWO), [0, Math.cos(Math.PI / 6), 0.5]);
		near(placeIn(ONE, 1), [1, 10, 2]);
		near(placeIn(TWO, 1), [-3, 6 * Math.cos(Math.PI / 6), 3]);
		// Its circles are perpendicular to its axis, with its widths.
		for (const about of [0, 70, 200]) {
			const rim = placeIn(TWO, 1, 0.5, about).map((value, k) => value - placeIn(TWO, 1)[k]);
			expect(Math.hypot(...rim)).toBeCloseTo(0.5, 9);
			expect(rim.reduce((sum, value, k) => sum + value * axisOf(TWO)[k], 0)).toBeCloseTo(0, 9);
		}
	});

	it("is a frustum where it is as wide halfway up as in the mean, and else a quadric through its three widths", () => {
		for (const up of [0, 0.2, 0.5, 0.9, 1]) expect(radiusAt(ONE, up)).toBeCloseTo(2 - up, 9);
		const ball = { base: 0, middle: 6, top: 0 };
		for (const up of [0, 0.1, 0.5, 1]) expect(radiusAt(ball, up)).toBeCloseTo(6 * Math.sqrt(up * (1 - up)), 9);
		expect([0, 0.5, 1].map((up) => 2 * radiusAt(TWO, up))).toEqual([3, 3, 1]);
	});

	it("has a closed surface: every edge is that of two triangles, once each way", () => {
		const { points, triangles } = surfaceOf(TWO);
		// Rings that shrink to the axis are one place.
		const key = (at: number) =>
			points
				.slice(3 * at, 3 * at + 3)
				.map((value) => value.toFixed(6))
				.join(" ");
		const edges = new Map<string, number>();
		for (let t = 0; t < triangles.length; t += 3) {
			const corners = triangles.slice(t, t + 3).map(key);
			if (new Set(corners).size < 3) continue;
			corners.forEach((corner, k) => {
				const edge = `${corner}|${corners[(k + 1) % 3]}`;
				edges.set(edge, (edges.get(edge) ?? 0) + 1);
			});
		}
		for (const [edge, count] of edges) {
			expect(count).toBe(1);
			expect(edges.has(edge.split("|").reverse().join("|"))).toBe(true);
		}
	});
});

describe("handles of growth volumes", () => {
	it("are at each foot, and on the chosen volume's height, lean and widths", () => {
		const { handles } = volumeHandles([ONE, TWO], 1, put);
		expect(handles.map(({ label, value }) => `${label}: ${value}`)).toEqual([
			"Growth volume 1: x 1.0, z 2.0",
			"Growth volume 2: x -3.0, z 0.0",
			"Height of growth volume 2: 6.0 m",
			"Lean of growth volume 2: 30° towards 90°",
			"Width at the base of growth volume 2: 3.0 m",
			"Width in the middle of growth volume 2: 3.0 m",
			"Width at the top of growth volume 2: 1.0 m",
		]);
		expect(handles.map(({ kind }) => kind)).toEqual([undefined, "chosen", "size", "turn", "size", "size", "size"]);
	});

	it("change the volume as dragged, and leave the others alone", () => {
		expect(left(handle("volume-0").pull([5, 9, -1]))).toEqual([{ ...ONE, at: [5, -1] }, TWO]);
		expect(left(handle("height").pull([1, 7, 2]))).toEqual([{ ...ONE, height: 7 }, TWO]);
		expect(left(handle("height").pull([1, -7, 2]))[0].height).toBe(0.5);
		const wide = handle("base");
		expect(left(wide.pull(placeIn(ONE, 0, 3)))[0].base).toBeCloseTo(6, 9);
		expect(left(wide.pull(placeIn(ONE, 0, -3)))[0].base).toBe(0);
		// A frustum stays one, and a curve as wide halfway up as it was.
		expect(left(wide.pull(placeIn(ONE, 0, 3)))[0].middle).toBeCloseTo(4, 9);
		expect(left(handle("base", 1).pull(placeIn(TWO, 0, 3)))[1].middle).toBe(3);
		expect(left(handle("middle").pull(placeIn(ONE, 0.5, 5)))[0]).toMatchObject({ middle: 10, base: 4, top: 2 });
		expect(left(handle("top", 1).pull(placeIn(TWO, 1, 2)))[1].top).toBeCloseTo(4, 9);
		const leant = left(handle("lean").pull([1, 5, 7]))[0];
		expect([leant.gradient, leant.towards]).toEqual([45, 90]);
		// An upright volume keeps its direction of lean.
		expect(left(handle("lean", 1).pull([-3, 5, 0]))[1]).toEqual({ ...TWO, gradient: 0 });
	});

	it("stay under the pointer", () => {
		for (const chosen of [0, 1])
			for (const id of ["height", "lean", "base", "middle", "top"]) {
				const { at, pull } = handle(id, chosen);
				near(placeIn(left(pull(at))[chosen], 1), placeIn([ONE, TWO][chosen], 1));
				expect(left(pull(at))[chosen].base).toBeCloseTo([ONE, TWO][chosen].base, 9);
			}
	});

	it("go by keys, in steps and strides", () => {
		expect(left(handle("volume-0").nudge(1, 0, false))[0].at).toEqual([1.1, 2]);
		expect(left(handle("volume-0").nudge(0, 1, true))[0].at).toEqual([1, 1]);
		expect(left(handle("height").nudge(0, 1, true))[0].height).toBe(11);
		expect(left(handle("base").nudge(-1, 0, true))[0].base).toBe(3);
		expect(left(handle("lean", 1).nudge(0, 1, false))[1].gradient).toBe(28);
		expect(left(handle("lean", 1).nudge(1, 0, true))[1].towards).toBe(100);
	});

	it("remove a volume, but not the last", () => {
		const removed = handle("volume-1").remove?.();
		expect(removed && left(removed)).toEqual([ONE]);
		expect(volumeHandles([ONE], 0, put).handles.every(({ remove }) => remove === undefined)).toBe(true);
	});
});
