/** The grips of a boundary as handles on the plant, in the plane of the front view. */

import type { HandlesOf, HandleVector } from "../../../../ui/handles/plant_handle";
import { text } from "../../messages.generated";
import type { BoundedSpecimen } from "../bounded";
import { type BoundaryLayout, loopsIn } from "./boundary_layout";
import { boundaryPose } from "./boundary_pose";

const ALONG: readonly HandleVector[] = [
	[1, 0, 0],
	[0, 1, 0],
];

/** Returns a function that makes the handles of a specimen, and the lines of its boundary at each axis. */
export function boundaryHandles<S extends BoundedSpecimen>(layout: BoundaryLayout<S>): HandlesOf<S> {
	return (specimen, preset) => {
		const { halfWidth, low, high } = layout.box(specimen);
		const loops = loopsIn(layout, specimen).map((loop) => [...loop, loop[0]]);
		return {
			handles: boundaryPose(layout, specimen, preset).grips.map(({ id, at, label, part, value, pull, nudge }) => ({
				id,
				label: part ? text("part_of", { name: label, part }) : label,
				value,
				at: [at.x, at.y, 0],
				along: ALONG,
				pull: ([x, y]) => pull({ x, y }),
				nudge,
			})),
			lines: layout
				.axes(specimen)
				.flatMap((axis) =>
					loops.map((loop) => loop.map(({ x, y }): HandleVector => [axis + x * halfWidth, low + y * (high - low), 0])),
				),
		};
	};
}
