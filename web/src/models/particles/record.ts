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

/** `counts.energy` is the energy that arrived at all targets; the sum is exact where energies are integers. */
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
			start: vectors(ends, 6, 0, 3),
			end: vectors(ends, 6, 3, 3),
			energy: floats(energy),
			radius: floats(radii, 2, 0),
			radiusEnd: floats(radii, 2, 1),
		}),
		targets: recordRows<TargetRecord>(arrived.length, {
			x: floats(targets, 3, 0),
			y: floats(targets, 3, 1),
			z: floats(targets, 3, 2),
			energy: floats(arrived),
		}),
	};
}
