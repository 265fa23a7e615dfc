/** Levers of a bunch: which parameters change which measure (targets/). */
import { withParameters } from "../../specimen/edit";
import { nearestWithin } from "../../specimen/table";
import { type Lever, type Levers, proportionalLever } from "../../targets/lever";
import type { MeasureKey } from "./measures.generated";
import type { NumberKey } from "./parameters.generated";
import { metresPerPixel, type ShapeKey } from "./profile/handles";
import { BUNCH, procedureOf } from "./schema";
import type { BunchSpecimen } from "./specimen";

type BunchLever = Lever<BunchSpecimen>;

/** Returns a lever that changes parameters in proportion; the measure grows with about this power of them. */
const lever = (power: number, ...keys: NumberKey[]): BunchLever => proportionalLever(BUNCH, power, ...keys);

const HEIGHTS: readonly ShapeKey[] = ["l", "p3r", "p4r", "p5r", "p6r"];
const WIDTHS: readonly ShapeKey[] = ["p3w", "p4w", "p5w", "p6w"];

/**
 * Returns the levers for requested measures. The outline's parameters serve measures of the whole bunch, the berries'
 * parameters those of berries.
 * @param requested measures requested together: parameters that one needs are not used for others
 */
export function leversOf(specimen: BunchSpecimen, requested: readonly string[]): Levers<BunchSpecimen> {
	return procedureOf(specimen) === "paper" ? paperLevers(specimen) : naturalLevers(specimen, requested);
}

/** Levers of the paper's procedure, whose berry radii are in units of the paper and scale with `unit`. */
function paperLevers(specimen: BunchSpecimen): Levers<BunchSpecimen> {
	const radii = [lever(1, "rmax", "rmin")];
	const scale = (power: number) => lever(power, "unit");
	return {
		bunch_length: [lever(1, ...(HEIGHTS as NumberKey[])), scale(1)],
		bunch_width: [lever(1, ...widestFirst(specimen)), scale(1)],
		bunch_weight: [scale(3)],
		diameter: radii,
		berry_width: radii,
		berry_length: radii,
	};
}

/**
 * Returns the levers of natural bunches: for each measure the parameters that change it, which depend on the other
 * measures that are requested.
 */
function naturalLevers(specimen: BunchSpecimen, requested: readonly string[]): Levers<BunchSpecimen> {
	const isRequested = (...keys: MeasureKey[]) => keys.some((key) => requested.includes(key));
	const counted = specimen.parameters.count > 0 || isRequested("berry_count");
	const sized = isRequested("bunch_length", "bunch_width", "hull_volume", "outline_volume");
	const widths = widestFirst(specimen);
	const outline = (power: number) => outlineLever(power, ...HEIGHTS, ...widths);
	const byCloseness = (power: number) => [lever(power, counted ? "count" : "density")];
	// A given count or outline stays fixed: then the berries make up the weight.
	const byDensity = counted || isRequested("density") ? [] : [lever(1, "density")];
	const weight = [...(sized || counted ? [] : [outline(3)]), ...byDensity, lever(3, "size")];
	const size = [lever(1, "size")];
	return {
		bunch_length: [outlineLever(1, ...HEIGHTS)],
		bunch_width: [outlineLever(1, ...widths)],
		bunch_weight: weight,
		berry_volume: weight,
		hull_volume: [outline(3)],
		outline_volume: [outline(3)],
		density: byCloseness(1),
		fill_ratio: byCloseness(0.7),
		compactness: byCloseness(1),
		gap: byCloseness(-2),
		contacts: byCloseness(1),
		berry_count: [lever(1, "count"), ...(sized ? [] : [outline(3)])],
		diameter: size,
		diameter_spread: [lever(1, "spread")],
		berry_width: size,
		berry_length: isRequested("berry_width", "diameter") ? [lever(1, "elongation")] : size,
		berry_weight: [lever(3, "size")],
		pedicel_length: [lever(1, "pedicel")],
		peduncle_length: [lever(1, "peduncle")],
	};
}

/** Returns the half-widths, the widest first, since it has the least range left. */
function widestFirst({ parameters }: BunchSpecimen): ShapeKey[] {
	return [...WIDTHS].sort((one, other) => parameters[other] - parameters[one]);
}

/**
 * Returns a lever that scales lengths of the outline in proportion, measured by the first, in millimetres. Where
 * pixels reach their limit, `unit` grows instead and all other lengths shrink in pixels, so that they keep their size.
 */
function outlineLever(power: number, ...keys: readonly ShapeKey[]): BunchLever {
	const [lead] = keys;
	const [{ min, max }, unit] = [lead, "unit"].map((key) => BUNCH.table.entry(key) as { min: number; max: number });
	const millimetres = ({ parameters }: Pick<BunchSpecimen, "parameters">) => 1000 * metresPerPixel(parameters.unit);
	return {
		power,
		from: Math.max(min, 0.01) * 1000 * metresPerPixel(unit.min),
		to: max * 1000 * metresPerPixel(unit.max),
		of: (specimen) => specimen.parameters[lead] * millimetres(specimen),
		/** Sets the first of these lengths to a value in millimetres, and scales the others of the lever with it. */
		set: (specimen, value) => {
			const { parameters } = specimen;
			const before = parameters.unit;
			const current = parameters[lead] * millimetres(specimen);
			// A length of 0 has no proportion: only the first is set.
			if (!(current > 0)) return withParameters(BUNCH, specimen, { [lead]: value / millimetres(specimen) });
			const factor = value / current;
			const longest = Math.max(...keys.map((key) => (parameters[key] * factor) / limitOf(key)));
			const after = longest > 1 ? roundedUpUnit(before * longest) : before;
			const changes = [...HEIGHTS, ...WIDTHS].map((key) => {
				const pixels = (parameters[key] * before) / after;
				return [key, keys.includes(key) ? factor * pixels : pixels];
			});
			return withParameters(BUNCH, specimen, { ...Object.fromEntries(changes), unit: after });
		},
	};
}

/** Returns the greatest value of a length of the outline, pixels. */
const limitOf = (key: ShapeKey) => (BUNCH.table.entry(key) as { max: number }).max;

/** Returns the least value not below `unit` that a link can store: a multiple of 0.01 within the range. */
function roundedUpUnit(unit: number): number {
	return nearestWithin(BUNCH.table.entry("unit") as Parameters<typeof nearestWithin>[0], Math.ceil(unit * 100) / 100);
}
