/**
 * Handles of areas and path in the 3-D view: each area's centre, the chosen area's sides and rotations, each place of
 * a drawn path.
 */

import { formatNumber } from "../../../locale/format";
import type { Change } from "../../../ui/editor_context";
import type { HandleVector, PlantHandle, PlantHandles } from "../../../ui/handles/plant_handle";
import { text } from "../messages.generated";
import {
	type Area,
	degreesOf,
	placeIn,
	rotate,
	rotateFurther,
	SMALLEST,
	type Triple,
	UNTURNED,
	type WithAreas,
} from "./area";
import { branchesOf, changed, movedPlace, placesOf, removed, removedPlace } from "./area_edits";

const AXES: readonly HandleVector[] = [
	[1, 0, 0],
	[0, 1, 0],
	[0, 0, 1],
];
const NAMES = ["x", "y", "z"];
const SIDES = ["handle_width", "handle_height", "handle_depth"] as const;
/** Metres that an arrow key moves, alone and with Shift. */
const STEP = 0.01;
const STRIDE = 0.1;
/** Degrees. */
const TURN = 5;
const TURN_FAR = 15;
/**
 * Positions of the rotation handles, in half areas: across their axis, and apart from other handles in the first view.
 */
const ARMS: readonly Triple[] = [
	[0, -1, -1],
	[-1, 0, 1],
	[-1.35, 1, 0],
];
/** Angle to both sides of a rotation handle that its arc spans, degrees, and the arc's number of segments. */
const ARC = 36;
const PIECES = 12;

export interface Choice {
	/** Area whose sides and rotations are shown. */
	readonly area?: number | undefined;
	/** Whether the main branch's places are shown. */
	readonly path?: boolean;
	/** Whether Delete removes them: only on pages with undo. */
	readonly removable?: boolean;
}

/** Returns the handles of areas, or of the path's places while that is edited. */
export function areaHandles(specimen: WithAreas, choice: Choice = {}): PlantHandles {
	const { areas = [] } = specimen;
	const chosen = choice.area === undefined ? undefined : areas[choice.area];
	const index = choice.area ?? 0;
	const places = choice.path ? placesOf(specimen) : [];
	const arms = chosen ? rotationHandles(specimen, chosen, index) : [];
	const gone = (change: () => Change) => (choice.removable ? { remove: change } : {});
	return {
		handles: [
			// Places may coincide with centres: only one kind is shown.
			...(choice.path ? [] : areas).map((area, i) => ({
				...centreHandle(specimen, area, i, i === choice.area),
				...gone(() => removed(specimen, i)),
			})),
			...[...(chosen ? sideHandles(specimen, chosen, index) : []), ...arms.map(({ handle }) => handle)].map(
				(handle) => ({
					...handle,
					...gone(() => removed(specimen, index)),
				}),
			),
			...places.map((at, i) => ({
				...placeHandle(specimen, at, i),
				...(places.length > 1 ? gone(() => removedPlace(specimen, i)) : {}),
			})),
		],
		lines: [...(choice.path ? branchesOf(specimen) : []), ...arms.map(({ arc }) => arc)],
	};
}

/** Returns the handles on pages that show only the plant. */
export const areaHandlesOf = (specimen: WithAreas): PlantHandles => areaHandles(specimen);

/** Returns the name of an area: "Area 2, a cone". */
export const nameOf = ({ kind }: Area, index: number): string => text("area", { number: index + 1, kind });

/** Formats a number with two decimals. */
const formatHundredths = (value: number): string =>
	formatNumber(value, { minimumFractionDigits: 2, maximumFractionDigits: 2 });
/** Formats a length in metres: "1.25 m". */
const formatMetres = (value: number): string => `${formatHundredths(value)} m`;
/** Describes a position: "x 0.10, y 1.25, z 0.00". */
const placeInWords = (at: Triple): string => at.map((value, k) => `${NAMES[k]} ${formatHundredths(value)}`).join(", ");
/** Returns the sum of two vectors. */
const sum = (at: Triple, by: Triple): Triple => [at[0] + by[0], at[1] + by[1], at[2] + by[2]];
/** Multiplies a vector by a factor. */
const scaled = (vector: Triple, factor: number): Triple => [vector[0] * factor, vector[1] * factor, vector[2] * factor];

