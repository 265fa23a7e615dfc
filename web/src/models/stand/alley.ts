/** Finds the way between two rows of a planted stand, such as a vineyard. Pure; lengths in metres. */
import type { StandPlant } from "./stand_plant";
import { eyeHeight, type StandPose } from "./walker";

/** Directions in which rows are looked for, one for each degree; a row has no front. */
const DIRECTIONS = 180;
/** A stand with more plants than this is no plantation, and would take too long. */
const MOST_PLANTS = 4000;
/** Least number of plants in a row, on average: of scattered plants, each is a row of its own. */
const LEAST_IN_ROW = 4;
/** Least number of rows: there are two parts of scattered plants with a gap between them in some direction. */
const LEAST_ROWS = 3;
/** Least share of the stand's width that is free between rows. */
const LEAST_FREE = 0.15;
/** Least width of an alley, as a share of the walker's eye height. */
const LEAST_WIDTH = 0.25;
/** Distance of the start from the ground's edge, as a share of the ground's length along the alley. */
const FROM_EDGE = 0.04;

type Planted = Pick<StandPlant, "ground" | "places" | "kinds">;

/** Plants seen along a direction: the position across it, and half the width of the crown. */
interface Crown {
	readonly across: number;
	readonly half: number;
}

/** The free strips between rows in one direction. */
interface Alleys {
	/** Positions of the middles, across the direction. */
	readonly middles: readonly number[];
	/** Share of the stand's width that is free. */
	readonly free: number;
}

/**
 * Returns a start between the two rows nearest to the middle of the ground, looking along them; undefined if the plants
 * do not stand in rows with room between them.
 */
export function betweenRows(stand: Planted): StandPose | undefined {
	const plants = standingPlants(stand);
	if (plants.length === 0 || plants.length > MOST_PLANTS) return undefined;
	let best: { readonly yaw: number; readonly alleys: Alleys } | undefined;
	for (let yaw = 0; yaw < DIRECTIONS; yaw++) {
		const alleys = alleysAlong(plants, yaw, LEAST_WIDTH * eyeHeight(stand));
		if (alleys && alleys.free > (best?.alleys.free ?? 0)) best = { yaw, alleys };
	}
	if (!best) return undefined;
	const { yaw, alleys } = best;
	const middle = alleys.middles.reduce((a, b) => (Math.abs(b) < Math.abs(a) ? b : a));
	return atEntrance(stand, yaw, middle);
}

/** Returns the plants that stand on the ground: position and half the width of the crown. */
function standingPlants({ kinds, places }: Planted): { x: number; z: number; half: number }[] {
	const plants = [];
	for (let plant = 0; plant < places.count; plant++) {
		if (places.parent[plant] >= 0) continue;
		const half = 0.5 * kinds[places.kind[plant]].crown.width * places.scale[plant];
		plants.push({ x: places.at[3 * plant], z: places.at[3 * plant + 2], half });
	}
	return plants;
}

/**
 * Returns the alleys in a direction; undefined if there are none.
 * @param yaw degrees from −z to +x
 * @param least least width of an alley
 */
function alleysAlong(
	plants: readonly { readonly x: number; readonly z: number; readonly half: number }[],
	yaw: number,
	least: number,
): Alleys | undefined {
	const angle = (yaw * Math.PI) / 180;
	const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
	const crowns: Crown[] = plants.map(({ x, z, half }) => ({ across: x * cosine + z * sine, half }));
	crowns.sort((a, b) => a.across - a.half - (b.across - b.half));
	const start = crowns[0].across - crowns[0].half;
	let end = start;
	let gaps = 0;
	const middles: number[] = [];
	let width = 0;
	for (const { across, half } of crowns) {
		const from = across - half;
		if (from - end >= least) {
			middles.push((from + end) / 2);
			width += from - end;
		}
		if (from > end) gaps++;
		end = Math.max(end, across + half);
	}
	const rows = gaps + 1;
	const free = width / (end - start);
	const areRows = rows >= LEAST_ROWS && plants.length / rows >= LEAST_IN_ROW;
	return areRows && free >= LEAST_FREE ? { middles, free } : undefined;
}

/**
 * Returns the pose at the end of an alley from which it leads across the ground.
 * @param across position of the alley's middle across its direction
 */
function atEntrance({ ground }: Planted, yaw: number, across: number): StandPose {
	const angle = (yaw * Math.PI) / 180;
	const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
	// Forwards is (sine, −cosine); the alley is at `across` times (cosine, sine).
	const [x, z] = [across * cosine, across * sine];
	const back = Math.min(distanceToEdge(x, -sine, 0.5 * ground.width), distanceToEdge(z, cosine, 0.5 * ground.depth));
	const forth = Math.min(distanceToEdge(x, sine, 0.5 * ground.width), distanceToEdge(z, -cosine, 0.5 * ground.depth));
	const distance = back - FROM_EDGE * (back + forth);
	return { x: x - distance * sine, z: z + distance * cosine, yaw, pitch: 0 };
}

/** Returns the distance from a coordinate to the end of −limit … limit, moving by `step` per metre. */
const distanceToEdge = (from: number, step: number, limit: number): number =>
	Math.abs(step) < 1e-9 ? Number.POSITIVE_INFINITY : (Math.sign(step) * limit - from) / step;
