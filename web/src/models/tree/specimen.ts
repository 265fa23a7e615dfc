import type { BoundedSpecimen } from "../particles/boundary/bounded";
import type { ColourKey, LookKey, NumberKey } from "./parameters.generated";

/** The document of a tree. */
export interface TreeSpecimen extends BoundedSpecimen {
	/** Every parameter of wasm-core/parameters/tree.json that the core reads, by key. */
	parameters: Record<NumberKey, number>;
	/** Colours as six hexadecimal digits without `#`, the others numbers. */
	look: { [K in LookKey]: K extends ColourKey ? string : number };
}
