/** The outline that the views draw is the one that the core fills and measures. */

import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../../web/src/core/core";
import { measureOf } from "../../../../../web/src/models/bunch/measures";
import { endReach, filledWidth, sideEnvelope } from "../../../../../web/src/models/bunch/profile/envelope";
import { metresPerPixel, SIDE_HANDLES } from "../../../../../web/src/models/bunch/profile/handles";
import type { Point } from "../../../../../web/src/ui/handles/point";
import { type Specimen, specimenFromPreset } from "../../../bunch";
import { freshCore, growBunch } from "../../../core/wasm";

const SLICES = 400;

/** Half-width at a depth. */
function widthAt(points: Point[], y: number): number {
	const at = points.findIndex((point, i) => i > 0 && point.y >= y && point.y > points[i - 1].y);
	const [a, b] = [points[at - 1], points[at]];
	return a.x + ((b.x - a.x) * (y - a.y)) / (b.y - a.y);
}

/** Volume within the four sides, a quarter ellipse between two neighbours at every depth; cm³. */
function drawnVolume({ parameters }: Specimen): number {
	const sides = SIDE_HANDLES.map((handle, first) => {
		const w = filledWidth(parameters, handle);
		return sideEnvelope({ w, r: parameters[`${handle}r`], narrow: endReach(parameters, w), first }, parameters.l);
	});
	const thickness = parameters.l / SLICES;
	let volume = 0;
	for (let slice = 0; slice < SLICES; slice++) {
		const [right, left, front, back] = sides.map((side) => widthAt(side, (slice + 0.5) * thickness));
		volume += (Math.PI / 4) * (right + left) * (front + back) * thickness;
	}
	return volume * (100 * metresPerPixel(parameters.unit)) ** 3;
}

describe("the outline's volume", () => {
	let core: Core;
	beforeAll(async () => {
		core = await freshCore();
	});

	it.each(["short-conical", "cylindrical", "winged-cylindrical", "pinot-noir", "redcurrant", "lychee"])(
		"is what the core measures: %s",
		(preset) => {
			const specimen = specimenFromPreset(preset);
			const measured = measureOf(growBunch(core, specimen).measures, "outline_volume");
			expect(drawnVolume(specimen) / measured).toBeCloseTo(1, 2);
		},
	);
});
