/** What the JSON document says of what a text has grown, besides and in place of what it says of any plant. */
import type { OrganRecord, SegmentRecord } from "../../formats/json";
import { shortFloat } from "../../formats/numbers";
import { floats, integers, type Rows, recordRows, vectors, words } from "../../formats/rows";
import type { Area } from "./areas/area";
import type { GrammarPlant } from "./grammar_plant";

/** A line. */
export interface LineRecord extends SegmentRecord {
	/** That drew it: its place in the last string, from 0. */
	module: number;
	/** Of the palette, 1 … 8. */
	colour: number;
	/** The growth area that it belongs to, from 1; 0 for none. Where the text says it. */
	area?: number;
	/** 1: of the main branch; else 0. Where the text says it. */
	main?: number;
}

/** A sphere, a surface, a polygon. */
export interface GrammarOrganRecord extends OrganRecord {
	/** That drew it: its place in the last string, from 0. */
	module: number;
	/** Of the palette, 1 … 8. */
	colour: number;
}

/** A growth area, and what has grown in it. */
export interface AreaRecord extends Pick<Area, "kind" | "centre" | "size" | "rotation"> {
	/** How many belong to it, where the text says it. */
	segments?: number;
	/** m³, where measures were asked for. */
	volume?: number;
	/** Share of its surface that has the base of a leaf within one leaf's length, where measures were asked for. */
	clothed?: number;
}

export interface GrammarRecord {
	/** Length of the last string. */
	modules: number;
	/** Of the derivation. */
	steps: number;
	/** The last string, where it was asked for: it reads back as an axiom. */
	string?: string;
	/** What bounds the branches, metres. */
	areas?: readonly AreaRecord[];
	segments: Rows<LineRecord>;
	organs: Rows<GrammarOrganRecord>;
}

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
