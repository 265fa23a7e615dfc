import type { Part } from "../plant/part";

/** What points of a cloud say of the part that they lie on (ply.ts), by a model's own words. */
export interface PointLabels {
	/** Kinds of parts by their class numbers: names of parts without the numbers behind. Kinds that are not listed follow. */
	readonly classes: readonly string[];
	/** A further property of points, a whole number that some parts have; −1 elsewhere. */
	readonly id: {
		readonly property: string;
		of(part: Pick<Part, "name" | "extras">): number | undefined;
	};
}

/** What a file says of where it came from; the model fills it in. */
export interface About {
	/** What the whole plant is called: its model and its preset. */
	name: string;
	/** The address, or the query alone, that brings the specimen back. */
	link: string;
	/** How points of a cloud are labelled, where the model says so. */
	labels?: PointLabels;
	/** What else there is to know, as JSON: the specimen, counts, measures, fingerprints, whatever the model has. */
	extras: Record<string, unknown>;
}
