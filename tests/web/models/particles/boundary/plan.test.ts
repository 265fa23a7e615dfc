import { describe, expect, it } from "vitest";
import { footprintIn } from "../../../../../web/src/models/particles/boundary/editor/boundary_layout";
import { boundaryPose } from "../../../../../web/src/models/particles/boundary/editor/boundary_pose";
import { planPose } from "../../../../../web/src/models/particles/boundary/editor/plan_pose";
import { wallsOf, withWall } from "../../../../../web/src/models/particles/boundary/editor/walls";
import { rootLayout } from "../../../../../web/src/models/root/layout";
import { ROOT } from "../../../../../web/src/models/root/schema";
import { treeLayout } from "../../../../../web/src/models/tree/layout";
import { TREE } from "../../../../../web/src/models/tree/schema";
import { decodeQuery, encodeQuery } from "../../../../../web/src/specimen/link";
import { apply } from "../../../../../web/src/ui/change";
import { gripOf, growBounded, particlesCore, root, tree } from "./particles";

const poseOf = (specimen = tree("oak")) => boundaryPose(treeLayout, specimen, tree(specimen.preset));

describe("a plan", () => {
	const planOf = (specimen = tree("oak")) => planPose(treeLayout, specimen, tree(specimen.preset));

	it("shows the front at the bottom, and moves and resizes obstacles in depth", () => {
		const oak = tree("oak");
		const one = apply(TREE, oak, withWall(oak, { x: 4, y: 5 }, 6));
		expect(gripOf(planOf(one), "obstacles0 middle").at).toEqual({ x: 4.15, y: 0 });
		expect(gripOf(planOf(one), "obstacles0 corner").at).toEqual({ x: 4.3, y: -3 });
		const back = apply(TREE, one, gripOf(planOf(one), "obstacles0 middle").pull({ x: 4.15, y: 2 }));
		expect(wallsOf(back)).toEqual([[4, 0, -5, 4.3, 5, 1]]);
		expect(gripOf(planOf(back), "obstacles0 middle").value).toBe("4.2 m right, 2 m behind");
		const thin = apply(TREE, one, gripOf(planOf(one), "obstacles0 corner").pull({ x: 5, y: 2.5 }));
		expect(wallsOf(thin)).toEqual([[4, 0, -3, 5, 5, -2.5]]);
		const least = apply(TREE, one, gripOf(planOf(one), "obstacles0 corner").pull({ x: 5, y: 9 }));
		expect(wallsOf(least)).toEqual([[4, 0, -3, 5, 5, -2.98]]);
	});

	it("takes the boundary's depth apart from its width, but a ball's", () => {
		const oak = tree("oak");
		const { width } = oak.parameters;
		const deep = apply(TREE, oak, gripOf(planOf(), "front").pull({ x: 0, y: -3 }));
		expect(deep.parameters).toMatchObject({ depth: 6, width });
		expect(gripOf(planOf(deep), "front").reset?.()).toEqual({ parameters: { depth: oak.parameters.depth } });
		const ball = tree("sphere");
		expect(apply(TREE, ball, gripOf(planOf(ball), "front").pull({ x: 0, y: -3 })).parameters).toMatchObject({
			width: 6,
			depth: 6,
		});
		const heart = root("heart");
		expect(gripOf(planPose(rootLayout, heart, heart), "front").pull({ x: 0, y: -1 })).toEqual({
			parameters: { depth: 2 },
		});
	});

	it("has a footprint", () => {
		expect(footprintIn(treeLayout, tree("box"))[0]).toHaveLength(4);
		const [round] = footprintIn(treeLayout, tree("sphere"));
		expect(round.length).toBeGreaterThan(20);
		for (const { x, y } of round) expect(Math.hypot(x, y)).toBeCloseTo(1);
	});
});

