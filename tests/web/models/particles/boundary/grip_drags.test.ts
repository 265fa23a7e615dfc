import { describe, expect, it } from "vitest";
import { boundaryPose } from "../../../../../web/src/models/particles/boundary/editor/boundary_pose";
import { gripDrags } from "../../../../../web/src/models/particles/boundary/editor/grip_drags";
import { withWall } from "../../../../../web/src/models/particles/boundary/editor/walls";
import { treeLayout } from "../../../../../web/src/models/tree/layout";
import { TREE } from "../../../../../web/src/models/tree/schema";
import { apply } from "../../../../../web/src/ui/change";
import type { Change } from "../../../../../web/src/ui/editor_context";
import { gripOf, tree } from "./particles";

/** Drags over a specimen that other actions may change too. */
function handsOn(specimen: ReturnType<typeof tree>) {
	const page = { specimen, changes: 0 };
	const pose = () => boundaryPose(treeLayout, page.specimen, tree("oak"));
	const drags = gripDrags({
		pose,
		input: (change: Change) => {
			page.specimen = apply(TREE, page.specimen, change);
			page.changes++;
		},
		change: () => undefined,
		schedule: (callback) => callback(),
	});
	return { page, pose, drags };
}

describe("a drag of a grip", () => {
	it("restores on Escape only the fields that the grip has set", () => {
		const oak = tree("oak");
		const { page, pose, drags } = handsOn(oak);
		const { at } = gripOf(pose(), "knot6");
		drags.begin(1, "knot6", at);
		drags.move(1, { x: at.x, y: at.y + 2 });
		expect(page.specimen.parameters.height).toBeCloseTo(oak.parameters.height + 2);
		const others = { parameters: { age: 60, inner: 0.2 }, details: { targets: [1, 0, 0] } };
		page.specimen = apply(TREE, page.specimen, others);
		drags.cancel();
		expect(page.specimen).toEqual(apply(TREE, oak, others));
	});

	it("ends when another action removes the dragged grip", () => {
		const oak = tree("oak");
		const { page, pose, drags } = handsOn(apply(TREE, oak, withWall(oak, { x: 4, y: 5 }, 6)));
		const { at } = gripOf(pose(), "obstacles0 middle");
		drags.begin(1, "obstacles0 middle", at);
		drags.move(1, { x: at.x + 1, y: at.y });
		expect(page.changes).toBe(1);
		page.specimen = oak;
		drags.move(1, { x: at.x + 2, y: at.y });
		drags.drop();
		expect(page).toEqual({ specimen: oak, changes: 1 });
		expect(drags.active).toBe(false);
	});
});
