import { describe, expect, it } from "vitest";
import {
	footprintIn,
	loopsIn,
	outlineIn,
} from "../../../../../web/src/models/particles/boundary/editor/boundary_layout";
import { boundaryPose } from "../../../../../web/src/models/particles/boundary/editor/boundary_pose";
import { heaviest, inkBranches } from "../../../../../web/src/models/particles/boundary/editor/branches";
import { FROM_ABOVE } from "../../../../../web/src/models/particles/boundary/editor/facing";
import {
	frameAbout,
	fromScreen,
	scaleBar,
	toScreen,
} from "../../../../../web/src/models/particles/boundary/editor/frame";
import { pressed } from "../../../../../web/src/models/particles/boundary/editor/grip";
import { asProfile } from "../../../../../web/src/models/particles/boundary/editor/knot_grips";
import { outlineOf, radiusAt, splineThrough } from "../../../../../web/src/models/particles/boundary/editor/outline";
import { sunAt, sunPlace, sunPose } from "../../../../../web/src/models/particles/boundary/editor/sun_pose";
import {
	countOfWalls,
	wallsOf,
	withRound,
	withWall,
} from "../../../../../web/src/models/particles/boundary/editor/walls";
import { rootLayout } from "../../../../../web/src/models/root/layout";
import { ROOT } from "../../../../../web/src/models/root/schema";
import { treeLayout } from "../../../../../web/src/models/tree/layout";
import { TREE } from "../../../../../web/src/models/tree/schema";
import { apply } from "../../../../../web/src/ui/change";
import { gripOf, root, tree } from "./particles";

const poseOf = (specimen = tree("oak")) => boundaryPose(treeLayout, specimen, tree(specimen.preset));

describe("the outline from in front", () => {
	it("is widest where its form is", () => {
		const at = (form: Parameters<typeof outlineOf>[0], height: number) => radiusAt(outlineOf(form, []), height);
		expect([at("ellipsoid", 0.5), at("box", 0.9), at("cone", 0), at("coneDown", 1), at("bowl", 1)]).toEqual([
			1, 1, 1, 1, 1,
		]);
		expect(at("ellipsoid", 0.9)).toBeCloseTo(0.6, 2);
		expect(at("bowl", 0.5)).toBeCloseTo(Math.sqrt(0.75), 2);
		expect(at("cone", 0.75)).toBeCloseTo(0.25);
	});

	it("runs through every point of a profile, without ever crossing the axis", () => {
		const knots = [[0.2, 0], [0, 0.3], [1, 0.4], [0, 1]] as const; // biome-ignore format: a table
		const line = splineThrough(knots);
		expect(line).toHaveLength(3 * 6 + 1);
		for (const knot of knots) expect(line).toContainEqual([...knot]);
		expect(Math.min(...line.map(([radius]) => radius))).toBe(0);
	});

	it("is a mesh's own", () => {
		// An inverted pyramid.
		const points = [0, 0, 0, -2, 1, -2, 2, 1, -2, 2, 1, 2, -2, 1, 2];
		const triangles = [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1, 1, 3, 2, 1, 4, 3];
		const outline = outlineOf("mesh", [], { points, triangles });
		for (const height of [0.2, 0.5, 1]) expect(radiusAt(outline, height)).toBeCloseTo(height, 1);
	});

	it("of a mesh is worked out once, however often it is drawn", () => {
		const volume = { points: [0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0], triangles: [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2] };
		const { options = [] } = TREE.table.entry("shape") as { options?: readonly string[] };
		const drawn = () => {
			const oak = { ...tree("oak"), volume };
			const specimen = { ...oak, parameters: { ...oak.parameters, shape: options.indexOf("mesh") } };
			return [outlineIn(treeLayout, specimen), loopsIn(treeLayout, specimen), footprintIn(treeLayout, specimen)];
		};
		const [first, second] = [drawn(), drawn()];
		for (const [i, lines] of first.entries()) expect(second[i]).toBe(lines);
		expect(first[1]).not.toEqual(first[2]);
	});
});

