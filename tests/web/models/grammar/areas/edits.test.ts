import { describe, expect, it } from "vitest";
import {
	type Area,
	degreesOf,
	placeIn,
	rotate,
	rotationOf,
	type Triple,
	UNTURNED,
} from "../../../../../web/src/models/grammar/areas/area";
import * as edits from "../../../../../web/src/models/grammar/areas/area_edits";
import { areaHandles, areaHandlesOf } from "../../../../../web/src/models/grammar/areas/area_handles";
import { surfaceOf } from "../../../../../web/src/models/grammar/areas/surface";
import { GRAMMAR } from "../../../../../web/src/models/grammar/schema";
import type { GrammarSpecimen } from "../../../../../web/src/models/grammar/specimen";
import { fromPreset } from "../../../../../web/src/specimen/from_preset";
import { apply } from "../../../../../web/src/ui/change";
import type { Change } from "../../../../../web/src/ui/editor_context";
import type { HandleVector, PlantHandle } from "../../../../../web/src/ui/handles/plant_handle";

const area = (kind: Area["kind"], centre: Triple, size: Triple = [1, 1, 1], rotation = UNTURNED): Area => ({
	kind,
	centre,
	size,
	rotation,
});
const start: GrammarSpecimen = {
	...fromPreset(GRAMMAR, "bush"),
	areas: [area("box", [0, 0.8, 0]), area("cone", [0.5, 2, 0], [1, 2, 0.5], rotationOf([0, 0, 90]))],
};
const made = (change: Change | undefined, from = start) => apply(GRAMMAR, from, change as Change);
const handleOf = (specimen: GrammarSpecimen, id: string, chosen?: number) =>
	areaHandles(specimen, { area: chosen, path: id.startsWith("place") }).handles.find(
		(each) => each.id === id,
	) as PlantHandle;
const close = (found: readonly number[] | undefined, wanted: readonly number[]) => {
	for (const [i, value] of wanted.entries()) expect(found?.[i]).toBeCloseTo(value, 2);
};

