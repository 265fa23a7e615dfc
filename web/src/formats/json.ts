/**
 * Any plant as a JSON document: its parts as numbers, for computations. Lengths are metres; each number is the shortest
 * decimal that reads back as the same float32, so that the fingerprint can be computed again from the document
 * (docs/fingerprint.md).
 */
import type { DerivationTrace, TraceEntry } from "../plant/derivation_trace";
import type { Organs, Plant, Segments } from "../plant/plant";
import type { Descriptor } from "../specimen/measures";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";
import { type WrittenSpecimen, writtenSpecimen } from "../specimen/written";
import { classesOf, type WrittenClass } from "./classes";
import { GENERATOR } from "./generator";
import { measuresOf, type WrittenMeasures } from "./measures";
import { CsvRows, floats, integers, recordRows, vectors, words } from "./rows";
import { TextBuffer } from "./text_buffer";

/** A point in metres, +Y up. */
export type FileVector = [x: number, y: number, z: number];

/** A drawn module. */
export interface SegmentRecord {
	/** Index of the parent segment, which comes earlier; −1 at a root. */
	parent: number;
	/** By the model's own names. */
	kind: string;
	/** The start point. */
	start: FileVector;
	/** The end point. */
	end: FileVector;
	/** Radius at the start, metres. */
	radius: number;
	/** Radius at the end, metres. */
	radiusEnd: number;
}

/** An attached organ. */
export interface OrganRecord {
	/** By the model's own names. */
	kind: string;
	/** Index of the segment that it is attached to; −1 for none. */
	segment: number;
	/** The point of attachment. */
	position: FileVector;
	/** Unit quaternion x y z w. */
	rotation: [x: number, y: number, z: number, w: number];
	/** Metres per unit of its mesh. */
	scale: number;
}

/** A derivation, and a window of one of its strings. */
export interface TraceRecord {
	/** Modules in each step's string, from the axiom on. */
	counts: number[];
	/** The traced step. */
	step: number;
	/** Index of the first of `modules` in its string. */
	first: number;
	modules: readonly TraceEntry[];
}

/** The document of every plant; models add to it. */
export interface PlantDocument<S extends Specimen> {
	/** The program that wrote it, with its version: `Panicle 1.2.0`. */
	generator: string;
	specimen: WrittenSpecimen<S>;
	counts: Plant["counts"];
	/** By key; null where one does not apply; empty where the model has no measures or none were requested. */
	measures: WrittenMeasures;
	/**
	 * Classes of descriptors (OIV) by the keys of their measures; absent for models without descriptors, and where
	 * nothing was measured.
	 */
	classes?: Record<string, WrittenClass>;
	/** One per drawn module, unmerged, parents first; absent where nothing was drawn. */
	segments?: SegmentRecord[];
	/** Absent where there are no organs. */
	organs?: OrganRecord[];
	/** The trace of the text's derivation, if requested. */
	chronicle?: TraceRecord;
	notes: string[];
	fingerprint: string;
	timings: Plant["timings"];
}

/** The part of a model that documents need. */
export interface Recorded<S extends Specimen, G extends Plant, R extends object> extends ModelSchema<S> {
	/** Descriptors besides those of its measures. */
	readonly descriptors?: readonly Descriptor<S>[];
	/** Fields of the document besides, or in place of, those of every plant: `CsvRows` for many similar records. */
	record?(grown: G, specimen: S): R;
}

/** CsvRows as the lists of records that a document has. */
export type RecordedRows<R> = {
	[Key in keyof R]: Exclude<R[Key], undefined> extends CsvRows<infer Row> ? Row[] : R[Key];
};

/** The document; `grown` and `specimen` are only read. Needs no meshes. */
export function exportJson<S extends Specimen, G extends Plant, R extends object>(
	model: Recorded<S, G, R>,
	grown: G,
	specimen: S,
): PlantDocument<S> & RecordedRows<R> {
	const entries = Object.entries(contents(model, grown, specimen));
	const made = entries.map(([key, value]) => [key, value instanceof CsvRows ? value.records() : value]);
	return Object.fromEntries(made) as PlantDocument<S> & RecordedRows<R>;
}

