/** What the JSON document says of trails, in place of what it says of any segments. */
import { shortFloat } from "../../formats/numbers";
import { floats, integers, type Rows, recordRows, vectors, words } from "../../formats/rows";
import type { TrailPlant } from "./trails";

type Vector = [x: number, y: number, z: number];

/** A piece of trail. */
export interface TrailRecord {
	/** Index of the piece nearer the target, which comes earlier; −1 at a target. */
	parent: number;
	/** By the model's own names. */
	kind: string;
	/** The end nearer the target; metres. */
	start: Vector;
	end: Vector;
	/** That passes. */
	energy: number;
	/** At the start, metres. */
	radius: number;
	radiusEnd: number;
}

/** Where trails end. */
export interface TargetRecord {
	x: number;
	y: number;
	z: number;
	/** That has arrived. */
	energy: number;
}

/** `counts.energy` is what arrived at all targets, exact where energies are whole. */
export function trailRecord(plant: TrailPlant): {
	counts: Record<string, number>;
	segments: Rows<TrailRecord>;
	targets: Rows<TargetRecord>;
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