describe("grips of a boundary", () => {
	it("are at the points of the profile, in metres above the ground", () => {
		const { width, trunk, height } = tree("oak").parameters;
		const [radius, up] = (tree("oak").profile ?? [])[2];
		expect(gripOf(poseOf(), "knot2").at).toEqual({ x: (radius * width) / 2, y: trunk + up * height });
		expect(gripOf(poseOf(), "knot2").value).toMatch(/^[\d.]+ m out, [\d.]+ m up$/);
	});

	it("move the point, between its neighbours and never across the axis", () => {
		const specimen = tree("oak");
		const { width } = specimen.parameters;
		const moved = apply(TREE, specimen, gripOf(poseOf(), "knot2").pull({ x: 3, y: 100 }));
		expect(moved.profile?.[2]).toEqual([Math.round((300 * 2) / width) / 100, specimen.profile?.[3][1]]);
		expect(apply(TREE, specimen, gripOf(poseOf(), "knot2").pull({ x: -5, y: 4 })).profile?.[2][0]).toBe(0);
		expect(moved.parameters).toEqual(specimen.parameters);
	});

	it("carry the boundary's ends with the first and the last point", () => {
		const specimen = tree("oak");
		const { trunk, height } = specimen.parameters;
		const raised = apply(TREE, specimen, gripOf(poseOf(), "knot6").pull({ x: 0, y: trunk + height + 2 }));
		expect(raised.parameters).toMatchObject({ trunk, height: height + 2 });
		const lowered = apply(TREE, specimen, gripOf(poseOf(), "knot0").pull({ x: 1, y: trunk - 0.5 }));
		expect(lowered.parameters.trunk).toBeCloseTo(trunk - 0.5);
		expect(lowered.parameters.trunk + lowered.parameters.height).toBeCloseTo(trunk + height);
	});

	it("resize shapes without a profile, and keep round shapes round", () => {
		const box = tree("box");
		const pose = poseOf(box);
		expect(apply(TREE, box, gripOf(pose, "side").pull({ x: 2.5, y: 0 })).parameters).toMatchObject({
			width: 5,
			depth: 5,
		});
		expect(apply(TREE, box, gripOf(pose, "high").pull({ x: 0, y: 6 })).parameters.height).toBeCloseTo(
			6 - box.parameters.trunk,
		);
		const flat = { ...box, parameters: { ...box.parameters, depth: 1 } };
		expect(apply(TREE, flat, gripOf(poseOf(flat), "side").pull({ x: 2.5, y: 0 })).parameters.depth).toBe(1);
		const ball = tree("sphere");
		const { trunk } = ball.parameters;
		expect(apply(TREE, ball, gripOf(poseOf(ball), "high").pull({ x: 0, y: trunk + 5 })).parameters).toMatchObject({
			width: 5,
			trunk,
		});
		expect(apply(TREE, ball, gripOf(poseOf(ball), "side").pull({ x: 3, y: 3 })).parameters).toMatchObject({
			width: 6,
			trunk,
		});
		expect(apply(TREE, ball, gripOf(poseOf(ball), "low").pull({ x: 0, y: 2 })).parameters).toMatchObject({
			width: 4,
			trunk: 2,
		});
	});

	it("set the inner boundary and the distance of twins", () => {
		const twin = tree("twin");
		const pose = poseOf(twin);
		const inner = gripOf(pose, "inner");
		expect(apply(TREE, twin, gripOf(pose, "inner").pull(inner.at)).parameters.inner).toBeCloseTo(twin.parameters.inner);
		expect(gripOf(pose, "axis").at.x).toBeCloseTo(twin.parameters.distance / 2);
		expect(apply(TREE, twin, gripOf(pose, "axis").pull({ x: 4, y: 1 })).parameters.distance).toBe(8);
		expect(poseOf().grips.map(({ id }) => id)).not.toContain("axis");
	});

	it("lie below ground for a root", () => {
		const fibrous = root("fibrous");
		const pose = boundaryPose(rootLayout, fibrous, fibrous);
		const low = pose.grips.find(({ id }) => id === "low");
		expect(low?.at.y).toBeCloseTo(-fibrous.parameters.reach);
		expect(low?.value).toMatch(/below ground$/);
		expect(apply(ROOT, fibrous, gripOf(pose, "low").pull({ x: 0, y: -3 })).parameters.reach).toBeCloseTo(3);
		expect(apply(ROOT, fibrous, gripOf(pose, "high").pull({ x: 0, y: -0.1 })).parameters).toMatchObject({
			top: 0.1,
			reach: fibrous.parameters.reach - 0.1,
		});
	});

	it("obey arrow keys, Delete, Insert and a double click", () => {
		const specimen = tree("oak");
		const pose = poseOf();
		const by = (key: string, shiftKey = false) => pressed(gripOf(pose, "knot2"), { key, shiftKey })?.change;
		const out = (change: ReturnType<typeof by>) => change && apply(TREE, specimen, change).profile?.[2][0];
		const start = specimen.profile?.[2][0] ?? 0;
		expect(out(by("ArrowLeft"))).toBeLessThan(start);
		expect(out(by("ArrowLeft", true))).toBeLessThan(out(by("ArrowLeft")) ?? 0);
		expect(by("a")).toBeUndefined();
		expect(by("Delete")?.details?.profile).toHaveLength(6);
		expect(pressed(gripOf(pose, "knot0"), { key: "Delete", shiftKey: false })).toBeUndefined();
		expect(pressed(gripOf(pose, "knot2"), { key: "Delete", shiftKey: false })?.message).toBe("Point 3 deleted");
		expect(by("Insert")?.details?.profile).toHaveLength(8);
		const bent = apply(TREE, specimen, gripOf(pose, "knot2").pull({ x: 1, y: 4 }));
		expect(apply(TREE, bent, gripOf(poseOf(bent), "knot2").reset?.() ?? {}).profile).toEqual(specimen.profile);
	});

	it("come back as they were where a drag is called off", () => {
		const specimen = tree("oak");
		const pose = poseOf();
		const moved = apply(TREE, specimen, gripOf(pose, "knot6").pull({ x: 2, y: 30 }));
		expect(moved).not.toEqual(specimen);
		expect(apply(TREE, moved, pose.change)).toEqual({ ...specimen, obstacles: undefined, targets: undefined });
	});

	it("take over a form as a profile to be shaped by hand", () => {
		const box = tree("box");
		expect(asProfile(treeLayout, box).map(([radius]) => radius)).toEqual([1, 1, 1, 1, 1, 1]);
		const heights = asProfile(treeLayout, box).map(([, height]) => height);
		expect(heights).toEqual([...heights].sort((a, b) => a - b));
		expect([heights[0], heights[5]]).toEqual([0, 1]);
	});
});

