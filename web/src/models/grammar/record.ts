/** What the JSON document says of what a text has grown, besides and in place of what it says of any plant. */
import type { OrganRecord, SegmentRecord } from "../../export/json";
import { floats, integers, Rows, vectors, words } from "../../export/rows";
import type { GrammarPlant } from "./grammar_plant";

/** A line. */
export interface LineRecord extends SegmentRecord {
	/** That drew it: its place in the last string, from 0. */
	module: number;
	/** Of the palette, 1 … 8. */
	colour: number;
}

/** A sphere, a surface, a polygon. */
export interface BorneRecord extends OrganRecord {
	/** That drew it: its place in the last string, from 0. */
	module: number;
	/** Of the palette, 1 … 8. */
	colour: number;
}

export interface GrammarRecord {
	/** Length of the last string. */
	modules: number;
	/** Of the derivation. */
	steps: number;
	/** The last string, where it was asked for: it reads back as an axiom. */
	string?: string;
	segments: Rows<LineRecord>;
	organs: Rows<BorneRecord>;
}

export function grammarRecord({ counts, segments, organs, lines, borne, string }: GrammarPlant): GrammarRecord {
	return {
		modules: counts.modules,
		steps: counts.steps,
		...(string === undefined ? {} : { string }),
		segments: new Rows<LineRecord>(segments.count, {
			parent: integers(segments.parent),
			kind: words(segments.tags, segments.tag),
			start: vectors(segments.ends, 6, 0, 3),
			end: vectors(segments.ends, 6, 3, 3),
			radius: floats(segments.radii, 2, 0),
			radiusEnd: floats(segments.radii, 2, 1),
			module: integers(lines.module),
			colour: integers(lines.colour),
		}),
		organs: new Rows<BorneRecord>(organs.count, {
			kind: words(organs.tags, organs.tag),
			segment: integers(organs.segment),
			position: vectors(organs.transforms, 8, 0, 3),
			rotation: vectors(organs.transforms, 8, 3, 4),
			scale: floats(organs.transforms, 8, 7),
			module: integers(borne.module),
			colour: integers(borne.colour),
		}),
	};
}
