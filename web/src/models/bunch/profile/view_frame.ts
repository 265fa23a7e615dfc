/** Frame of a view of the profile in its element: visible region, scale and scale bar. */
import { roundLength } from "../../../ui/handles/scale_bar";
import { PROCEDURES } from "../bunch_plant";
import type { BunchSpecimen as Specimen } from "../specimen";
import { type BunchShape, SIDE_HANDLES, UNITS_PER_PIXEL, VIEW_PIXELS } from "./handles";

export interface ViewFrame {
	/** The SVG's viewBox, in pixels of the profile. */
	left: number;
	top: number;
	width: number;
	height: number;
	/** CSS pixels per pixel of the profile. */
	scale: number;
}

/** Margin around the paper's view in CSS pixels, so that handles at its edge are not clipped. */
const MARGIN = 14;

/** Sides of the visible square, in pixels of the profile: the paper's, and less for small bunches. */
const EXTENTS = [150, 200, 250, 300, 400, 500, VIEW_PIXELS];

/** Larger sides, for a seed's bunch longer than the handles allow. */
const LONGER = [720, 860, 1000, 1200];

/** Room for a pedicel beyond the profile, in pixels of the profile. */
const PEDICEL_ROOM = 15;
/** Margin below a side handle, in pixels of the profile. */
const BELOW_SIDE = 20;

/** Parameters that determine a bunch's extent. */
export type Roomy = BunchShape & Pick<Specimen["parameters"], "procedure" | "rmax" | "size" | "unit">;

/** Returns how far pedicel and berry reach beyond the profile's tip and widths, in pixels of the profile. */
function reachBeyond({ procedure, rmax, size, unit }: Roomy): number {
	const berry = PROCEDURES[procedure] === "natural" ? size / unit : 2 * rmax;
	return berry / UNITS_PER_PIXEL + PEDICEL_ROOM;
}

/** Enlarges a shape to contain the seed's own profile. */
export function withRoomFor(shape: Roomy, own: Partial<BunchShape> = {}): Roomy {
	const { l = 0, ...sides } = own;
	const larger = { ...shape, l: Math.max(shape.l, l) };
	for (const side of SIDE_HANDLES) larger[`${side}w`] = Math.max(shape[`${side}w`], sides[`${side}w`] ?? 0);
	return larger;
}

/**
 * Returns the smallest extent with which an element of that size shows the whole bunch. Extents are steps rather than
 * a smooth fit, since rescaling after every drag would distract. Both views of a profile get the same extent if they
 * have one size, so that they are comparable.
 */
export function viewExtent(shape: Roomy, width: number, height: number): number {
	const reach = reachBeyond(shape);
	let neededHeight = shape.l + reach;
	let neededWidth = 0;
	for (const side of SIDE_HANDLES) {
		neededHeight = Math.max(neededHeight, shape[`${side}r`] + BELOW_SIDE);
		neededWidth = Math.max(neededWidth, 2 * (shape[`${side}w`] + reach));
	}
	const fits = (extent: number) => {
		const { scale } = viewFrame(width, height, extent);
		return neededWidth * scale <= width - 2 * MARGIN && neededHeight * scale <= height - 2 * MARGIN;
	};
	return (
		EXTENTS.find(fits) ??
		(shape.l + reach > VIEW_PIXELS ? (LONGER.find(fits) ?? LONGER.at(-1)) : undefined) ??
		VIEW_PIXELS
	);
}

/** Fits a square of `extent` profile pixels into an element of CSS pixels, with p1 at its top centre. */
export function viewFrame(width: number, height: number, extent: number): ViewFrame {
	const scale = Math.max(Math.min(width, height) - 2 * MARGIN, 1) / extent;
	return { left: -width / (2 * scale), top: -MARGIN / scale, width: width / scale, height: height / scale, scale };
}

export interface ScaleBar {
	/** Length in pixels of the profile. */
	length: number;
	/** Label, as "5 cm". */
	label: string;
}

/**
 * Returns a scale bar of the longest round length up to a quarter of the view.
 * @param extent side of the visible square, pixels of the profile
 * @param unit millimetres per unit of the paper
 */
export function scaleBar(extent: number, unit: number): ScaleBar {
	const millimetres = UNITS_PER_PIXEL * unit;
	const length = roundLength((extent / 4) * millimetres);
	const label = length >= 10 ? `${length / 10} cm` : `${length} mm`;
	return { length: length / millimetres, label };
}
