/**
 * The flowers of a bunch, piece by piece: what each berry's ovary bears while it is a flower, the flowers that stand beside
 * it and set no fruit (a vine has more than twice as many as berries), and sepals that stay.
 */
import { clamp, smoothstep } from "../../../plant/colour";
import { hashFraction } from "../../../plant/noise";
import { fromUp } from "../../../plant/orientation";
import { TRANSFORM } from "../../../plant/part";
import type { BunchPlant, FlowerPiece } from "../bunch_plant";
import { traitOf } from "../traits";

type Vector = readonly [x: number, y: number, z: number];

/** Pieces of one kind on one berry's twig. */
export interface PlacedPieces {
	piece: FlowerPiece;
	berry: number;
	/** 8 each (plant/part.ts), the flower's own first. */
	transforms: number[];
}

/** Stamens smaller than this share of open ones are hidden in the bud, or have fallen. */
const LEAST = 0.01;
/** An inflorescence has so many flowers; what its pedicels do not bear stands beside them, so many for each that does. */
const INFLORESCENCE = { least: 240, most: 480, each: 3.5 } as const;
/** Fruits that flower in panicles of many. */
const PANICLES: ReadonlySet<string> = new Set(["grape", "lychee", "longan"]);
/** In radii of an ovary: from a twig's end to the flowers beside its own. */
const SIDE_FLOWER_DISTANCE = 6.2;
/** Caps come loose while a flower opens, are lifted by so many radii, and fall; a few stay on the stamens for long. */
const CAP = { loose: 0.12, off: 0.75, lift: 3.4, slip: 1.3, clinging: 0.82, gone: 0.1 } as const;

/** Of all that is in flower, and the calyces of what was. */
export function flowersOf(grown: BunchPlant): PlacedPieces[] {
	const { flower, berries } = grown;
	if (!flower) return [];
	const kinds = new Set(flower.pieces.map(({ piece }) => piece));
	const beside = kinds.has("pistil") ? besideEach(grown) : () => 0;
	return Array.from({ length: berries.count }, (_, i) => twig(grown, i, kinds, beside(i))).flat();
}

/** How many flowers stand beside that of a berry. */
function besideEach({ berries, form, thinned }: BunchPlant): (berry: number) => number {
	const fallen = thinned.filter(({ why }) => why === "not set").length;
	const flowers = berries.count + fallen;
	const { least, most, each } = INFLORESCENCE;
	const extra = clamp(each * flowers, least, most) - flowers;
	if (!PANICLES.has(form.fruit) || extra <= 0 || flowers === 0) return () => 0;
	return (berry) => Math.floor(extra / flowers + hashFraction(berries.ids[berry], 40));
}

/** One berry's ovary with what it bears, and the flowers beside it. */
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
	/** Its ovary's middle. */
	at: Vector;
	heading: Vector;
	/** Its ovary's radius. */
	size: number;
	/** 0 … 1 each: from bud to flower, and from flower to fruit. */
	opened: number;
	set: number;
	id: number;
}

/** Stamens and petals unfold as a flower opens and wither as it sets; its cap comes off. */
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

/** A direction at an angle (radians) from another, that share of a turn round it. */
function tilted([x, y, z]: Vector, share: number, angle: number): Vector {
	const flat = Math.hypot(x, z);
	const east: Vector = flat > 1e-6 ? [z / flat, 0, -x / flat] : [1, 0, 0];
	const north: Vector = [y * east[2] - z * east[1], z * east[0] - x * east[2], x * east[1] - y * east[0]];
	const [c, s] = [Math.cos(2 * Math.PI * share), Math.sin(2 * Math.PI * share)];
	const across = along([c * east[0], c * east[1], c * east[2]], north, s);
	return along([x * Math.cos(angle), y * Math.cos(angle), z * Math.cos(angle)], across, Math.sin(angle));
}

/** How many of a kind of piece there are. */
export function countOf(pieces: readonly PlacedPieces[], kind: FlowerPiece): number {
	return pieces.reduce((sum, { piece, transforms }) => sum + (piece === kind ? transforms.length / TRANSFORM : 0), 0);
}
