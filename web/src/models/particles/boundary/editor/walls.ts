/** Boxes in which nothing grows, from in front: each is moved by its middle and sized by its upper right corner. */
import type { Change } from "../../../../controls/desk";
import type { Point } from "../../../../controls/handles/point";
import { onStep } from "../../../../specimen/table";
import type { Bounded } from "../bounded";
import { lengthInWords } from "../words";
import type { Grip } from "./grip";

const WIDTH = 6;
/** The least that a wall is thick or high, metres. */
const LEAST = 0.02;

export function wallsOf({ obstacles = [] }: Bounded): number[][] {
	return Array.from({ length: obstacles.length / WIDTH }, (_, i) => obstacles.slice(WIDTH * i, WIDTH * (i + 1)));
}

export function wallGrips(specimen: Bounded): Grip[] {
	return wallsOf(specimen).flatMap(([ax, ay, , bx, by], i): Grip[] => [
		{
			id: `wall${i} middle`,
			at: { x: (ax + bx) / 2, y: (ay + by) / 2 },
			label: `Obstacle ${i + 1}`,
			value: `${lengthInWords(Math.abs(ax + bx) / 2)} ${ax + bx < 0 ? "left" : "right"}`,
		},
		{
			id: `wall${i} corner`,
			at: { x: bx, y: by },
			label: `Obstacle ${i + 1}, size`,
			value: `${lengthInWords(bx - ax)} thick, ${lengthInWords(by - ay)} high`,
		},
	]);
}

export function pullWall(specimen: Bounded, id: string, to: Point): Change {
	const [name, which] = id.split(" ");
	const walls = wallsOf(specimen);
	const index = Number(name.slice("wall".length));
	const [ax, ay, az, bx, by, bz] = walls[index];
	const [dx, dy] = which === "middle" ? [to.x - (ax + bx) / 2, to.y - (ay + by) / 2] : [0, 0];
	const high = which === "middle" ? [bx + dx, by + dy] : [Math.max(to.x, ax + LEAST), Math.max(to.y, ay + LEAST)];
	walls[index] = [ax + dx, ay + dy, az, ...high, bz];
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