describe("targets", () => {
	it("has its targets where the core places them by default", async () => {
		const core = await particlesCore();
		const small = (model: string, preset: string, more: object) => {
			const specimen = model === "tree" ? tree(preset) : root(preset);
			return { ...specimen, parameters: { ...specimen.parameters, particles: 50, ...more } };
		};
		for (const [layout, schema, specimen] of [
			[treeLayout, TREE, small("tree", "twin", { stems: 3 })],
			[rootLayout, ROOT, small("root", "tap", { stems: 4 })],
		] as const) {
			const { targets } = growBounded(core, schema.table, specimen, { meshes: false });
			const placed = (layout as typeof treeLayout).targets(specimen as never);
			expect(placed).toHaveLength(targets.length);
			for (const [i, value] of targets.entries()) expect(placed[i]).toBeCloseTo(value, 4);
		}
	});

	it("are dragged in front and from above, and stay on the ground unless they are lifted", () => {
		const twin = tree("twin");
		const half = twin.parameters.distance / 2;
		const front = apply(TREE, twin, gripOf(poseOf(twin), "target1").pull({ x: 3.014, y: 0.1 }));
		expect(front.targets).toEqual([-half, 0, 0, 3.01, 0, 0]);
		expect(apply(TREE, twin, gripOf(poseOf(twin), "target1").pull({ x: 3, y: 1 })).targets?.[4]).toBe(1);
		const plan = planPose(treeLayout, front, twin);
		const back = apply(TREE, front, gripOf(plan, "target0").pull({ x: -1, y: 0.5 }));
		expect(back.targets).toEqual([-1, 0, -0.5, 3.01, 0, 0]);
		expect(gripOf(poseOf(back), "target0")).toMatchObject({ at: { x: -1, y: 0 }, label: "Trunk 1", value: "1 m left" });
		expect(planPose(treeLayout, back, twin).grips.find(({ id }) => id === "target0")?.value).toBe(
			"1 m left, 50 cm behind",
		);
	});

	it("are stepped, taken out, and brought back", () => {
		const twin = tree("twin");
		const pose = poseOf(twin);
		const up = apply(TREE, twin, gripOf(pose, "target0").nudge(0, 1, false) ?? {});
		expect(up.targets?.[1]).toBeGreaterThan(0);
		const one = apply(TREE, twin, gripOf(pose, "target0").remove?.() ?? {});
		expect(one.targets).toHaveLength(3);
		expect(gripOf(poseOf(one), "target0").remove?.()).toBeUndefined();
		const there = apply(TREE, twin, gripOf(pose, "target0").pull({ x: 0, y: 0 }));
		expect(apply(TREE, there, gripOf(poseOf(there), "target0").reset?.() ?? {}).targets).toBeUndefined();
	});

	it("do not lie under the grip of the crowns' distance", () => {
		const pose = poseOf(tree("twin"));
		const away = gripOf(pose, "axis").at.y - gripOf(pose, "target1").at.y;
		expect(away).toBeGreaterThan(1);
	});

	it("go into a short link, with obstacles placed by hand as well", () => {
		const oak = tree("oak");
		let edited = apply(TREE, oak, gripOf(poseOf(oak), "target0").pull({ x: 1.23, y: 0 }));
		edited = apply(TREE, edited, gripOf(poseOf(edited), "knot2").pull({ x: 3.3, y: 4.4 }));
		edited = apply(TREE, edited, withWall(edited, { x: 4, y: 5 }, 6));
		edited = apply(
			TREE,
			edited,
			gripOf(planPose(treeLayout, edited, oak), "obstacles0 middle").pull({ x: 4.5, y: 1.27 }),
		);
		const query = encodeQuery(TREE, edited);
		expect(query).toMatch(/targets=1\.23,0,0&obstacles=4\.35,0,-4\.27,4\.65,5,1\.73/);
		expect(`https://example.org/${query}`.length).toBeLessThan(300);
		expect(decodeQuery(TREE, query).specimen).toEqual(edited);
	});
});