describe("edits of growth areas", () => {
	it("adds, orders and removes them", () => {
		const more = made(edits.added(start, "sphere"));
		expect(more.areas?.map(({ kind }) => kind)).toEqual(["box", "cone", "sphere"]);
		expect(more.areas?.[2].centre[1]).toBeGreaterThan(2);
		expect(made(edits.reordered(more, 2, -1), more).areas?.map(({ kind }) => kind)).toEqual(["box", "sphere", "cone"]);
		expect(edits.reordered(start, 0, -1)).toBeUndefined();
		expect(made(edits.removed(start, 0)).areas?.map(({ kind }) => kind)).toEqual(["cone"]);
		expect(made(edits.removed(made(edits.removed(start, 0)), 0), made(edits.removed(start, 0))).areas).toBeUndefined();
	});

	it("moves an area by its middle", () => {
		const handle = handleOf(start, "area-1", 1);
		close(made(handle.pull([1, 2.5, -0.5])).areas?.[1].centre, [1, 2.5, -0.5]);
		close(made(handle.nudge(1, 0, true)).areas?.[1].centre, [0.6, 2, 0]);
		expect(made(handle.nudge(0, 1, false)).areas?.[0]).toEqual(start.areas?.[0]);
	});

	it("widens a rotated area by a side, keeping the opposite one", () => {
		const cone = start.areas?.[1] as Area;
		const handle = handleOf(start, "side-1", 1);
		const [along] = handle.along;
		const to = handle.at.map((value, k) => value + 0.4 * along[k]) as unknown as HandleVector;
		const wider = made(handle.pull(to)).areas?.[1] as Area;
		close(wider.size, [1, 2.4, 0.5]);
		close(placeIn(wider, [0, -1, 0]), placeIn(cone, [0, -1, 0]));
		close(placeIn(wider, [0, 1, 0]), to);
		const ball = made(edits.changed(start, 0, { kind: "sphere" }));
		close(made(handleOf(ball, "side-0", 0).nudge(1, 0, true), ball).areas?.[0].size, [1.1, 1.1, 1.1]);
	});

	it("turns an area about its own axes, as far as the pointer goes round", () => {
		for (const k of [0, 1, 2]) {
			const handle = handleOf(start, `turn-${k}`, 1);
			const cone = start.areas?.[1] as Area;
			const axis = rotate([k === 0 ? 1 : 0, k === 1 ? 1 : 0, k === 2 ? 1 : 0], cone.rotation);
			// The handle moves to its position after the rotation by 30° about the axis.
			const half = Math.sin(Math.PI / 12);
			const q = [axis[0] * half, axis[1] * half, axis[2] * half, Math.cos(Math.PI / 12)] as const;
			const out = handle.at.map((value, i) => value - cone.centre[i]) as unknown as Triple;
			const to = rotate(out, q).map((value, i) => value + cone.centre[i]) as unknown as HandleVector;
			const turned30 = made(handle.pull(to));
			close(handleOf(turned30, `turn-${k}`, 1).at, to);
			expect(turned30.areas?.[1].centre).toEqual(cone.centre);
		}
	});

	it("reads a turn as the degrees it was typed as", () => {
		for (const degrees of [
			[0, 0, 0],
			[10, 20, 30],
			[-80, 120, -45],
			[0, 0, 90],
		] as Triple[])
			close(degreesOf(rotationOf(degrees)), degrees);
	});

	it("leads the main branch by places, which it has from the areas at first", () => {
		expect(edits.placesOf(start)).toEqual([
			[0, 0.8, 0],
			[0.5, 2, 0],
		]);
		const led = made(handleOf(start, "place-0").pull([0.3, 0.7, 0]));
		expect(led.path).toEqual([0.3, 0.7, 0, 0.5, 2, 0]);
		const more = made(edits.addedPlace(led, 0), led);
		expect(more.path).toEqual([0.3, 0.7, 0, 0.4, 1.35, 0, 0.5, 2, 0]);
		expect(made(edits.removedPlace(more, 0), more).path).toEqual([0.4, 1.35, 0, 0.5, 2, 0]);
		expect(made(edits.withPath(undefined), more).path).toBeUndefined();
	});

	it("adds a branch from the nearest place, and keeps the order as places are added and removed", () => {
		const led = made(edits.withPath([0, 0.5, 0, 0, 1, 0, 0, 2, 0]));
		const forked = made(
			edits.strokeFork(led, [
				[0.05, 1.02, 0],
				[0.4, 1.5, 0],
				[0.8, 2, 0],
			]),
			led,
		);
		expect(forked.path).toEqual([0, 0.5, 0, 0, 1, 0, 0, 2, 0, 0.8, 2, 0]);
		expect(forked.from).toEqual([0, 1, 2, 2]);
		expect(edits.branchesOf(forked).map((line) => line.length)).toEqual([4, 2]);
		expect(edits.branchesOf(forked)[1]).toEqual([
			[0, 1, 0],
			[0.8, 2, 0],
		]);
		// A place after the fork continues the first branch.
		const more = made(edits.addedPlace(forked, 1), forked);
		expect(more.from).toEqual([0, 1, 2, 3, 2]);
		expect(more.path?.slice(6, 9)).toEqual([0, 1.5, 0]);
		const moved = made(edits.movedPlace(more, 4, [1, 2, 0]), more);
		expect(moved.from).toEqual(more.from);
		// Without the fork's place, both branches follow its predecessor.
		expect(made(edits.removedPlace(forked, 1), forked).from).toEqual([0, 1, 1]);
		expect(made(edits.removedPlace(forked, 3), forked).from).toBeUndefined();
		// Without the first, all follow the new first one.
		expect(
			made(edits.removedPlace(made(edits.withPath([0, 1, 0, 0, 2, 0, 1, 2, 0], [0, 1, 1])), 0)).from,
		).toBeUndefined();
		expect(made(edits.withPath(led.path, [0, 1, 2]), led).from).toBeUndefined();
	});

	it("makes a path of a stroke, of as few places as keep its shape", () => {
		const stroke = Array.from({ length: 60 }, (_, i): Triple => [Math.sin(i / 12), i / 30, 0]);
		const path = made(edits.strokePath(stroke)).path as number[];
		expect(path.length / 3).toBeGreaterThan(4);
		expect(path.length / 3).toBeLessThan(20);
		close(path.slice(0, 3), stroke[0]);
		close(path.slice(-3), stroke[59]);
		const straight = Array.from({ length: 30 }, (_, i): Triple => [i, 2 * i, 0]);
		expect((made(edits.strokePath(straight)).path as number[]).length).toBe(6);
		expect(edits.strokePath([[0, 0, 0]])).toBeUndefined();
	});
});