/**
 * Returns the document as `JSON.stringify` would write it, in UTF-8, in a third of the time. CsvRows are written one by
 * one, so that the document is in memory once, as text (`TextBuffer.chunks`).
 * @param indent the indentation of each level; all on one line where absent
 * @throws FileTooLargeError where the document exceeds the limit of files (limits.ts)
 */
export function writeJson<S extends Specimen, G extends Plant, R extends object>(
	model: Recorded<S, G, R>,
	grown: G,
	specimen: S,
	indent = "",
): TextBuffer {
	const out = new TextBuffer();
	const [line, colon] = indent ? [`\n${indent}`, ": "] : ["", ":"];
	Object.entries(contents(model, grown, specimen)).forEach(([key, value], place) => {
		out.text(`${place === 0 ? "{" : ","}${line}${JSON.stringify(key)}${colon}`);
		if (!(value instanceof CsvRows)) out.text(indented(value, indent, line));
		else if (indent) writeIndented(out, value, indent);
		else value.write(out);
	});
	out.word(indent ? "\n}" : "}");
	return out;
}

/** Returns the text of a value as `JSON.stringify` writes it, with `line` at the beginning of its further lines. */
function indented(value: unknown, indent: string, line: string): string {
	return JSON.stringify(value, null, indent).replaceAll("\n", line);
}

/** Writes records as a JSON list, each on lines of its own. */
function writeIndented(out: TextBuffer, rows: CsvRows<unknown>, indent: string): void {
	const line = `\n${indent}${indent}`;
	out.word("[");
	for (let index = 0; index < rows.count; index++)
		out.text(`${index > 0 ? "," : ""}${line}${indented(rows.record(index), indent, line)}`);
	out.text(rows.count > 0 ? `\n${indent}]` : "]");
}

/** Returns the fields of the document in order, rows as such. */
function contents<S extends Specimen, G extends Plant, R extends object>(
	model: Recorded<S, G, R>,
	grown: G,
	specimen: S,
): object {
	const { counts, notes, fingerprint, timings } = grown;
	const classes = classesOf(model, grown, specimen);
	return {
		generator: GENERATOR,
		specimen: writtenSpecimen(model, specimen),
		counts,
		measures: {},
		...measuresOf(model.table, grown),
		...(Object.keys(classes).length > 0 ? { classes } : {}),
		...plantRecord(grown),
		...model.record?.(grown, specimen),
		...(grown.trace ? { chronicle: traceRecord(grown.trace) } : {}),
		notes,
		fingerprint,
		timings,
	};
}

/** Returns the trace as documents have it. */
function traceRecord({ counts, step, first, modules }: DerivationTrace): TraceRecord {
	return { counts: [...counts], step, first, modules };
}

/** Returns the segments and organs of a document; without those of which there are none. */
function plantRecord({ segments, organs }: Plant) {
	return {
		...(segments.count > 0 ? { segments: segmentRows(segments) } : {}),
		...(organs.count > 0 ? { organs: organRows(organs) } : {}),
	};
}

/** Returns the segments as records for CSV, one per row: `ends` has 6 values per segment (start, end), `radii` 2. */
function segmentRows({ count, parent, tag, tags, ends, radii }: Segments): CsvRows<SegmentRecord> {
	return recordRows<SegmentRecord>(count, {
		parent: integers(parent),
		kind: words(tags, tag),
		start: vectors(ends, 6, 0, 3),
		end: vectors(ends, 6, 3, 3),
		radius: floats(radii, 2, 0),
		radiusEnd: floats(radii, 2, 1),
	});
}

/** Returns the organs as records: `transforms` has 8 values per organ (position, quaternion, scale). */
function organRows({ count, segment, tag, tags, transforms }: Organs): CsvRows<OrganRecord> {
	return recordRows<OrganRecord>(count, {
		kind: words(tags, tag),
		segment: integers(segment),
		position: vectors(transforms, 8, 0, 3),
		rotation: vectors(transforms, 8, 3, 4),
		scale: floats(transforms, 8, 7),
	});
}
