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
const LEAST = 0.01;
/** Numbers of flowers of an inflorescence; those without a pedicel are placed beside the others, `each` per flower. */
const INFLORESCENCE = { least: 240, most: 480, each: 3.5 } as const;
/** Fruits that flower in many-flowered panicles. */
const PANICLES: ReadonlySet<string> = new Set(["grape", "lychee", "longan"]);
/** Distance from a twig's end to the flowers beside its own, in radii of an ovary. */
const SIDE_FLOWER_DISTANCE = 6.2;
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
	const beside = kinds.has("pistil") ? besideEach(grown) : () => 0;
	return Array.from({ length: berries.count }, (_, i) => twig(grown, i, kinds, beside(i))).flat();
}

/** Returns the number of flowers beside that of a berry. */
function besideEach({ berries, form, thinned }: BunchPlant): (berry: number) => number {
	const fallen = thinned.filter(({ why }) => why === "not set").length;
	const flowers = berries.count + fallen;
	const { least, most, each } = INFLORESCENCE;
	const extra = clamp(each * flowers, least, most) - flowers;
	if (!PANICLES.has(form.fruit) || extra <= 0 || flowers === 0) return () => 0;
	return (berry) => Math.floor(extra / flowers + hashFraction(berries.ids[berry], 40));
}

/** Returns the pieces of one berry's flower, and of the flowers beside it. */
function twig(grown: BunchPlant, berry: number, kinds: ReadonlySet<FlowerPiece>, beside: number): PlacedPieces[] {
	const { berries, flower } = grown;
	const [x, y, z, radius] = berries.spheres.subarray(4 * berry, 4 * berry + 4);
	const [dx, dy, dz] = berries.directions.subarray(3 * berry, 3 * berry + 3);
	const [opened, set] = [traitOf(berries, berry, "opened"), traitOf(berries, berry, "set")];
	const centre: Vector = [x, y, z];
	const heading: Vector = [dx, dy, dz];
	const seat = along(centre, heading, -0.5 * traitOf(berries, berry, "length"));
	const unit = flower?.unit ?? 0;
	const placed = new Map<FlowerPiece, number[]>();
	const put = (piece: FlowerPiece, at: Vector, towards: Vector, scale: number) => {
		if (!kinds.has(piece)) return;
		const list = placed.get(piece) ?? [];
		const turn = fromUp(...towards);
		list.push(...at, turn.x, turn.y, turn.z, turn.w, scale);
		placed.set(piece, list);
	};
	bloom(put, { at: centre, heading, size: Math.max(unit, radius), opened, set, id: berries.ids[berry] });
	put("calyx", seat, heading, unit);
	for (let k = 0; k < beside; k++) {
		const id = berries.ids[berry] + 7919 * (k + 1);
		if (set > 0.05 + 0.7 * hashFraction(id, 41)) continue;
		const towards = tilted(heading, (k + 0.6 * hashFraction(id, 42)) / beside, 0.8 + 0.5 * hashFraction(id, 43));
		const at = along(
			along(seat, heading, -unit),
			towards,
			SIDE_FLOWER_DISTANCE * unit * (0.85 + 0.4 * hashFraction(id, 44)),
		);
		put("pistil", at, towards, unit);
		bloom(put, { at, heading: towards, size: unit, opened: clamp(1.5 * opened - 0.5 * hashFraction(id, 45)), set, id });
	}
	return Array.from(placed, ([piece, transforms]) => ({ piece, berry, transforms }));
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

/** Places the pieces of one flower: stamens and petals unfold as it opens and wither as it sets; its cap comes off. */
function bloom(
	put: (piece: FlowerPiece, at: Vector, heading: Vector, scale: number) => void,
	{ at, heading, size, opened, set, id }: Flower,
): void {
	const out = opened * (1 - set);
	if (out > LEAST) {
		put("stamens", at, heading, size * out);
		put("petals", at, heading, size * out);
	}
	const clings = hashFraction(id, 46) > CAP.clinging;
	if (clings ? set > CAP.gone : opened > CAP.off) return;
	const lift = smoothstep(CAP.loose, CAP.off, opened);
	const tilt = tilted(heading, hashFraction(id, 47), lift * (0.6 + hashFraction(id, 48)));
	const raised = along(at, heading, lift * CAP.lift * size);
	put("cap", along(raised, tilt, lift * CAP.slip * size), tilt, size);
}

const along = ([x, y, z]: Vector, [dx, dy, dz]: Vector, far: number): Vector => [
	x + dx * far,
	y + dy * far,
	z + dz * far,
];

/** Returns a direction at an angle (radians) from another, rotated about it by a share of a turn. */
function tilted([x, y, z]: Vector, share: number, angle: number): Vector {
	const flat = Math.hypot(x, z);
	const east: Vector = flat > 1e-6 ? [z / flat, 0, -x / flat] : [1, 0, 0];
	const north: Vector = [y * east[2] - z * east[1], z * east[0] - x * east[2], x * east[1] - y * east[0]];
	const [c, s] = [Math.cos(2 * Math.PI * share), Math.sin(2 * Math.PI * share)];
	const across = along([c * east[0], c * east[1], c * east[2]], north, s);
	return along([x * Math.cos(angle), y * Math.cos(angle), z * Math.cos(angle)], across, Math.sin(angle));
}

/** Counts the pieces of a kind. */
export function countOf(pieces: readonly PlacedPieces[], kind: FlowerPiece): number {
	return pieces.reduce((sum, { piece, transforms }) => sum + (piece === kind ? transforms.length / TRANSFORM : 0), 0);
}
