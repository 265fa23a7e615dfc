/** The version of the meaning of links. A new default is a new version; the meaning of an old one never changes. */
export const SPECIMEN_VERSION = 2;

/**
 * The document: plain data, complete (every parameter of its model's table present). The link is its encoding, undo a
 * list of these. A model adds its fields (model_schema.ts) as properties.
 */
export interface Specimen {
	v: 2;
	/** Name of the model. */
	model: string;
	/** Name of the preset it started from; the link holds only differences from it. */
	preset: string;
	/** 0 … 4294967295. */
	seed: number;
	/** Every parameter of the table that the core reads, by key: numbers, choices by the index of their option. */
	parameters: Record<string, number>;
	/** Values that only colour the result: colours as six hexadecimal digits without `#`, the others numbers. */
	look: Record<string, number | string>;
}
