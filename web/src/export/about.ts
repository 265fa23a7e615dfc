/** What a file says of where it came from; the model fills it in. */
export interface About {
	/** What the whole plant is called: its model and its preset. */
	name: string;
	/** The address, or the query alone, that brings the specimen back. */
	link: string;
	/** What else there is to know, as JSON: the specimen, counts, measures, fingerprints, whatever the model has. */
	extras: Record<string, unknown>;
}
