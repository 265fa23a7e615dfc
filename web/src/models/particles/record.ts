/** The trails in the JSON document, in place of the common record of segments. */
import { shortFloat } from "../../formats/numbers";
import { type CsvRows, floats, integers, recordRows, vectors, words } from "../../formats/rows";
import type { TrailPlant } from "./trails";

type Vector = [x: number, y: number, z: number];

/** A segment of a trail. */
export interface TrailRecord {
	/** Index of the segment nearer to the target, which is less than this one's; −1 at a target. */
	parent: number;
	/** The kind, named as in the model. */
	kind: string;
	/** The end nearer to the target, metres. */
	start: Vector;
	end: Vector;
	/** Energy that flows through. */
	energy: number;
	/** Radius at the start, metres. */
	radius: number;
	radiusEnd: number;
}

/** A target, where trails end. */
export interface TargetRecord {
	x: number;
	y: number;
	z: number;
	/** Energy that has arrived. */
	energy: number;
}

/** Floats of a segment in `ends` (start x y z, end x y z) and in `radii` (at the start, at the end). */
const ENDS = { stride: 6, start: 0, end: 3 } as const;
const RADII = { stride: 2, start: 0, end: 1 } as const;
/** Coordinates of a point. */
const XYZ = 3;

/**
 * Returns the record of a plant for the JSON document. `counts.energy` is the energy that arrived at all targets; the
 * sum is exact where energies are integers.
 */
export function trailRecord(plant: TrailPlant): {
	counts: Record<string, number>;
	segments: CsvRows<TrailRecord>;
	targets: CsvRows<TargetRecord>;
} {
	const { segments, energy, targets, arrived, counts } = plant;
	const { parent, tag, tags, ends, radii } = segments;
	return {
		counts: { ...counts, energy: arrived.reduce((sum, each) => sum + shortFloat(each), 0) },
		segments: recordRows<TrailRecord>(segments.count, {
			parent: integers(parent),
			kind: words(tags, tag),
			start: vectors(ends, ENDS.stride, ENDS.start, XYZ),
			end: vectors(ends, ENDS.stride, ENDS.end, XYZ),
			energy: floats(energy),
			radius: floats(radii, RADII.stride, RADII.start),
			radiusEnd: floats(radii, RADII.stride, RADII.end),
		}),
		targets: recordRows<TargetRecord>(arrived.length, {
			x: floats(targets, XYZ, 0),
			y: floats(targets, XYZ, 1),
			z: floats(targets, XYZ, 2),
			energy: floats(arrived),
		}),
	};
}
