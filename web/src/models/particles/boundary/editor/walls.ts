/** Boxes and ellipsoids in which nothing grows: in each view one is moved by its middle and sized by its far right corner. */
import type { Change } from "../../../../controls/desk";
import type { Point } from "../../../../controls/handles/point";
import { onStep } from "../../../../specimen/table";
import type { Bounded } from "../bounded";
import { lengthInWords } from "../words";
import { type Facing, moved, placeInWords, seen } from "./facing";
import type { Grip } from "./grip";

const WIDTH = 6;
/** The least that a wall is thick or high, metres. */
const LEAST = 0.02;

/** Kinds of obstacles, as a specimen has them. */
export type WallKind = "obstacles" | "rounds";
const NAMES: Readonly<Record<WallKind, string>> = { obstacles: "Obstacle", rounds: "Round obstacle" };
const KINDS = Object.keys(NAMES) as WallKind[];

/** Low x, y, z, high x, y, z of each of a kind. */
export function wallsOf(specimen: Bounded, kind: WallKind = "obstacles"): number[][] {
	const numbers = specimen[kind] ?? [];
	return Array.from({ length: numbers.length / WIDTH }, (_, i) => numbers.slice(WIDTH * i, WIDTH * (i + 1)));
}

export function countOfWalls(specimen: Bounded): number {
	return KINDS.reduce((sum, kind) => sum + wallsOf(specimen, kind).length, 0);
}

/** Whether a grip is one of an obstacle's. */
export const isWall = (id: string): boolean => /^(obstacles|rounds)\d/.test(id);

export function wallGrips(specimen: Bounded, facing: Facing): Grip[] {
	return KINDS.flatMap((kind) =>
		wallsOf(specimen, kind).flatMap((wall, i): Grip[] => {
			const [low, high] = [wall.slice(0, 3), wall.slice(3)];
			const middle = low.map((value, k) => (value + high[k]) / 2);
			const [thick, tall] = [high[0] - low[0], high[facing.up] - low[facing.up]].map(lengthInWords);
			const label = `${NAMES[kind]} ${i + 1}`;
			return [
				{ id: `${kind}${i} middle`, at: seen(middle, facing), label, value: placeInWords(middle, facing) },
				{
					id: `${kind}${i} corner`,
					at: seen(high, facing),
					label: `${label}, size`,
					value: `${thick} thick, ${tall} ${facing.up === 1 ? "high" : "deep"}`,
				},
			];
		}),
	);
}

export function pullWall(specimen: Bounded, id: string, to: Point, facing: Facing): Change {
	const [, kind, number, which] = /^([a-z]+)(\d+) (\w+)$/.exec(id) as unknown as [string, WallKind, string, string];
	const walls = wallsOf(specimen, kind);
	const index = Number(number);
	const [low, high] = [walls[index].slice(0, 3), walls[index].slice(3)];
	if (which === "middle") {
		const middle = low.map((value, k) => (value + high[k]) / 2);
		const by = moved(middle, to, facing).map((value, k) => value - middle[k]);
		walls[index] = [...low, ...high].map((value, k) => value + by[k % 3]);
	} else {
		const corner = moved(high, to, facing).map((value, k) =>
			value === high[k] ? value : Math.max(value, low[k] + LEAST),
		);
		walls[index] = [...low, ...corner];
	}
	return { details: { [kind]: walls.flat().map((value) => onStep(value)) } };
}

/** With one wall more: from the ground to the height of a point, to the right of it. */
export function withWall(specimen: Bounded, { x, y }: Point, depth: number): Change {
	const [low, high] = [Math.min(0, y), Math.max(0, y)];
	return withOne(specimen, "obstacles", [x, low, -depth / 2, x + 0.06 * (high - low), high, depth / 2]);
}

/** With an ellipsoid more, as wide as that, which begins at x. */
export function withRound(
	specimen: Bounded,
	x: number,
	{ low, high }: { low: number; high: number },
	width: number,
): Change {
	return withOne(specimen, "rounds", [x, low, -width / 2, x + width, high, width / 2]);
}

function withOne(specimen: Bounded, kind: WallKind, wall: number[]): Change {
	return { details: { [kind]: [...(specimen[kind] ?? []), ...wall.map((value) => onStep(value))] } };
}

/** Without the last: of the round ones, if there are any. */
export function withoutWall(specimen: Bounded): Change {
	const kind = specimen.rounds ? "rounds" : "obstacles";
	const numbers = specimen[kind] ?? [];
	return { details: { [kind]: numbers.length > WIDTH ? numbers.slice(0, -WIDTH) : undefined } };
}