describe("the surface that is shown of an area", () => {
	it("fills its box from end to end, closed and facing outwards", () => {
		for (const kind of ["box", "sphere", "ellipsoid", "cylinder", "cone"] as const) {
			const { points, triangles } = surfaceOf(area(kind, [1, 2, 3], kind === "sphere" ? [2, 2, 2] : [2, 4, 6]));
			const half = kind === "sphere" ? [1, 1, 1] : [1, 2, 3];
			for (const k of [0, 1, 2]) {
				const along = points.filter((_, i) => i % 3 === k);
				expect(Math.min(...along)).toBeCloseTo(1 + k - half[k], 6);
				expect(Math.max(...along)).toBeCloseTo(1 + k + half[k], 6);
			}
			let volume = 0;
			for (let t = 0; t < triangles.length; t += 3) {
				const [a, b, c] = [0, 1, 2].map((i) => [0, 1, 2].map((k) => points[3 * triangles[t + i] + k] - [1, 2, 3][k]));
				volume +=
					(a[0] * (b[1] * c[2] - b[2] * c[1]) +
						a[1] * (b[2] * c[0] - b[0] * c[2]) +
						a[2] * (b[0] * c[1] - b[1] * c[0])) /
					6;
			}
			const whole = 8 * half[0] * half[1] * half[2];
			const share = { box: 1, sphere: 0.52, ellipsoid: 0.52, cylinder: 0.785, cone: 0.262 }[kind];
			expect(volume / whole).toBeGreaterThan(0.96 * share);
			expect(volume / whole).toBeLessThan(1.01 * share);
		}
	});
});

describe("the handles of an area", () => {
	/** The first view of the page: 24° to the right, 7° above; without perspective. */
	const seen = ([x, y, z]: HandleVector): readonly [number, number] => {
		const [a, e] = [24, 7].map((degrees) => (degrees * Math.PI) / 180);
		const across = x * Math.cos(a) - z * Math.sin(a);
		return [across, y * Math.cos(e) - (x * Math.sin(a) + z * Math.cos(a)) * Math.sin(e)];
	};
	const box: GrammarSpecimen = { ...start, areas: [area("box", [0, 1, 0], [2, 2, 2])] };

	it("do not overlap in the first view", () => {
		const places = areaHandles(box, { area: 0 }).handles.map(({ at }) => seen(at));
		expect(places).toHaveLength(7);
		for (const [i, [x, y]] of places.entries())
			for (const [otherX, otherY] of places.slice(i + 1))
				expect(Math.hypot(x - otherX, y - otherY)).toBeGreaterThan(0.4);
	});

	it("have an arc each where they turn, about the axis and through the handle", () => {
		const turned = { ...box, areas: [{ ...(box.areas?.[0] as Area), rotation: rotationOf([0, 30, 0]) }] };
		const { handles, lines } = areaHandles(turned, { area: 0 });
		expect(lines).toHaveLength(3);
		for (const [k, { at }] of handles.filter(({ kind }) => kind === "turn").entries()) {
			const arc = lines[k];
			expect(arc.some((place) => Math.hypot(...place.map((value, i) => value - at[i])) < 1e-9)).toBe(true);
			const wide = arc.map((place) => Math.hypot(...place.map((value, i) => value - [0, 1, 0][i])));
			expect(Math.max(...wide) - Math.min(...wide)).toBeLessThan(1e-9);
		}
	});

	it("remove it if allowed, and nothing on pages without undo", () => {
		const more: GrammarSpecimen = { ...box, areas: [...(box.areas ?? []), area("cone", [0, 3, 0])] };
		const { handles } = areaHandles(more, { area: 1, removable: true });
		for (const { id, remove } of handles) {
			const left = made(remove?.(), more).areas?.map(({ kind }) => kind);
			expect(left, id).toEqual(id === "area-0" ? ["cone"] : ["box"]);
		}
		expect(areaHandlesOf(more).handles.some(({ remove }) => remove)).toBe(false);
	});
});
