/** Boxes in which nothing grows: in each view one is moved by its middle and sized by its far right corner. */
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

export function wallsOf({ obstacles = [] }: Bounded): number[][] {
	return Array.from({ length: obstacles.length / WIDTH }, (_, i) => obstacles.slice(WIDTH * i, WIDTH * (i + 1)));
}

export function wallGrips(specimen: Bounded, facing: Facing): Grip[] {
	return wallsOf(specimen).flatMap((wall, i): Grip[] => {
		const [low, high] = [wall.slice(0, 3), wall.slice(3)];
		const middle = low.map((value, k) => (value + high[k]) / 2);
		const [thick, tall] = [high[0] - low[0], high[facing.up] - low[facing.up]].map(lengthInWords);
		return [
			{
				id: `wall${i} middle`,
				at: seen(middle, facing),
				label: `Obstacle ${i + 1}`,
				value: placeInWords(middle, facing),
			},
			{
				id: `wall${i} corner`,
				at: seen(high, facing),
				label: `Obstacle ${i + 1}, size`,
				value: `${thick} thick, ${tall} ${facing.up === 1 ? "high" : "deep"}`,
			},
		];
	});
}

export function pullWall(specimen: Bounded, id: string, to: Point, facing: Facing): Change {
	const [name, which] = id.split(" ");
	const walls = wallsOf(specimen);
	const index = Number(name.slice("wall".length));
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
	return { details: { obstacles: walls.flat().map((value) => onStep(value)) } };
}

/** With one wall more: from the ground to the height of a point, to the right of it. */
export function withWall(specimen: Bounded, { x, y }: Point, depth: number): Change {
	const [low, high] = [Math.min(0, y), Math.max(0, y)];
	const wall = [x, low, -depth / 2, x + 0.06 * (high - low), high, depth / 2].map((value) => onStep(value));
	return { details: { obstacles: [...(specimen.obstacles ?? []), ...wall] } };
}

/** Without the last. */
export function withoutWall({ obstacles = [] }: Bounded): Change {
	return { details: { obstacles: obstacles.length > WIDTH ? obstacles.slice(0, -WIDTH) : undefined } };
}
