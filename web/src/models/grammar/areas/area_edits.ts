/** Edits of areas and of the main branch's path by pointer and buttons. Pure functions. */
import type { Change } from "../../../ui/editor_context";
import { fittedArea, fittedPath } from "../details/areas";
import { type Area, type AreaKind, MOST_AREAS, MOST_PATH, type Triple, UNTURNED, type WithAreas } from "./area";

/** Replaces all areas. */
export const withAreas = (areas: readonly Area[]): Change => ({
	details: { areas: areas.length > 0 ? areas.map(fittedArea) : undefined },
});

/**
 * Replaces the path.
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

/** Changes one area. */
export function changed({ areas = [] }: WithAreas, index: number, change: Partial<Area>): Change {
	return withAreas(areas.map((area, i) => (i === index ? { ...area, ...change } : area)));
}

/** Adds an area above the last one, of the same size. Returns undefined if there is no room for it. */
export function added({ areas = [] }: WithAreas, kind: AreaKind, mesh?: Area["mesh"]): Change | undefined {
	if (areas.length >= MOST_AREAS) return undefined;
	const last = areas.at(-1);
	const size: Triple = last?.size ?? [1, 1, 1];
	const centre: Triple = last ? [last.centre[0], last.centre[1] + 1.1 * size[1], last.centre[2]] : [0, 0.9, 0];
	return withAreas([...areas, { kind, centre, size, rotation: UNTURNED, ...(mesh ? { mesh } : {}) }]);
}

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
	const lineOf: Triple[][] = [];
	places.forEach((place, i) => {
		// The first successor of a place continues its line.
		const first = from.indexOf(from[i]) === i;
		const line = first && from[i] > 0 ? lineOf[from[i] - 1] : [at(from[i])];
		if (line.length === 1) lines.push(line);
		line.push(place);
		lineOf.push(line);
	});
	return lines;
}

/** Moves a place. From the first move on, the path is drawn and no longer follows the centres. */
export function movedPlace(specimen: WithAreas, index: number, to: Triple): Change {
	return withPath(
		placesOf(specimen).flatMap((place, i) => (i === index ? to : place)),
		fromOf(specimen),
	);
}

/** Adds a place after another, half way to the next; after the last one, continues by half the last distance. */
export function addedPlace(specimen: WithAreas, index: number): Change | undefined {
	const places = placesOf(specimen);
	const at = places[index];
	if (!at || places.length >= MOST_PATH) return undefined;
	const next = places[fromOf(specimen).indexOf(index + 1)];
	const before = places[fromOf(specimen)[index] - 1] ?? [0, 0, 0];
	const between = (k: number) => (next ? (at[k] + next[k]) / 2 : at[k] + (at[k] - before[k]) / 2);
	const more = [between(0), between(1), between(2)];
	const from = fromOf(specimen);
	const first = from.indexOf(index + 1);
	const moved = from.map((before, i) => (i === first ? index + 2 : before > index + 1 ? before + 1 : before));
	return withPath(
		places.flatMap((place, i) => (i === index ? [...place, ...more] : place)),
		moved.toSpliced(index + 1, 0, index + 1),
	);
}

/** Removes a place; without any place the branch leads from centre to centre again. */
export function removedPlace(specimen: WithAreas, index: number): Change {
	const from = fromOf(specimen);
	// Successors of the removed place follow its predecessor; if that was the foot, they follow the first successor.
	const first = from.indexOf(index + 1);
	const instead = from[index] > 0 ? from[index] : first + 1;
	const again = from.map((before, i) =>
		before !== index + 1 ? before : from[index] === 0 && i === first ? 0 : instead,
	);
	const counted = again.map((before) => (before > index + 1 ? before - 1 : before));
	return withPath(
		placesOf(specimen).flatMap((place, i) => (i === index ? [] : place)),
		counted.toSpliced(index, 1),
	);
}

/** Greatest distance from the line at which a stroke's places are dropped, as a share of its length. */
const SLACK = 0.012;

/** Simplifies a drawn stroke to a path that keeps its shape (Douglas and Peucker 1973). */
export function strokePath(stroke: readonly Triple[]): Change | undefined {
	if (stroke.length < 2) return undefined;
	const long = stroke.slice(1).reduce((sum, at, i) => sum + distance(at, stroke[i]), 0);
	if (!(long > 0)) return undefined;
	const places = simplified(stroke, SLACK * long);
	return withPath(places.flat());
}

/** Adds a drawn stroke as a further branch, which begins at the place nearest to the stroke's start. */
export function strokeFork(specimen: WithAreas, stroke: readonly Triple[]): Change | undefined {
	const places = placesOf(specimen);
	const drawn = strokePath(stroke)?.details?.path as readonly number[] | undefined;
	const count = (drawn?.length ?? 0) / 3 - 1;
	if (!drawn || places.length === 0 || places.length + count > MOST_PATH) return undefined;
	const far = places.map((place) => distance(place, stroke[0]));
	const nearest = far.indexOf(Math.min(...far)) + 1;
	const added = Array.from({ length: count }, (_, i) => (i === 0 ? nearest : places.length + i));
	return withPath([...places.flat(), ...drawn.slice(3)], [...fromOf(specimen), ...added]);
}

function simplified(line: readonly Triple[], slack: number): readonly Triple[] {
	const [from, to] = [line[0], line[line.length - 1]];
	let [farthest, where] = [0, 0];
	for (let i = 1; i + 1 < line.length; i++) {
		const far = fromLine(line[i], from, to);
		if (far > farthest) [farthest, where] = [far, i];
	}
	if (farthest <= slack) return [from, to];
	return [...simplified(line.slice(0, where + 1), slack).slice(0, -1), ...simplified(line.slice(where), slack)];
}

const distance = (a: Triple, b: Triple): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

function fromLine(p: Triple, a: Triple, b: Triple): number {
	const square = distance(a, b) ** 2;
	const along = square > 0 ? [0, 1, 2].reduce((sum, k) => sum + (p[k] - a[k]) * (b[k] - a[k]), 0) / square : 0;
	const t = Math.max(0, Math.min(1, along));
	return distance(p, [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])]);
}
