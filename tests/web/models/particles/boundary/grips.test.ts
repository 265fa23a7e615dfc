import { describe, expect, it } from "vitest";
import type { BoundedSpecimen } from "../../../../../web/src/models/particles/boundary/bounded";
import type { BoundaryLayout } from "../../../../../web/src/models/particles/boundary/editor/boundary_layout";
import { boundaryPose } from "../../../../../web/src/models/particles/boundary/editor/boundary_pose";
import { planPose } from "../../../../../web/src/models/particles/boundary/editor/plan_pose";
import { wallsOf, withRound, withWall } from "../../../../../web/src/models/particles/boundary/editor/walls";
import { rootLayout } from "../../../../../web/src/models/root/layout";
import { ROOT } from "../../../../../web/src/models/root/schema";
import { treeLayout } from "../../../../../web/src/models/tree/layout";
import { TREE } from "../../../../../web/src/models/tree/schema";
import { decodeQuery, encodeQuery } from "../../../../../web/src/specimen/link";
import type { ModelSchema } from "../../../../../web/src/specimen/model_schema";
import { apply } from "../../../../../web/src/ui/change";
import { gripOf, root, tree } from "./particles";

/** The specimens after each event of a drag. */
function held<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	schema: ModelSchema<S>,
	specimen: S,
	id: string,
	y: number,
	times = 6,
): S {
	let moved = specimen;
	for (let i = 0; i < times; i++) {
		const grip = gripOf(boundaryPose(layout, moved, moved), id);
		moved = apply(schema, moved, grip.pull({ x: grip.at.x, y }));
	}
	return moved;
}

const topOf = ({ parameters: { trunk, height } }: ReturnType<typeof tree>) => trunk + height;
const withNumbers = <S extends BoundedSpecimen>(specimen: S, parameters: object): S => ({
	...specimen,
	parameters: { ...specimen.parameters, ...parameters },
});

describe("an end of a boundary that is held where it cannot be", () => {
	it("leaves a tree's top where it was, however many events there are", () => {
		for (const [preset, id] of [
			["oak", "knot0"],
			["box", "low"],
		]) {
			const specimen = tree(preset);
			const below = held(treeLayout, TREE, specimen, id, -1);
			expect(below.parameters.trunk).toBe(0);
			expect(topOf(below)).toBeCloseTo(topOf(specimen));
			const above = held(treeLayout, TREE, specimen, id, 80);
			expect(topOf(above)).toBeCloseTo(topOf(specimen));
			expect(above.parameters.height).toBeCloseTo(0.1);
		}
		const tall = withNumbers(tree("box"), { trunk: 20, height: 40 });
		expect(held(treeLayout, TREE, tall, "low", 50).parameters).toMatchObject({ trunk: 30, height: 30 });
		const down = withNumbers(tree("box"), { trunk: 0 });
		const pressed = apply(TREE, down, gripOf(boundaryPose(treeLayout, down, down), "low").nudge(0, -1, true));
		expect(pressed.parameters).toEqual(down.parameters);
	});

	it("keeps a ball's size", () => {
		const ball = tree("sphere");
		expect(held(treeLayout, TREE, ball, "low", -3).parameters).toMatchObject({
			width: ball.parameters.width,
			trunk: 0,
		});
	});

	it("leaves a root's deepest where it was", () => {
		const deep = withNumbers(root("fibrous"), { reach: 12 });
		const { top, reach } = held(rootLayout, ROOT, deep, "high", -9).parameters;
		expect([top, top + reach]).toEqual([5, expect.closeTo(deep.parameters.top + 12)]);
		const flat = held(rootLayout, ROOT, root("fibrous"), "high", -40).parameters;
		expect(flat.top + flat.reach).toBeCloseTo(root("fibrous").parameters.top + root("fibrous").parameters.reach);
	});
});

describe("a profile whose ends are within the box", () => {
	it("is unchanged by a drag to the same position, and follows the pointer", () => {
		const { specimen } = decodeQuery(TREE, "?v=2&model=tree&profile=0.2,0.1,1,0.4,0.1,0.8");
		const grips = boundaryPose(treeLayout, specimen, specimen).grips.filter(({ id }) => id.startsWith("knot"));
		expect(grips).toHaveLength(3);
		for (const { id, at, pull } of grips) {
			const { parameters, profile } = apply(TREE, specimen, pull(at));
			expect(profile).toEqual(specimen.profile);
			expect(parameters).toEqual(specimen.parameters);
			const moved = apply(TREE, specimen, pull({ x: at.x, y: at.y + 0.3 }));
			expect(gripOf(boundaryPose(treeLayout, moved, moved), id).at.y).toBeCloseTo(at.y + 0.3, 1);
		}
	});
});