/** Returns the handle at an area's centre, which moves the area. */
function centreHandle(specimen: WithAreas, area: Area, index: number, chosen: boolean): PlantHandle {
	const put = (centre: Triple): Change => changed(specimen, index, { centre });
	return {
		id: `area-${index}`,
		label: nameOf(area, index),
		value: placeInWords(area.centre),
		...(chosen ? { kind: "chosen" as const } : {}),
		at: area.centre,
		along: AXES,
		pull: ([x, y, z]) => put([x, y, z]),
		nudge: (right, up, large) => put(sum(area.centre, scaled([right, up, 0], large ? STRIDE : STEP))),
	};
}

/** Returns the handles in the middle of an area's sides; dragging one leaves the opposite side in place. */
function sideHandles(specimen: WithAreas, area: Area, index: number): PlantHandle[] {
	return AXES.map((ownAxis, k) => {
		const axis = rotate(ownAxis, area.rotation);
		const resized = (wanted: number): Change => {
			const width = Math.max(SMALLEST, wanted);
			const size = area.size.map((value, i) =>
				i === k || area.kind === "sphere" ? width : value,
			) as unknown as Triple;
			return changed(specimen, index, { size, centre: sum(area.centre, scaled(axis, (width - area.size[k]) / 2)) });
		};
		const face = placeIn(area, ownAxis);
		const oppositeFace = placeIn(area, scaled(ownAxis, -1));
		return {
			id: `side-${k}`,
			label: text(SIDES[k], { number: index + 1 }),
			value: formatMetres(area.size[k]),
			kind: "size",
			at: face,
			along: [axis],
			pull: (to) => resized([0, 1, 2].reduce((width, i) => width + (to[i] - oppositeFace[i]) * axis[i], 0)),
			nudge: (right, up, large) => resized(area.size[k] + (right || up) * (large ? STRIDE : STEP)),
		};
	});
}

/**
 * Returns the rotation handles about the area's own axes. Each handle is at the end of an arm from the area's centre
 * and moves on a circle about its axis; an arc shows its direction.
 */
function rotationHandles(
	specimen: WithAreas,
	area: Area,
	index: number,
): { handle: PlantHandle; arc: readonly HandleVector[] }[] {
	return AXES.map((ownAxis, k) => {
		const axis = rotate(ownAxis, area.rotation);
		const at = placeIn(area, ARMS[k]);
		const rotatedBy = (degrees: number): Change =>
			changed(specimen, index, { rotation: rotateFurther(area.rotation, axis, degrees) });
		const arm = difference(at, area.centre);
		// Unit vectors in the plane of the circle: its tangent at the handle, and the direction of the arm.
		const tangent = cross(axis, arm);
		const [alongCircle, alongArm] = [unitVector(tangent), unitVector(cross(tangent, axis))];
		const arc = Array.from({ length: PIECES + 1 }, (_, i): HandleVector => {
			const rotation = rotateFurther(UNTURNED, axis, ARC * ((2 * i) / PIECES - 1));
			return sum(area.centre, rotate(arm, rotation));
		});
		const handle: PlantHandle = {
			id: `turn-${k}`,
			label: text("handle_rotation", { number: index + 1, axis: NAMES[k] }),
			value: `${degreesOf(area.rotation)[k].toFixed(0)}°`,
			kind: "turn",
			at,
			along: [alongCircle, alongArm],
			pull: (to) => {
				const newArm = difference(to, area.centre);
				return rotatedBy((Math.atan2(dot(newArm, alongCircle), dot(newArm, alongArm)) * 180) / Math.PI);
			},
			nudge: (right, up, large) => rotatedBy((right || up) * (large ? TURN_FAR : TURN)),
		};
		return { handle, arc };
	});
}

/** Returns the handle of a place of the drawn path, which moves it. */
function placeHandle(specimen: WithAreas, at: Triple, index: number): PlantHandle {
	return {
		id: `place-${index}`,
		label: text("handle_point", { number: index + 1 }),
		value: placeInWords(at),
		at,
		along: AXES,
		pull: ([x, y, z]) => movedPlace(specimen, index, [x, y, z]),
		nudge: (right, up, large) => movedPlace(specimen, index, sum(at, scaled([right, up, 0], large ? STRIDE : STEP))),
	};
}

/** Returns the dot product of two vectors. */
const dot = (a: Triple, b: Triple): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** Returns the vector from b to a. */
const difference = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** Returns the cross product of two vectors. */
const cross = (a: Triple, b: Triple): Triple => [
	a[1] * b[2] - a[2] * b[1],
	a[2] * b[0] - a[0] * b[2],
	a[0] * b[1] - a[1] * b[0],
];
/** Scales a vector to length 1; a zero vector remains. */
function unitVector(a: Triple): Triple {
	const length = Math.hypot(...a) || 1;
	return scaled(a, 1 / length);
}
