/** Record of a tree in the JSON document, besides and in place of that of every plant. */
import type { SegmentRecord } from "../../formats/json";
import { type CsvRows, floats, integers, recordRows, vectors, words } from "../../formats/rows";
import type { GrowthPlant } from "./growth_plant";
import type { GrowthVolume } from "./volumes/volume";

/** A segment of a shoot. */
export interface ShootRecord extends SegmentRecord {
	/** Shoot of the segment. */
	shoot: number;
	/** Order of the shoot: 0 for a trunk, 1 for a branch of it. */
	order: number;
	/** Step in which the shoot started. */
	born: number;
}

/** Returns the plant for JSON files: its growth volumes and segments. */
export function growthRecord({ segments, shoots, volumes }: GrowthPlant): {
	volumes: readonly GrowthVolume[];
	segments: CsvRows<ShootRecord>;
} {
	return {
		volumes,
		segments: recordRows<ShootRecord>(segments.count, {
			parent: integers(segments.parent),
			kind: words(segments.tags, segments.tag),
			start: vectors(segments.ends, 6, 0, 3),
			end: vectors(segments.ends, 6, 3, 3),
			radius: floats(segments.radii, 2, 0),
			radiusEnd: floats(segments.radii, 2, 1),
			shoot: integers(shoots.shoot),
			order: integers(shoots.order),
			born: integers(shoots.born),
		}),
	};
}
