import type { Part } from "../plant/part";

/** Labels of points in a point cloud (ply.ts) for the parts that they are on, chosen by the model. */
export interface PointLabels {
	/**
	 * Kinds of parts by class number: names of parts without their trailing numbers. Kinds that are not listed follow.
	 */
	readonly classes: readonly string[];
	/** A further property of points, a whole number that some parts have; −1 elsewhere. */
	readonly id: {
		readonly property: string;
		of(part: Pick<Part, "name" | "extras">): number | undefined;
	};
}

/** The origin of a file, filled in by the model. */
export interface About {
	/** The name of the whole plant: its model and its preset. */
	name: string;
	/** The address, or the query alone, that restores the specimen. */
	link: string;
	/** Labels of points in clouds, if the model has any. */
	labels?: PointLabels;
	/** Further data, as JSON: the specimen, counts, measures, fingerprints and data of the model. */
	extras: Record<string, unknown>;
}