describe("obstacles", () => {
	it("are added, moved, sized and taken away", () => {
		const oak = tree("oak");
		const one = apply(TREE, oak, withWall(oak, { x: 4, y: 5 }, 6));
		expect(wallsOf(one)).toEqual([[4, 0, -3, 4.3, 5, 3]]);
		const pose = poseOf(one);
		const moved = apply(TREE, one, gripOf(pose, "obstacles0 middle").pull({ x: 5.15, y: 3.5 }));
		expect(wallsOf(moved)).toEqual([[5, 1, -3, 5.3, 6, 3]]);
		expect(wallsOf(apply(TREE, one, gripOf(pose, "obstacles0 corner").pull({ x: 0, y: 9 })))).toEqual([
			[4, 0, -3, 4.02, 9, 3],
		]);
		expect(apply(TREE, one, gripOf(pose, "obstacles0 corner").remove?.() ?? {}).obstacles).toBeUndefined();
		const both = apply(TREE, one, withRound(one, 3, { low: 2, high: 8 }, 6));
		expect([wallsOf(both), wallsOf(both, "rounds")]).toEqual([[[4, 0, -3, 4.3, 5, 3]], [[3, 2, -3, 9, 8, 3]]]);
		expect(countOfWalls(both)).toBe(2);
		const round = poseOf(both);
		expect(gripOf(round, "rounds0 corner")).toMatchObject({ label: "Round obstacle 1", part: "size" });
		expect(apply(TREE, both, gripOf(round, "rounds0 middle").pull({ x: 7, y: 5 })).rounds).toEqual([
			4, 2, -3, 10, 8, 3,
		]);
		// Removes the chosen obstacle, of either kind.
		expect(apply(TREE, both, gripOf(round, "obstacles0 middle").remove?.() ?? {})).toEqual({
			...both,
			obstacles: undefined,
		});
	});
});

