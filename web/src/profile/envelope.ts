/**
 * The envelope the handles mean: what a bunch of that profile should fill (the bare octahedron would make a cylinder a
 * spindle). Per side a quarter ellipse from p1 to (w, r), straight to the narrow width at the height of axis rd,
 * constant to the tip and rounded there. Only drawn; the core decides what grows.
 */
import type { Plan, PlanSide } from "../core/grown";
import type { Specimen } from "../specimen/specimen";
import { type Point, SIDE_HANDLES, SIDES, UNITS_PER_PIXEL, VIEW_SIDES, type View } from "./handles";

type Parameters = Specimen["parameters"];
export type DrawnPlan = Pick<Plan, "m" | "sides">;

/** Points along each quarter ellipse; at 600 pixels across the chord's error is under half a pixel. */
const ARC_STEPS = 12;

/** The plan by the formulas of section 4.2 (C_l = 29, C_w = 25, C_r = 0.056), for drawing before the core answers. */
export function drawnPlan(parameters: Parameters): DrawnPlan {
	const m = Math.max(1, Math.round(parameters.l / 29));
	const side = (i: 0 | 1 | 2 | 3): PlanSide => {
		const w = parameters[`${SIDE_HANDLES[i]}w`];
		const r = parameters[`${SIDE_HANDLES[i]}r`];
		return { w, r, n: Math.round(w / 25), rd: Math.min(Math.round(r * 0.056) + i, m - 1) };
	};
	return { m, sides: [side(0), side(1), side(2), side(3)] };
}

/** How far to the side one end structure reaches, in pixels: its internode and pedicel (p7, p8) and the berry. */
export function endReach(parameters: Parameters, { w, n }: Pick<PlanSide, "w" | "n">): number {
	if (n < 1) return w;
	const { li, rrf, re, rp, rmin, rmax, yaw, fit } = parameters;
	const stretch = 1 + fit * (w / (25 * n) - 1);
	const stalk = li * rrf * re * (1 + rp) * stretch;
	const sideways = Math.abs(Math.sin((yaw * Math.PI) / 180));
	return Math.min(w, (stalk * sideways + rmin + rmax) / UNITS_PER_PIXEL);
}

/**
 * One side's envelope from p1 (0, 0) to the tip (0, l), x outward. Where the drawn r or the height of axis rd lies
 * below the tip, it is held above it.
 */
export function sideEnvelope(side: Pick<PlanSide, "w" | "r" | "rd">, l: number, m: number, narrow: number): Point[] {
	const width = Math.min(narrow, side.w);
	const shoulder = Math.min(side.r, l);
	const rounding = Math.min(width, (l - shoulder) / 2);
	const waist = Math.min(Math.max((l * (side.rd + 1)) / m, shoulder), l - rounding);
	const points: Point[] = [];
	for (let step = 0; step <= ARC_STEPS; step++) {
		const angle = (step / ARC_STEPS) * (Math.PI / 2);
		points.push({ x: side.w * Math.sin(angle), y: shoulder * (1 - Math.cos(angle)) });
	}
	points.push({ x: width, y: waist });
	for (let step = 0; step <= ARC_STEPS; step++) {
		const angle = (step / ARC_STEPS) * (Math.PI / 2);
		points.push({ x: width * Math.cos(angle), y: l - rounding * (1 - Math.sin(angle)) });
	}
	return points;
}

/**
 * Both sides of a view as the data of one closed SVG path, in pixels of the profile. The widths, drops and length are
 * the parameters' (what is under the finger now), the counts the plan's (what last grew).
 */
export function envelopePath(parameters: Parameters, view: View, plan: DrawnPlan = drawnPlan(parameters)): string {
	const [right, left] = VIEW_SIDES[view].map((handle) => {
		const { n, rd } = plan.sides[SIDE_HANDLES.indexOf(handle)];
		const w = parameters[`${handle}w`];
		const narrow = endReach(parameters, { w, n });
		const points = sideEnvelope({ w, r: parameters[`${handle}r`], rd }, parameters.l, plan.m, narrow);
		return points.map(({ x, y }) => `${(SIDES[handle].sign * x).toFixed(1)} ${y.toFixed(1)}`);
	});
	return `M${[...right, ...left.reverse()].join("L")}Z`;
}
