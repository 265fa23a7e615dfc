/** Record of a text's plant in the JSON document, besides and in place of that of every plant. */
import type { OrganRecord, SegmentRecord } from "../../formats/json";
import { shortFloat } from "../../formats/numbers";
import { type CsvRows, floats, integers, recordRows, vectors, words } from "../../formats/rows";
import type { Area } from "./areas/area";
import type { GrammarPlant } from "./grammar_plant";

/** A segment. */
export interface LineRecord extends SegmentRecord {
	/** Module that drew it, by its place in the last string, from 0. */
	module: number;
	/** Colour of the palette, 1 … 8. */
	colour: number;
	/** Growth area that it belongs to, from 1; 0 for none. Present if the text uses areas. */
	area?: number;
	/** 1 for segments of the main branch, else 0. Present if the text uses areas. */
	main?: number;
}

/** An organ: a sphere, a surface or a polygon. */
export interface GrammarOrganRecord extends OrganRecord {
	/** Module that drew it, by its place in the last string, from 0. */
	module: number;
	/** Colour of the palette, 1 … 8. */
	colour: number;
}

/** A growth area, with measures of the branches in it. */
export interface AreaRecord extends Pick<Area, "kind" | "centre" | "size" | "rotation"> {
	/** Number of segments that belong to it, if the text uses areas. */
	segments?: number;
	/** Volume in m³, if measures were requested. */
	volume?: number;
	/** Share of its surface within one leaf's length of a leaf's base, if measures were requested. */
	clothed?: number;
}

export interface GrammarRecord {
	/** Length of the last string. */
	modules: number;
	/** Number of derivation steps. */
	steps: number;
	/** The last string, if requested; it can be parsed as an axiom. */
	string?: string;
	/** Volumes that clip the branches, metres. */
	areas?: readonly AreaRecord[];
	segments: CsvRows<LineRecord>;
	organs: CsvRows<GrammarOrganRecord>;
}

/** Returns the plant for JSON files: areas, segments, organs. */
export function grammarRecord(plant: GrammarPlant): GrammarRecord {
	const { counts, segments, organs, lines, organMarks, belongs, areas, string } = plant;
	return {
		modules: counts.modules,
		steps: counts.steps,
		...(string === undefined ? {} : { string }),
		...(areas ? { areas: areas.map((area, i) => areaRecord(area, i, plant)) } : {}),
		segments: recordRows<LineRecord>(segments.count, {
			parent: integers(segments.parent),
			kind: words(segments.tags, segments.tag),
			start: vectors(segments.ends, 6, 0, 3),
			end: vectors(segments.ends, 6, 3, 3),
			radius: floats(segments.radii, 2, 0),
			radiusEnd: floats(segments.radii, 2, 1),
			module: integers(lines.module),
			colour: integers(lines.colour),
			...(belongs ? { area: integers(belongs.area), main: integers(belongs.main) } : {}),
		}),
		organs: recordRows<GrammarOrganRecord>(organs.count, {
			kind: words(organs.tags, organs.tag),
			segment: integers(organs.segment),
			position: vectors(organs.transforms, 8, 0, 3),
			rotation: vectors(organs.transforms, 8, 3, 4),
			scale: floats(organs.transforms, 8, 7),
			module: integers(organMarks.module),
			colour: integers(organMarks.colour),
		}),
	};
}

/**
 * Returns the record of an area, with its measures where the plant has them.
 * @param i index of the area; segments have that of theirs plus one, and 0 without an area
 */
function areaRecord({ kind, centre, size, rotation }: Area, i: number, plant: GrammarPlant): AreaRecord {
	const { belongs, areaMeasures } = plant;
	return {
		kind,
		centre,
		size,
		rotation,
		...(belongs ? { segments: belongs.area.reduce((sum, area) => sum + (area === i + 1 ? 1 : 0), 0) } : {}),
		...(areaMeasures
			? { volume: shortFloat(areaMeasures.volume[i]), clothed: shortFloat(areaMeasures.clothed[i]) }
			: {}),
	};
}
