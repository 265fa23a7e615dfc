/**
 * Flowers of a bunch, piece by piece: the flower around each berry's ovary, further flowers beside it that set no
 * fruit (a vine has more than twice as many as berries), and persistent sepals.
 */
import { clamp, smoothstep } from "../../../plant/colour";
import { hashFraction } from "../../../plant/noise";
import { fromUp } from "../../../plant/orientation";
import { TRANSFORM } from "../../../plant/part";
import type { BunchPlant, FlowerPiece } from "../bunch_plant";
import { traitOf } from "../traits";

type Vector = readonly [x: number, y: number, z: number];

/** Pieces of one kind at one berry. */
export interface PlacedPieces {
	piece: FlowerPiece;
	berry: number;
	/** Transforms, 8 numbers each (plant/part.ts), the berry's own flower first. */
	transforms: number[];
}

/** Least share of open stamens' size: smaller ones are hidden in the bud or have fallen. */
const LEAST_STAMENS = 0.01;
/** Numbers of flowers of an inflorescence; those without a pedicel are placed beside the others, `each` per flower. */
const INFLORESCENCE = { least: 240, most: 480, each: 3.5 } as const;
/** Fruits that flower in many-flowered panicles. */
const PANICLES: ReadonlySet<string> = new Set(["grape", "lychee", "longan"]);
/** Distance from a twig's end to the flowers beside its own, in radii of an ovary. */
const SIDE_FLOWER_DISTANCE = 6.2;
/** Offset (a prime) from the id of a berry to that of the first flower beside it, and from each to the next. */
const SIDE_FLOWER_ID = 7919;
/** Streams of `hashFraction` for the properties in which flowers differ. */
const STREAM = {
	count: 40,
	fallen: 41,
	azimuth: 42,
	tilt: 43,
	distance: 44,
	opened: 45,
	clings: 46,
	capAzimuth: 47,
	capTilt: 48,
} as const;
/**
 * When and how caps come off: they loosen while a flower opens, rise by `lift` radii and fall; a few cling to the
 * stamens for long.
 */
const CAP = { loose: 0.12, off: 0.75, lift: 3.4, slip: 1.3, clinging: 0.82, gone: 0.1 } as const;

/** Returns the pieces of all flowers, and the calyces of fruits. */
export function flowersOf(grown: BunchPlant): PlacedPieces[] {
	const { flower, berries } = grown;
	if (!flower) return [];
	const kinds = new Set(flower.pieces.map(({ piece }) => piece));
	const sideFlowersAt = kinds.has("pistil") ? sideFlowerCounter(grown) : () => 0;
	return Array.from({ length: berries.count }, (_, i) => piecesAt(grown, i, kinds, sideFlowersAt(i))).flat();
}

/**
 * Returns a function that returns how many flowers that set no fruit are beside that of a berry. They are distributed
 * evenly, so that the bunch has the number of flowers of an inflorescence.
 */
function sideFlowerCounter({ berries, form, thinned }: BunchPlant): (berry: number) => number {
	const fallen = thinned.filter(({ why }) => why === "not set").length;
	const flowers = berries.count + fallen;
	const { least, most, each } = INFLORESCENCE;
	const extra = clamp(each * flowers, least, most) - flowers;
	if (!PANICLES.has(form.fruit) || extra <= 0 || flowers === 0) return () => 0;
	return (berry) => Math.floor(extra / flowers + hashFraction(berries.ids[berry], STREAM.count));
}

/**
 * Returns the pieces of one berry's flower, and of the flowers beside it.
 * @param kinds kinds of pieces that the fruit has; others are not placed
 * @param sideFlowers number of flowers beside the berry's own
 */
