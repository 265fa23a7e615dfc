/** Grips of obstacles: each view moves an obstacle by its centre and resizes it by its upper right corner. */

import { lengthInWords } from "../../../../plant/in_words";
import type { Change } from "../../../../ui/editor_context";
import type { Point } from "../../../../ui/handles/point";
import { text } from "../../messages.generated";
import type { Bounded } from "../bounded";
import { FARTHEST, fitted } from "../details/places";
import type { GripWithoutKeys } from "./arrow_keys";
import { type Facing, moved, placeInWords, seen } from "./facing";

const WIDTH = 6;
/** Least thickness and height of an obstacle, metres. */
const LEAST = 0.02;

/** Kinds of obstacles, by their keys in a specimen. */
export type WallKind = "obstacles" | "rounds";
const NAMES = { obstacles: "obstacle", rounds: "round_obstacle" } as const;
const KINDS = Object.keys(NAMES) as WallKind[];

/** Returns low x, y, z, high x, y, z of each obstacle of a kind. */
export function wallsOf(specimen: Bounded, kind: WallKind = "obstacles"): number[][] {
	const numbers = specimen[kind] ?? [];
	return Array.from({ length: numbers.length / WIDTH }, (_, i) => numbers.slice(WIDTH * i, WIDTH * (i + 1)));
}

/** Returns the number of obstacles of both kinds. */
export function countOfWalls(specimen: Bounded): number {
	return KINDS.reduce((sum, kind) => sum + wallsOf(specimen, kind).length, 0);
}

/** Returns the handles of all walls: of each one for its middle and those for its size. */
export function wallGrips(specimen: Bounded, facing: Facing): GripWithoutKeys[] {
	return KINDS.flatMap((kind) => {
		const walls = wallsOf(specimen, kind);
		return walls.flatMap((wall, i): GripWithoutKeys[] => {
			const [low, high] = [wall.slice(0, 3), wall.slice(3)];
			const middle = low.map((value, k) => (value + high[k]) / 2);
			// Sizes in this view: across, and upwards or in depth.
			const [thick, tall] = [high[0] - low[0], high[facing.up] - low[facing.up]].map(lengthInWords);
			const shared = {
				label: text(NAMES[kind], { number: i + 1 }),
				remove: () => changeToWalls(kind, walls.toSpliced(i, 1)),
			};
			const changed = (to: number[]) => changeToWalls(kind, walls.toSpliced(i, 1, to));
			return [
				{
					...shared,
					id: `${kind}${i} middle`,
					at: seen(middle, facing),
					value: placeInWords(middle, facing),
					pull: (to) => {
						const place = moved(middle, to, facing);
						return changed(shifted(wall, [0, 1, 2].map((k) => place[k] - middle[k]))); // biome-ignore format: a move
					},
				},
				{
					...shared,
					id: `${kind}${i} corner`,
					at: seen(high, facing),
					part: text("size"),
					value: text(facing.up === 1 ? "thick_and_high" : "thick_and_deep", { thick, tall }),
					pull: (to) => {
						const corner = moved(high, to, facing);
						return changed([
							...low,
							...corner.map((value, k) => (value === high[k] ? value : Math.max(value, low[k] + LEAST))),
						]);
					},
				},
			];
		});
	});
}

/** Returns the change that sets all obstacles of a kind; none removes the list. */
function changeToWalls(kind: WallKind, walls: readonly (readonly number[])[]): Change {
	return { details: { [kind]: walls.length > 0 ? fitted(kind, walls) : undefined } };
}

/**
 * Moves an obstacle by metres in x, y and z, at most to the edge of the allowed range.
 * @param wall low x, y, z, high x, y, z
 */
function shifted(wall: readonly number[], by: readonly number[]): number[] {
	const way = by.map((far, k) => Math.min(Math.max(far, -FARTHEST - wall[k]), FARTHEST - wall[k + 3]));
	return wall.map((value, i) => value + way[i % 3]);
}

/**
 * Returns the change that adds a box obstacle from the ground to the height of a point, to the right of the point.
 */
export function withWall(specimen: Bounded, { x, y }: Point, depth: number): Change {
	const [low, high] = [Math.min(0, y), Math.max(0, y)];
	return changeByAddition(specimen, "obstacles", [x, low, -depth / 2, x + 0.06 * (high - low), high, depth / 2]);
}

/** Returns the change that adds an ellipsoid of a width whose left end is at x, metres. */
export function withRound(
	specimen: Bounded,
	x: number,
	{ low, high }: { low: number; high: number },
	width: number,
): Change {
	return changeByAddition(specimen, "rounds", [x, low, -width / 2, x + width, high, width / 2]);
}

/** Returns the change that adds an obstacle to those of its kind. */
function changeByAddition(specimen: Bounded, kind: WallKind, wall: readonly number[]): Change {
	return changeToWalls(kind, [...wallsOf(specimen, kind), shifted(wall, [0, 0, 0])]);
}
