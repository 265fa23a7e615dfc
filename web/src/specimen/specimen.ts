import type { ColourKey, LookKey, NumberKey } from "../models/bunch/parameters.generated";

/** The version of what a link means. A new default is a new version; an old one never changes its meaning. */
export const SPECIMEN_VERSION = 2;

/** The document: plain data, complete (every parameter present). The link is its encoding, undo a list of these. */
export interface Specimen {
	v: 2;
	model: "bunch";
	/** Name of the preset it started from; the link holds only what differs from it. */
	preset: string;
	/** 0 … 4294967295. */
	seed: number;
	/** Every parameter of wasm-core/parameters/bunch.json that the core reads, by key. */
	parameters: Record<NumberKey, number>;
	/** Colours as six hexadecimal digits without `#`, the others numbers. */
	look: Look;
	/** Ids of berries taken off by hand (`Berries.ids`), in the order in which they were. */
	thinned: number[];
	/** The grammar's own inputs, in place of those the profile gives: `n` is n₁ … n₍m−1₎ as the paper counts. */
	inputs?: { m?: number; n?: number[] };
	/** Grammar text in place of the built-in L-system 3. */
	grammar?: string;
}

export type Look = { [K in LookKey]: K extends ColourKey ? string : number };