describe("a double click", () => {
	const reset = (specimen: ReturnType<typeof tree>, id: string) => {
		const preset = tree(specimen.preset);
		const pose = id === "front" ? planPose : boundaryPose;
		return apply(TREE, specimen, gripOf(pose(treeLayout, specimen, preset), id).reset?.() ?? {});
	};

	it("restores the preset's values independently of other values", () => {
		const twin = tree("twin");
		const other = withNumbers(twin, { crowns: 3, distance: 11, width: 3, depth: 2, inner: 0.3, height: 2, trunk: 5 });
		const { width, depth, inner, height, trunk, distance } = twin.parameters;
		const numbers = (id: string) => reset(other, id).parameters;
		expect(numbers("side")).toEqual({ ...other.parameters, width });
		expect(numbers("front")).toEqual({ ...other.parameters, depth });
		expect(numbers("inner")).toEqual({ ...other.parameters, inner });
		expect(numbers("axis")).toEqual({ ...other.parameters, distance });
		expect(numbers("high")).toEqual({ ...other.parameters, height });
		expect(numbers("low")).toEqual({ ...other.parameters, trunk, height: 7 - trunk });
	});

	it("brings a point of the profile back in shares, and with an end the box's end", () => {
		const oak = tree("oak");
		const profile = oak.profile?.map(([radius, height]) => [radius / 2, height] as const);
		const other = { ...withNumbers(oak, { width: 3, height: 20 }), profile };
		expect(reset(other, "knot2").profile?.[2]).toEqual(oak.profile?.[2]);
		expect(reset(other, "knot2").parameters).toEqual(other.parameters);
		const top = reset(other, "knot6");
		expect(top.profile?.[6]).toEqual(oak.profile?.[6]);
		expect(top.parameters).toEqual({ ...other.parameters, height: oak.parameters.height });
		const more = apply(TREE, other, gripOf(boundaryPose(treeLayout, other, oak), "knot1").add?.() ?? {});
		expect(reset(more, "knot3")).toEqual(more);
	});
});

describe("changes by dragging", () => {
	const linked = (specimen: ReturnType<typeof tree>) => decodeQuery(TREE, encodeQuery(TREE, specimen));
	const asLinked = (specimen: ReturnType<typeof tree>) =>
		expect(linked(specimen)).toEqual({ specimen: JSON.parse(JSON.stringify(specimen)), notes: [] });

	it("keeps targets within the limits of links", () => {
		const oak = tree("oak");
		const far = apply(TREE, oak, gripOf(boundaryPose(treeLayout, oak, oak), "target0").pull({ x: 250, y: 0 }));
		expect(far.targets).toEqual([100, 0, 0]);
		asLinked(far);
		const hedge = withNumbers(oak, { crowns: 4, stems: 15 });
		const count = (specimen: typeof oak) =>
			boundaryPose(treeLayout, specimen, oak).grips.filter(({ id }) => id.startsWith("target")).length;
		expect(count(hedge)).toBe(60);
		asLinked(apply(TREE, hedge, gripOf(boundaryPose(treeLayout, hedge, oak), "target7").pull({ x: 1, y: 0 })));
		expect(count(withNumbers(oak, { crowns: 4, stems: 30 }))).toBe(0);
	});

	it("keeps obstacles within the limits of links, with their sizes", () => {
		let crowded = tree("oak");
		for (let i = 0; i < 15; i++)
			crowded = apply(TREE, crowded, withRound(crowded, 3 + 11 * i, { low: 2, high: 9 }, 11));
		crowded = apply(TREE, crowded, withWall(crowded, { x: 300, y: 5 }, 6));
		expect(wallsOf(crowded, "rounds").at(-1)).toEqual([89, 2, -5.5, 100, 9, 5.5]);
		expect(wallsOf(crowded)).toEqual([[99.7, 0, -3, 100, 5, 3]]);
		asLinked(crowded);
		const pose = planPose(treeLayout, crowded, crowded);
		const moved = apply(TREE, crowded, gripOf(pose, "rounds0 middle").pull({ x: -400, y: 400 }));
		expect(wallsOf(moved, "rounds")[0]).toEqual([-100, 2, -100, -89, 9, -89]);
		asLinked(apply(TREE, moved, gripOf(pose, "rounds14 corner").pull({ x: 400, y: 0 })));
	});

	it("describes the keys of each grip", () => {
		const oak = apply(TREE, tree("oak"), withWall(tree("oak"), { x: 4, y: 5 }, 6));
		const { grips } = boundaryPose(treeLayout, oak, oak);
		const able = (which: "add" | "remove") => grips.filter((grip) => grip[which]).map(({ id }) => id);
		expect(able("add")).toEqual(["knot0", "knot1", "knot2", "knot3", "knot4", "knot5", "knot6"]);
		expect(able("remove")).toEqual([
			"knot1",
			"knot2",
			"knot3",
			"knot4",
			"knot5",
			"obstacles0 middle",
			"obstacles0 corner",
		]);
	});
});
