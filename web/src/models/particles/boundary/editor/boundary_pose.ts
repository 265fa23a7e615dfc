/** The grips of a boundary, and what moving them does: pure functions from a specimen to a change of it. */
import type { Change } from "../../../../controls/desk";
import type { Point } from "../../../../controls/handles/point";
import type { BoundedSpecimen, Knot } from "../bounded";
import { FEWEST_KNOTS, knotAt, MOST_KNOTS } from "../details/profile";
import { lengthInWords } from "../words";
import { FROM_FRONT } from "./facing";
import { flatPose, sizeOf } from "./flat_pose";
import type { Grip, Pose } from "./grip";
import { type Lay, outlineIn } from "./lay";
import { radiusAt } from "./outline";

/** The least height and width that a drag leaves, metres. */
export const LEAST = 0.02;
/** Nearer to the ground than this share of its size, a dragged target stands on it. */
const GROUND = 0.05;

export function boundaryPose<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, preset: S): Pose {
	const { parameters, profile, obstacles, rounds, targets } = specimen;
	return flatPose(FROM_FRONT, lay, specimen, preset, {
		grips: ownGrips(lay, specimen),
		change: { parameters, details: { profile, obstacles, rounds, targets } },
		pull: (id, to) => pulled(lay, specimen, id, to),
		grounded: (to) => grounded(lay, specimen, to),
		reset: (id) => resetTo(lay, specimen, preset, id),
		remove: (id) => withoutKnot(lay, specimen, id),
		add: (id) => withKnot(lay, specimen, id),
	});
}

/** A hand that drags a target along the ground does not lift it off by a little. */
function grounded<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, { x, y }: Point): Point {
	return { x, y: Math.abs(y) < GROUND * sizeOf(lay, specimen) ? 0 : y };
}

/** The axis that the grips stand at: the last one, where there are several. */
function axisOf<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): number {
	return lay.axes(specimen).at(-1) ?? 0;
}

function ownGrips<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): Grip[] {
	const shape = lay.form(specimen) === "spline" ? knotGrips(lay, specimen) : sizeGrips(lay, specimen);
	return [...shape, innerGrip(lay, specimen), ...distanceGrip(lay, specimen)];
}

function knotGrips<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): Grip[] {
	const { halfWidth, low, high } = lay.box(specimen);
	const axis = axisOf(lay, specimen);
	return knotsOf(lay, specimen).map(([radius, height], i) => {
		const at = { x: axis + radius * halfWidth, y: low + height * (high - low) };
		const value = `${lengthInWords(radius * halfWidth)} out, ${heightInWords(at.y)}`;
		return { id: `knot${i}`, at, label: `Point ${i + 1}`, value };
	});
}

function sizeGrips<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): Grip[] {
	const { halfWidth, low, high } = lay.box(specimen);
	const axis = axisOf(lay, specimen);
	const side = { x: axis + halfWidth, y: low + shoulderOf(lay, specimen) * (high - low) };
	return [
		{ id: "high", at: { x: axis, y: high }, label: lay.ends.high, value: heightInWords(high) },
		{ id: "side", at: side, label: "Width", value: `${lengthInWords(2 * halfWidth)} wide` },
		{ id: "low", at: { x: axis, y: low }, label: lay.ends.low, value: heightInWords(low) },
	];
}

/** At the left of the inner boundary, half way up the outer one. */
function innerGrip<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): Grip {
	const box = lay.box(specimen);
	const { inner } = specimen.parameters;
	const about = lay.bareAbout(box);
	return {
		id: "inner",
		at: {
			x: axisOf(lay, specimen) - inner * waistOf(lay, specimen),
			y: about + inner * ((box.low + box.high) / 2 - about),
		},
		label: "Bare inside",
		value: inner > 0 ? `bare to ${Math.round(100 * inner)} %` : "nothing bare",
	};
}

function distanceGrip<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): Grip[] {
	const x = axisOf(lay, specimen);
	if (!lay.move?.(specimen, x)) return [];
	const { low, high } = lay.box(specimen);
	return [
		{
			id: "axis",
			at: { x, y: low + 0.75 * (high - low) },
			label: "Distance",
			value: `${lengthInWords(specimen.parameters.distance)} apart`,
		},
	];
}

/** How far out the boundary is half way up, metres. */
function waistOf<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): number {
	return lay.box(specimen).halfWidth * Math.max(LEAST, radiusAt(outlineIn(lay, specimen), 0.5));
}

