/** Measures of a bunch that can be targets; levers.ts, loaded on demand, has their levers. */
import type { MeasureKey } from "./measures.generated";
import { procedureOf } from "./schema";
import type { BunchSpecimen } from "./specimen";

const PAPER: readonly MeasureKey[] = [
	"bunch_length",
	"bunch_width",
	"bunch_weight",
	"diameter",
	"berry_length",
	"berry_width",
];

const NATURAL: readonly MeasureKey[] = [
	...PAPER,
	"berry_volume",
	"hull_volume",
	"outline_volume",
	"density",
	"fill_ratio",
	"compactness",
	"gap",
	"contacts",
	"berry_count",
	"diameter_spread",
	"berry_weight",
	"pedicel_length",
	"peduncle_length",
];

export const bunchTargets = {
	measures: (specimen: BunchSpecimen): readonly string[] => (procedureOf(specimen) === "paper" ? PAPER : NATURAL),
	levers: async () => (await import("./levers")).leversOf,
};
