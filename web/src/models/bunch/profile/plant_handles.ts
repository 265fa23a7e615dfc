/** The octahedron's handles on the bunch itself. */

import type { Change } from "../../../ui/editor_context";
import type { HandlesOf, HandleVector, PlantHandle } from "../../../ui/handles/plant_handle";
import { text } from "../messages.generated";
import type { BunchSpecimen } from "../specimen";
import { dragHandle } from "./drag";
import { across, handleVector } from "./handle_ray";
import {
	HANDLES,
	type Handle,
	handleKeys,
	handlePosition,
	handleValue,
	isSide,
	metresPerPixel,
	SIDES,
} from "./handles";

type Parameters = BunchSpecimen["parameters"];

const VERTICAL: HandleVector = [0, 1, 0];
/** Pixels of the profile per press of an arrow key, and with Shift. */
const STEP = 1;
const LARGE_STEP = 10;

export const bunchHandles: HandlesOf<BunchSpecimen> = ({ parameters }) => {
	const place = (handle: Handle) => handleVector(parameters, handle, parameters.unit);
	const top: HandleVector = [0, 0, 0];
	const ring = (["p3", "p5", "p4", "p6"] as const).map(place);
	return {
		handles: HANDLES.map((handle) => handleOf(parameters, handle)),
		lines: [[...ring, ring[0]], ...ring.map((corner) => [top, corner, place("p2")])],
	};
};

/** Returns a handle of the bunch's profile at its place in space. */
function handleOf(parameters: Parameters, handle: Handle): PlantHandle {
	const axis = across(handle);
	const pixel = metresPerPixel(parameters.unit);
	const from = handlePosition(parameters, handle);
	const dragTo = (x: number, y: number) => changeOf(dragHandle(parameters, handle, { x, y }), handle);
	return {
		id: handle,
		label: isSide(handle) ? text(`side_${SIDES[handle].name}`) : text("length"),
		value: handleValue(parameters, handle),
		at: handleVector(parameters, handle, parameters.unit),
		along: isSide(handle) ? [axis, VERTICAL] : [VERTICAL],
		pull: ([x, y, z]) => dragTo((axis[0] * x + axis[2] * z) / pixel, -y / pixel),
		nudge: (right, up, large) => {
			const step = large ? LARGE_STEP : STEP;
			// NaN leaves its coordinate unchanged, including a fraction of a pixel.
			return dragTo(right ? from.x + right * step : Number.NaN, up ? from.y - up * step : Number.NaN);
		},
	};
}

/** Returns the change of the parameters that a handle sets. */
function changeOf(parameters: Parameters, handle: Handle): Change {
	return { parameters: Object.fromEntries(handleKeys(handle).map((key) => [key, parameters[key]])) };
}
