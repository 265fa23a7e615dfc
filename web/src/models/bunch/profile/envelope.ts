/**
 * The envelope of the handles: the region that a bunch of that profile should fill (the bare octahedron would make a
 * cylinder a spindle). Each side is a quarter ellipse from p1 to (w, r), straight to the narrow width at the height of
 * axis rd, constant to the tip and rounded there. For drawing only; the core decides the growth
 * (wasm-core/src/models/bunch/paper/envelope.hpp).
 */
import type { Point } from "../../../ui/handles/point";
import { PROCEDURES } from "../bunch_plant";
import type { BunchSpecimen as Specimen } from "../specimen";
import { SIDE_HANDLES, SIDES, type SideHandle, UNITS_PER_PIXEL, VIEW_SIDES, type View } from "./handles";

type Parameters = Specimen["parameters"];

/** Pixels of the profile per rachis segment, and per segment of a first-order axis (section 4.2, C_l and C_w). */
const PIXELS_PER_SEGMENT = 29;
const PIXELS_PER_AXIS_SEGMENT = 25;
/** First-order axes per pixel of drop (section 4.2, C_r). */
const AXES_PER_PIXEL = 0.056;

/** Angle at which a natural bunch's end structures stick out, degrees, and their twig's length in berry widths. */
const NATURAL_AIM = 60;
const NATURAL_TWIG = 0.35;

/** Points along each quarter ellipse; at 600 pixels across the chord's error is under half a pixel. */
const ARC_STEPS = 12;

/**
 * Returns how far one end structure reaches to the side, in pixels: its internode and pedicel (p7, p8) and the berry.
 */
export function endReach(parameters: Parameters, w: number): number {
	if (w < PIXELS_PER_AXIS_SEGMENT / 2) return w;
	const natural = PROCEDURES[parameters.procedure] === "natural";
	return Math.min(w, natural ? naturalEndReach(parameters) : paperEndReach(parameters, w));
}

/**
 * Returns the reach of an end structure of a natural bunch, pixels: its twig and pedicel at their angle, and the
 * berry's whole width.
 */
function naturalEndReach({ size, pedicel, unit }: Parameters): number {
	return (sine(NATURAL_AIM) * (NATURAL_TWIG * size + pedicel) + size) / (UNITS_PER_PIXEL * unit);
}

/**
 * Returns the reach of an end structure of the paper's procedure, pixels: its internode and pedicel, stretched like all
 * axes of the side to end at its half width, and the largest berry.
 * @param w half width of the side, pixels
 */
function paperEndReach({ li, rrf, re, rp, rmin, rmax, yaw, fit }: Parameters, w: number): number {
	const n = Math.round(w / PIXELS_PER_AXIS_SEGMENT);
	const stretch = 1 + fit * (w / (PIXELS_PER_AXIS_SEGMENT * n) - 1);
	const stalk = li * rrf * re * (1 + rp) * stretch;
	return (stalk * Math.abs(sine(yaw)) + rmin + rmax) / UNITS_PER_PIXEL;
}

/** Returns the half-width of a side as the core fills it, in pixels: a natural bunch is at least one berry thick. */
export function filledWidth(parameters: Parameters, handle: SideHandle): number {
	const w = parameters[`${handle}w`];
	if (PROCEDURES[parameters.procedure] !== "natural") return w;
	return Math.max(w, parameters.size / 2 / (UNITS_PER_PIXEL * parameters.unit));
}

export interface EnvelopeSide {
	/** Half-width and drop of the handle, in pixels. */
	w: number;
	r: number;
	/** Half-width at the tip. */
	narrow: number;
	/** 0 … 3 for p3 … p6: the first axis of this side. */
	first: number;
}

/**
 * Returns one side's envelope from p1 (0, 0) to the tip (0, l), x outward. The drawn r and the height of axis rd are
 * limited to above the tip. rd is not rounded here, so that every pixel counts.
 */
export function sideEnvelope({ w, r, narrow, first }: EnvelopeSide, l: number): Point[] {
	const width = Math.min(narrow, w);
	const shoulder = Math.min(r, l);
	const rounding = Math.min(width, (l - shoulder) / 2);
	const axis = r * AXES_PER_PIXEL + first + 1;
	const waist = Math.min(Math.max(axis * PIXELS_PER_SEGMENT, shoulder), l - rounding);
	const points: Point[] = [];
	for (let step = 0; step <= ARC_STEPS; step++) {
		const angle = (step / ARC_STEPS) * (Math.PI / 2);
		points.push({ x: w * Math.sin(angle), y: shoulder * (1 - Math.cos(angle)) });
	}
	points.push({ x: width, y: waist });
	for (let step = 0; step <= ARC_STEPS; step++) {
		const angle = (step / ARC_STEPS) * (Math.PI / 2);
		points.push({ x: width * Math.cos(angle), y: l - rounding * (1 - Math.sin(angle)) });
	}
	return points;
}

/** Returns both sides of a view as one closed SVG path, in pixels of the profile. */
export function envelopePath(parameters: Parameters, view: View): string {
	const [right, left] = VIEW_SIDES[view].map((handle) => {
		const w = filledWidth(parameters, handle);
		const side = {
			w,
			r: parameters[`${handle}r`],
			narrow: endReach(parameters, w),
			first: SIDE_HANDLES.indexOf(handle),
		};
		const points = sideEnvelope(side, parameters.l);
		return points.map(({ x, y }) => `${(SIDES[handle].sign * x).toFixed(1)} ${y.toFixed(1)}`);
	});
	return `M${[...right, ...left.reverse()].join("L")}Z`;
}

/** Returns the sine of an angle in degrees. */
function sine(degrees: number): number {
	return Math.sin((degrees * Math.PI) / 180);
}
