/** What the JSON document says of a tree of a growth grammar, besides and in place of what it says of any plant. */
import type { SegmentRecord } from "../../formats/json";
import { floats, integers, type Rows, recordRows, vectors, words } from "../../formats/rows";
import type { GrowthPlant } from "./growth_plant";
import type { GrowthVolume } from "./volumes/volume";

/** A piece of a shoot. */
export interface ShootRecord extends SegmentRecord {
	/** The shoot that it is of. */
	shoot: number;
	/** 0 of a trunk, 1 of a branch that it bears. */
	order: number;
	/** The step at which its shoot came. */
	born: number;
}

export function growthRecord({ segments, shoots, volumes }: GrowthPlant): {
	volumes: readonly GrowthVolume[];
	segments: Rows<ShootRecord>;
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
