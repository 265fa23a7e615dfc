/** Edits of areas and of the main branch's path by pointer and buttons. Pure functions. */
import type { Change } from "../../../ui/editor_context";
import { fittedArea, fittedPath } from "../details/areas";
import { type Area, type AreaKind, MAX_AREAS, MAX_PATH, type Triple, UNTURNED, type WithAreas } from "./area";

/** Returns the change that replaces all areas. */
export const withAreas = (areas: readonly Area[]): Change => ({
	details: { areas: areas.length > 0 ? areas.map(fittedArea) : undefined },
});

/**
 * Returns the change that replaces the path; without a path the branch leads from centre to centre.
 * @param from for each place the place before it; absent for a branch that does not fork
 */
export function withPath(path: readonly number[] | undefined, from?: readonly number[]): Change {
	const forks = from?.some((before, i) => before !== i) ?? false;
	return {
		details: {
			path: path && path.length > 0 ? fittedPath(path) : undefined,
			from: path && forks ? from : undefined,
		},
	};
}

/** Returns the change of some properties of one area. */
export function changed({ areas = [] }: WithAreas, index: number, change: Partial<Area>): Change {
	return withAreas(areas.map((area, i) => (i === index ? { ...area, ...change } : area)));
}

/** Adds an area above the last one, of the same size. Returns undefined if there is no room for it. */
export function added({ areas = [] }: WithAreas, kind: AreaKind, mesh?: Area["mesh"]): Change | undefined {
	if (areas.length >= MAX_AREAS) return undefined;
	const last = areas.at(-1);
	const size: Triple = last?.size ?? [1, 1, 1];
	const centre: Triple = last ? [last.centre[0], last.centre[1] + 1.1 * size[1], last.centre[2]] : [0, 0.9, 0];
	return withAreas([...areas, { kind, centre, size, rotation: UNTURNED, ...(mesh ? { mesh } : {}) }]);
}

/** Returns the change that removes an area. */
export const removed = ({ areas = [] }: WithAreas, index: number): Change =>
	withAreas(areas.filter((_, i) => i !== index));

/** Moves an area earlier (−1) or later (1) on the main branch. Returns undefined for the first or the last. */
export function reordered({ areas = [] }: WithAreas, index: number, by: 1 | -1): Change | undefined {
	const to = index + by;
	if (!areas[index] || !areas[to]) return undefined;
	const moved = [...areas];
	[moved[index], moved[to]] = [moved[to], moved[index]];
	return withAreas(moved);
}

/** Returns the places that the main branch passes: the drawn ones, or else the areas' centres. */
export const placesOf = ({ areas = [], path }: WithAreas): readonly Triple[] =>
	path
		? Array.from({ length: path.length / 3 }, (_, i): Triple => [path[3 * i], path[3 * i + 1], path[3 * i + 2]])
		: areas.map(({ centre }) => centre);

/** Returns for each place the place before it, counted from 1; 0 is the foot. */
export const fromOf = (specimen: WithAreas): readonly number[] => specimen.from ?? placesOf(specimen).map((_, i) => i);

/** Returns the branches as lines, each from its beginning. */
export function branchesOf(specimen: WithAreas): readonly (readonly Triple[])[] {
	const places = placesOf(specimen);
	const from = fromOf(specimen);
	const at = (number: number): Triple => (number === 0 ? [0, 0, 0] : places[number - 1]);
	const lines: Triple[][] = [];
	// The line of each place: the same array objects as in `lines`, which grow as places are added.
	const lineOf: Triple[][] = [];
	places.forEach((place, i) => {
		// The first successor of a place continues its line; others, and those of the foot, begin a line.
		const isFirst = from.indexOf(from[i]) === i;
		const line = isFirst && from[i] > 0 ? lineOf[from[i] - 1] : [at(from[i])];
		if (line.length === 1) lines.push(line);
		line.push(place);
		lineOf.push(line);
	});
	return lines;
}

/**
 * Returns the change that moves a place. From the first move on, the path is drawn and no longer follows the centres.
 */
export function movedPlace(specimen: WithAreas, index: number, to: Triple): Change {
	return withPath(
		placesOf(specimen).flatMap((place, i) => (i === index ? to : place)),
		fromOf(specimen),
	);
}

/**
 * Returns the change that adds a place after another, half way to the next; after the last one, it continues by half
 * the last distance. Undefined where there is no such place or no room.
 */