describe("the sun", () => {
	it("converts the sun's direction to a point on the sky and back", () => {
		expect(sunPlace(0, 0)).toEqual({ x: 0, y: -1 });
		expect(sunPlace(90, 45).x).toBeCloseTo(0.5);
		for (const [sun, sun_height] of [
			[40, 45],
			[200, 10],
			[355, 80],
		]) {
			expect(sunAt(sunPlace(sun, sun_height))).toEqual({ sun, sun_height });
		}
		expect(sunAt({ x: 3, y: 0 })).toEqual({ sun: 90, sun_height: 0 });
	});

	it("goes round with the arrow keys", () => {
		const oak = tree("oak");
		const specimen = { ...oak, parameters: { ...oak.parameters, sun: 358, sun_height: 88 } };
		const pose = sunPose(specimen, oak);
		expect(gripOf(pose, "sun").nudge(1, 0, false)).toEqual({ parameters: { sun: 3, sun_height: 88 } });
		expect(gripOf(pose, "sun").nudge(0, 1, true)).toEqual({ parameters: { sun: 358, sun_height: 90 } });
		expect(pose.grips[0].value).toBe("88° high, in front");
	});
});

describe("a flat view's frame", () => {
	it("contains the region to show, and inverts its mapping", () => {
		const frame = frameAbout({ halfWidth: 6, low: -0.5, high: 10 }, 223, 200);
		const corner = toScreen(frame, { x: 6, y: 10 });
		expect(corner.x).toBeLessThan(223);
		expect(corner.y).toBeGreaterThan(0);
		const back = fromScreen(frame, corner);
		expect([back.x, back.y]).toEqual([expect.closeTo(6), expect.closeTo(10)]);
		// A slightly larger region has the same scale.
		expect(frameAbout({ halfWidth: 6, low: -0.5, high: 10.1 }, 223, 200).scale).toBe(frame.scale);
		expect(scaleBar(frame)).toEqual({ length: 2, label: "2 m" });
		expect(scaleBar({ width: 223, scale: 500 }).label).toBe("10 cm");
	});
});

describe("branches behind a view", () => {
	it("are those with the most energy, at most as many as requested", () => {
		const energy = Float32Array.from({ length: 40_000 }, (_, i) => 1 + (i % 500 === 0 ? 4000 : i % 7));
		const drawn = heaviest(energy, 1000);
		expect(drawn.length).toBeLessThanOrEqual(1000);
		expect(drawn.length).toBeGreaterThan(500);
		for (let i = 0; i < energy.length; i += 500) expect(drawn).toContain(i);
		expect(heaviest(Float32Array.of(1, 2, 3), 1000)).toEqual([0, 1, 2]);
	});

	it("are inked where they are, as thick as they are", () => {
		const pen = { lines: [] as number[][], widths: [] as number[], lineCap: "", strokeStyle: "" };
		const canvas = Object.assign(pen, {
			set lineWidth(value: number) {
				pen.widths.push(value);
			},
			setTransform: (...values: number[]) => pen.lines.push(values),
			beginPath: () => undefined,
			moveTo: (x: number, y: number) => pen.lines.push([x, y]),
			lineTo: (x: number, y: number) => pen.lines.push([x, y]),
			stroke: () => undefined,
		});
		const segments = { ends: Float32Array.of(0, 0, 9, 0, 2, 9), radii: Float32Array.of(0.25, 0.25) };
		const frame = { width: 100, height: 100, scale: 10, origin: { x: 50, y: 90 } };
		inkBranches(canvas as never, { segments, energy: Float32Array.of(8) } as never, { frame, ratio: 2, ink: "red" });
		expect(pen.lines).toEqual([
			[20, 0, 0, -20, 100, 180],
			[0, 0],
			[0, 2],
		]);
		pen.lines.splice(0);
		const scene = { frame, ratio: 1, ink: "red" };
		inkBranches(canvas as never, { segments, energy: Float32Array.of(8) } as never, scene, FROM_ABOVE);
		// The front is at the bottom.
		expect(pen.lines).toEqual([
			[10, 0, 0, 10, 50, 90],
			[0, 9],
			[0, 9],
		]);
	});
});