function piecesAt(
	grown: BunchPlant,
	berry: number,
	kinds: ReadonlySet<FlowerPiece>,
	sideFlowers: number,
): PlacedPieces[] {
	const { berries, flower } = grown;
	const [x, y, z, radius] = berries.spheres.subarray(4 * berry, 4 * berry + 4);
	const [dx, dy, dz] = berries.directions.subarray(3 * berry, 3 * berry + 3);
	const [opened, set] = [traitOf(berries, berry, "opened"), traitOf(berries, berry, "set")];
	const centre: Vector = [x, y, z];
	const heading: Vector = [dx, dy, dz];
	const seat = pointAlong(centre, heading, -0.5 * traitOf(berries, berry, "length"));
	const unit = flower?.unit ?? 0;
	const transformsOf = new Map<FlowerPiece, number[]>();
	const put = (piece: FlowerPiece, at: Vector, towards: Vector, scale: number) => {
		if (!kinds.has(piece)) return;
		const transforms = transformsOf.get(piece) ?? [];
		const turn = fromUp(...towards);
		transforms.push(...at, turn.x, turn.y, turn.z, turn.w, scale);
		transformsOf.set(piece, transforms);
	};
	// The berry's own flower.
	placeFlower(put, { at: centre, heading, size: Math.max(unit, radius), opened, set, id: berries.ids[berry] });
	put("calyx", seat, heading, unit);
	// Flowers beside it, which have set no fruit; they drop one by one as the fruit sets.
	for (let k = 0; k < sideFlowers; k++) {
		const id = berries.ids[berry] + SIDE_FLOWER_ID * (k + 1);
		const fallen = set > 0.05 + 0.7 * hashFraction(id, STREAM.fallen);
		if (fallen) continue;
		const azimuth = (k + 0.6 * hashFraction(id, STREAM.azimuth)) / sideFlowers;
		const towards = tilted(heading, azimuth, 0.8 + 0.5 * hashFraction(id, STREAM.tilt));
		const distance = SIDE_FLOWER_DISTANCE * unit * (0.85 + 0.4 * hashFraction(id, STREAM.distance));
		const at = pointAlong(pointAlong(seat, heading, -unit), towards, distance);
		put("pistil", at, towards, unit);
		const ownOpened = clamp(1.5 * opened - 0.5 * hashFraction(id, STREAM.opened));
		placeFlower(put, { at, heading: towards, size: unit, opened: ownOpened, set, id });
	}
	return Array.from(transformsOf, ([piece, transforms]) => ({ piece, berry, transforms }));
}

interface Flower {
	/** Centre of its ovary. */
	at: Vector;
	heading: Vector;
	/** Radius of its ovary. */
	size: number;
	/** Progress 0 … 1: from bud to flower, and from flower to fruit. */
	opened: number;
	set: number;
	id: number;
}

/**
 * Places the pieces of one flower: stamens and petals unfold as it opens and wither as it sets; its cap comes off.
 * @param put receives each piece with its position, direction and size
 */
function placeFlower(
	put: (piece: FlowerPiece, at: Vector, heading: Vector, scale: number) => void,
	{ at, heading, size, opened, set, id }: Flower,
): void {
	const out = opened * (1 - set);
	if (out > LEAST_STAMENS) {
		put("stamens", at, heading, size * out);
		put("petals", at, heading, size * out);
	}
	const clings = hashFraction(id, STREAM.clings) > CAP.clinging;
	if (clings ? set > CAP.gone : opened > CAP.off) return;
	const lift = smoothstep(CAP.loose, CAP.off, opened);
	const tilt = tilted(heading, hashFraction(id, STREAM.capAzimuth), lift * (0.6 + hashFraction(id, STREAM.capTilt)));
	const raised = pointAlong(at, heading, lift * CAP.lift * size);
	put("cap", pointAlong(raised, tilt, lift * CAP.slip * size), tilt, size);
}

/** Returns the point at a distance from another in a direction of unit length. */
const pointAlong = ([x, y, z]: Vector, [dx, dy, dz]: Vector, distance: number): Vector => [
	x + dx * distance,
	y + dy * distance,
	z + dz * distance,
];

/** Returns a direction at an angle (radians) from another, rotated about it by a share of a turn. */
function tilted([x, y, z]: Vector, share: number, angle: number): Vector {
	const flat = Math.hypot(x, z);
	const east: Vector = flat > 1e-6 ? [z / flat, 0, -x / flat] : [1, 0, 0];
	const north: Vector = [y * east[2] - z * east[1], z * east[0] - x * east[2], x * east[1] - y * east[0]];
	const [c, s] = [Math.cos(2 * Math.PI * share), Math.sin(2 * Math.PI * share)];
	const across = pointAlong([c * east[0], c * east[1], c * east[2]], north, s);
	return pointAlong([x * Math.cos(angle), y * Math.cos(angle), z * Math.cos(angle)], across, Math.sin(angle));
}

/** Counts the pieces of a kind. */
export function countOf(pieces: readonly PlacedPieces[], kind: FlowerPiece): number {
	return pieces.reduce((sum, { piece, transforms }) => sum + (piece === kind ? transforms.length / TRANSFORM : 0), 0);
}