export function addedPlace(specimen: WithAreas, index: number): Change | undefined {
	const places = placesOf(specimen);
	const at = places[index];
	if (!at || places.length >= MAX_PATH) return undefined;
	// `from` holds numbers of places, counted from 1; 0 is the foot.
	const from = fromOf(specimen);
	const number = index + 1;
	const addedNumber = number + 1;
	const firstSuccessor = from.indexOf(number);
	const next = places[firstSuccessor];
	const before = places[from[index] - 1] ?? [0, 0, 0];
	const between = (k: number) => (next ? (at[k] + next[k]) / 2 : at[k] + (at[k] - before[k]) / 2);
	const addedPoint = [between(0), between(1), between(2)];
	const renumbered = from.map((parent) => (parent > number ? parent + 1 : parent));
	// The first successor follows the added place; further ones stay on the place that they fork from.
	if (firstSuccessor >= 0) renumbered[firstSuccessor] = addedNumber;
	return withPath(
		places.flatMap((place, i) => (i === index ? [...place, ...addedPoint] : place)),
		renumbered.toSpliced(index + 1, 0, number),
	);
}

/**
 * Returns the change that removes a place, given by its index; without any place the branch leads from centre to centre
 * again.
 */
export function removedPlace(specimen: WithAreas, index: number): Change {
	const from = fromOf(specimen);
	// `from` holds numbers of places, counted from 1; 0 is the foot.
	const removedNumber = index + 1;
	const predecessor = from[index];
	const firstSuccessor = from.indexOf(removedNumber);
	// Successors of the removed place follow its predecessor. If that is the foot, only the first successor follows the
	// foot, and the others follow the first successor.
	const newParent = (successor: number): number => {
		if (predecessor > 0) return predecessor;
		return successor === firstSuccessor ? 0 : firstSuccessor + 1;
	};
	const reattached = from.map((parent, i) => (parent === removedNumber ? newParent(i) : parent));
	const renumbered = reattached.map((parent) => (parent > removedNumber ? parent - 1 : parent));
	return withPath(
		placesOf(specimen).flatMap((place, i) => (i === index ? [] : place)),
		renumbered.toSpliced(index, 1),
	);
}

/** Greatest distance from the line at which a stroke's places are dropped, as a share of its length. */
const SLACK = 0.012;

/**
 * Simplifies a drawn stroke to a path that keeps its shape, and returns the change that sets it; undefined where the
 * stroke is too short.
 */
export function strokePath(stroke: readonly Triple[]): Change | undefined {
	if (stroke.length < 2) return undefined;
	const long = stroke.slice(1).reduce((sum, at, i) => sum + distance(at, stroke[i]), 0);
	if (!(long > 0)) return undefined;
	const places = simplified(stroke, SLACK * long);
	return withPath(places.flat());
}

/**
 * Returns the change that adds a drawn stroke as a further branch, which begins at the place nearest to the stroke's
 * start; undefined where the stroke is too short or there is no room.
 */
export function strokeFork(specimen: WithAreas, stroke: readonly Triple[]): Change | undefined {
	const places = placesOf(specimen);
	const drawn = strokePath(stroke)?.details?.path as readonly number[] | undefined;
	const count = (drawn?.length ?? 0) / 3 - 1;
	if (!drawn || places.length === 0 || places.length + count > MAX_PATH) return undefined;
	const far = places.map((place) => distance(place, stroke[0]));
	const nearest = far.indexOf(Math.min(...far)) + 1;
	const added = Array.from({ length: count }, (_, i) => (i === 0 ? nearest : places.length + i));
	return withPath([...places.flat(), ...drawn.slice(3)], [...fromOf(specimen), ...added]);
}

/**
 * Simplifies a line by the algorithm of Ramer, Douglas and Peucker: no left-out place is farther than `slack` (metres)
 * from the result.
 */
function simplified(line: readonly Triple[], slack: number): readonly Triple[] {
	const [from, to] = [line[0], line[line.length - 1]];
	let [farthest, where] = [0, 0];
	for (let i = 1; i + 1 < line.length; i++) {
		const far = distanceFromSegment(line[i], from, to);
		if (far > farthest) [farthest, where] = [far, i];
	}
	if (farthest <= slack) return [from, to];
	return [...simplified(line.slice(0, where + 1), slack).slice(0, -1), ...simplified(line.slice(where), slack)];
}

/** Returns the distance between two points. */
const distance = (a: Triple, b: Triple): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

/**
 * Returns the distance of the point p from the segment a b: the nearest point is at parameter t, 0 … 1, of the segment.
 */
function distanceFromSegment(p: Triple, a: Triple, b: Triple): number {
	const square = distance(a, b) ** 2;
	const along = square > 0 ? [0, 1, 2].reduce((sum, k) => sum + (p[k] - a[k]) * (b[k] - a[k]), 0) / square : 0;
	const t = Math.max(0, Math.min(1, along));
	return distance(p, [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])]);
}
