/**
 * Handles of areas and path in the 3-D view: each area's centre, the chosen area's sides and rotations, each place of
 * a drawn path.
 */
import type { Change } from "../../../ui/editor_context";
import type { HandleVector, PlantHandle, PlantHandles } from "../../../ui/handles/plant_handle";
import {
	type Area,
	degreesOf,
	placeIn,
	SMALLEST,
	type Triple,
	turned,
	turnedOn,
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
const SIDES = ["Width", "Height", "Depth"];
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

export function areaHandles(specimen: WithAreas, choice: Choice = {}): PlantHandles {
	const { areas = [] } = specimen;
	const chosen = choice.area === undefined ? undefined : areas[choice.area];
	const index = choice.area ?? 0;
	const places = choice.path ? placesOf(specimen) : [];
	const arms = chosen ? turns(specimen, chosen, index) : [];
	const gone = (change: () => Change) => (choice.removable ? { remove: change } : {});
	return {
		handles: [
			// Places may coincide with centres: only one kind is shown.
			...(choice.path ? [] : areas).map((area, i) => ({
				...middle(specimen, area, i, i === choice.area),
				...gone(() => removed(specimen, i)),
			})),
			...[...(chosen ? sides(specimen, chosen, index) : []), ...arms.map(({ handle }) => handle)].map((handle) => ({
				...handle,
				...gone(() => removed(specimen, index)),
			})),
			...places.map((at, i) => ({
				...place(specimen, at, i),
				...(places.length > 1 ? gone(() => removedPlace(specimen, i)) : {}),
			})),
		],
		lines: [...(choice.path ? branchesOf(specimen) : []), ...arms.map(({ arc }) => arc)],
	};
}

/** Handles on pages that show only the plant. */
export const areaHandlesOf = (specimen: WithAreas): PlantHandles => areaHandles(specimen);

/** Returns the name of an area: "Area 2, a cone". */
export const nameOf = ({ kind }: Area, index: number): string =>
	`Area ${index + 1}, ${/^[aeiou]/.test(kind) ? "an" : "a"} ${kind}`;

const metres = (value: number): string => `${value.toFixed(2)} m`;
const placeInWords = (at: Triple): string => at.map((value, k) => `${NAMES[k]} ${value.toFixed(2)}`).join(", ");
const moved = (at: Triple, by: Triple): Triple => [at[0] + by[0], at[1] + by[1], at[2] + by[2]];
const times = (way: Triple, by: number): Triple => [way[0] * by, way[1] * by, way[2] * by];

function middle(specimen: WithAreas, area: Area, index: number, chosen: boolean): PlantHandle {
	const put = (centre: Triple): Change => changed(specimen, index, { centre });
	return {
		id: `area-${index}`,
		label: nameOf(area, index),
		value: placeInWords(area.centre),
		...(chosen ? { kind: "chosen" as const } : {}),
		at: area.centre,
		along: AXES,
		pull: ([x, y, z]) => put([x, y, z]),
		nudge: (right, up, large) => put(moved(area.centre, times([right, up, 0], large ? STRIDE : STEP))),
	};
}

/** Returns the handles in the middle of sides; dragging one keeps the opposite side in place. */
function sides(specimen: WithAreas, area: Area, index: number): PlantHandle[] {
	return AXES.map((own, k) => {
		const axis = turned(own, area.rotation);
		const resized = (wanted: number): Change => {
			const width = Math.max(SMALLEST, wanted);
			const size = area.size.map((value, i) =>
				i === k || area.kind === "sphere" ? width : value,
			) as unknown as Triple;
			return changed(specimen, index, { size, centre: moved(area.centre, times(axis, (width - area.size[k]) / 2)) });
		};
		const face = placeIn(area, own);
		const foot = placeIn(area, times(own, -1));
		return {
			id: `side-${k}`,
			label: `${SIDES[k]} of area ${index + 1}`,
			value: metres(area.size[k]),
			kind: "size",
			at: face,
			along: [axis],
			pull: (to) => resized([0, 1, 2].reduce((sum, i) => sum + (to[i] - foot[i]) * axis[i], 0)),
			nudge: (right, up, large) => resized(area.size[k] + (right || up) * (large ? STRIDE : STEP)),
		};
	});
}

/**
 * Returns the rotation handles about the area's own axes, each on an arm across its axis, with an arc that shows its
 * direction.
 */
function turns(
	specimen: WithAreas,
	area: Area,
	index: number,
): { handle: PlantHandle; arc: readonly HandleVector[] }[] {
	return AXES.map((own, k) => {
		const axis = turned(own, area.rotation);
		const at = placeIn(area, ARMS[k]);
		const by = (degrees: number): Change =>
			changed(specimen, index, { rotation: turnedOn(area.rotation, axis, degrees) });
		const first = from(at, area.centre);
		const across = cross(axis, first);
		const [one, other] = [unit(across), unit(cross(across, axis))];
		const arc = Array.from({ length: PIECES + 1 }, (_, i): HandleVector => {
			const way = turnedOn(UNTURNED, axis, ARC * ((2 * i) / PIECES - 1));
			return moved(area.centre, turned(first, way));
		});
		const handle: PlantHandle = {
			id: `turn-${k}`,
			label: `Turn of area ${index + 1} about its ${NAMES[k]} axis`,
			value: `${degreesOf(area.rotation)[k].toFixed(0)}°`,
			kind: "turn",
			at,
			along: [one, other],
			pull: (to) => {
				const now = from(to, area.centre);
				return by((Math.atan2(dot(now, one), dot(now, other)) * 180) / Math.PI);
			},
			nudge: (right, up, large) => by((right || up) * (large ? TURN_FAR : TURN)),
		};
		return { handle, arc };
	});
}

function place(specimen: WithAreas, at: Triple, index: number): PlantHandle {
	return {
		id: `place-${index}`,
		label: `Place ${index + 1} of the main branch`,
		value: placeInWords(at),
		at,
		along: AXES,
		pull: ([x, y, z]) => movedPlace(specimen, index, [x, y, z]),
		nudge: (right, up, large) => movedPlace(specimen, index, moved(at, times([right, up, 0], large ? STRIDE : STEP))),
	};
}

const dot = (a: Triple, b: Triple): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const from = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Triple, b: Triple): Triple => [
	a[1] * b[2] - a[2] * b[1],
	a[2] * b[0] - a[0] * b[2],
	a[0] * b[1] - a[1] * b[0],
];
function unit(a: Triple): Triple {
	const length = Math.hypot(...a) || 1;
	return times(a, 1 / length);
}