function heightInWords(height: number): string {
	return `${lengthInWords(Math.abs(height))} ${height < 0 ? "below ground" : "up"}`;
}

/** The height at which a boundary is widest, as a share. */
function shoulderOf<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): number {
	const form = lay.form(specimen);
	return form === "cone" ? 0 : form === "bowl" || form === "coneDown" ? 1 : 0.5;
}

export function knotsOf<S extends BoundedSpecimen>(lay: Lay<S>, { profile }: S): readonly Knot[] {
	return profile ?? lay.profile;
}

function pulled<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, id: string, to: Point): Change {
	const box = lay.box(specimen);
	const out = Math.max(LEAST / 2, Math.abs(to.x - axisOf(lay, specimen)));
	if (id === "axis") return { parameters: lay.move?.(specimen, to.x) ?? {} };
	if (id === "inner") return { parameters: { inner: out > LEAST ? out / waistOf(lay, specimen) : 0 } };
	if (id === "side") return { parameters: lay.fit(specimen, { ...box, halfWidth: out }) };
	if (id === "high") return { parameters: lay.fit(specimen, { ...box, high: Math.max(to.y, box.low + LEAST) }) };
	if (id === "low") return { parameters: lay.fit(specimen, { ...box, low: Math.min(to.y, box.high - LEAST) }) };
	return pulledKnot(lay, specimen, Number(id.slice("knot".length)), to);
}

/** The first and the last point carry the box's ends with them; the others stay between their neighbours. */
function pulledKnot<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, index: number, to: Point): Change {
	const box = lay.box(specimen);
	const knots = [...knotsOf(lay, specimen)];
	const last = knots.length - 1;
	const radius = Math.max(0, to.x - axisOf(lay, specimen)) / box.halfWidth;
	const height = (to.y - box.low) / (box.high - box.low);
	const [below, above] = [knots[index - 1]?.[1] ?? 0, knots[index + 1]?.[1] ?? 1];
	knots[index] = knotAt(
		radius,
		index === 0 || index === last ? knots[index][1] : Math.min(Math.max(height, below), above),
	);
	const details = { profile: knots };
	if (index === 0) return { details, parameters: lay.fit(specimen, { ...box, low: Math.min(to.y, box.high - LEAST) }) };
	if (index < last) return { details };
	return { details, parameters: lay.fit(specimen, { ...box, high: Math.max(to.y, box.low + LEAST) }) };
}

function resetTo<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, preset: S, id: string): Change | undefined {
	const before = ownGrips(lay, preset).find((grip) => grip.id === id);
	return before && lay.form(specimen) === lay.form(preset) ? pulled(lay, specimen, id, before.at) : undefined;
}

/** Numbers of a knot's grip; −1 of another. */
function knotIn(id: string): number {
	return id.startsWith("knot") ? Number(id.slice("knot".length)) : -1;
}

/** Takes a point of the profile out; undefined where too few would be left. */
export function withoutKnot<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, id: string): Change | undefined {
	const knots = knotsOf(lay, specimen);
	const index = knotIn(id);
	if (index <= 0 || index >= knots.length - 1 || knots.length <= FEWEST_KNOTS) return undefined;
	return { details: { profile: knots.filter((_, i) => i !== index) } };
}

/** Puts a point between one and the next, on the line. */
export function withKnot<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S, id: string): Change | undefined {
	const knots = knotsOf(lay, specimen);
	const index = Math.min(knotIn(id), knots.length - 2);
	if (index < 0 || knots.length >= MOST_KNOTS) return undefined;
	const height = (knots[index][1] + knots[index + 1][1]) / 2;
	const added = knotAt(radiusAt(outlineIn(lay, specimen), height), height);
	return { details: { profile: [...knots.slice(0, index + 1), added, ...knots.slice(index + 1)] } };
}

/** Heights of the points by which another form is taken over. */
const TAKEN = [0.02, 0.15, 0.4, 0.65, 0.88, 1];

/** The present boundary as a profile to be shaped by hand. */
export function asProfile<S extends BoundedSpecimen>(lay: Lay<S>, specimen: S): Knot[] {
	const outline = outlineIn(lay, specimen);
	return TAKEN.map((height, i) => knotAt(radiusAt(outline, height), i === 0 ? 0 : height));
}
