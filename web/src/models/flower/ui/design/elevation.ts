/**
 * The side elevation of a flower: the middle line of each organ to the right of the axis, in millimetres, up being up.
 */

import type { Point } from "../../../../ui/handles/point";
import { type Description, described } from "../../design/description";
import type { Organ } from "../../design/organs";
import { text } from "../../messages.generated";
import { pathOf, roundPath, type Scene, type SceneHandle, type SceneLine } from "./scene";

const PIECES = 24;
/** Share of the flower's height drawn of the stem, whose length has a slider. */
const STALK = 0.35;
/** Returns a number of a description; 0 where the organ has no such field. */
const value = ({ values }: Description, key: string): number => Number(values[key] ?? 0);
/** Converts radians to degrees. */
const degrees = (radians: number): number => (radians * 180) / Math.PI;
/** Converts degrees to radians. */
const radians = (of: number): number => (of * Math.PI) / 180;

/**
 * Returns the middle line of an organ as PIECES + 1 points.
 * @param rise angle above the horizontal at its start, degrees
 * @param bendAt how much the organ bends outwards at a share of its length, degrees over the whole length
 */
export function lineFrom(from: Point, length: number, rise: number, bendAt: (along: number) => number): Point[] {
	const points = [from];
	let [{ x, y }, angle] = [from, rise];
	for (let i = 0; i < PIECES; i++) {
		angle -= bendAt((i + 0.5) / PIECES) / PIECES;
		x += (length / PIECES) * Math.cos(radians(angle));
		y -= (length / PIECES) * Math.sin(radians(angle));
		points.push({ x, y });
	}
	return points;
}

/**
 * Returns the middle line of a blade, bent like its template: 45, 35 and 20 % of `bend` over the thirds, and `curl`
 * added at the tip.
 */
function bladeLine(description: Description, from: Point): Point[] {
	const [bend, curl] = [value(description, "bend"), value(description, "curl")];
	const [low, middle, high] = [0.45 * bend, 0.35 * bend, 0.2 * bend + curl];
	return lineFrom(
		from,
		value(description, "length"),
		value(description, "angle"),
		(u) => 3 * (low * (1 - u) ** 2 + 2 * middle * u * (1 - u) + high * u * u),
	);
}

/**
 * Returns the scene of the elevation.
 * @param chosen organ whose lines are highlighted
 */
export function elevation(descriptions: readonly Description[], chosen?: Organ): Scene {
	const descriptionOf = (organ: Organ) => descriptions.find((each) => each.organ === organ) as Description;
	const lines: SceneLine[] = [];
	const handles: SceneHandle[] = [];
	const points: Point[] = [{ x: 0, y: 0 }];
	const heights = { sepal: 0, petal: -1.5, stamen: -4 } as const;
	for (const organ of ["sepal", "petal", "stamen"] as const) {
		const description = descriptionOf(organ);
		if (value(description, "count") === 0) continue;
		const from = { x: value(description, "radius"), y: heights[organ] };
		const line =
			organ === "stamen"
				? lineFrom(from, value(description, "length"), value(description, "angle"), () => value(description, "bend"))
				: bladeLine(description, from);
		points.push(...line);
		const mirrored = line.map(({ x, y }) => ({ x: -x, y }));
		lines.push(
			...[line, mirrored].map((each): SceneLine => ({ d: pathOf(each), kind: "organ", chosen: organ === chosen })),
		);
		if (organ === "stamen")
			lines.push({
				d: roundPath(line[PIECES], value(description, "anther") / 4),
				kind: "organ",
				fill: String(description.values.tip),
			});
		const ownHandles = lineHandles(organ, description, line);
		handles.push(...(organ === chosen ? ownHandles : ownHandles.slice(0, 1)));
	}
	pistilScene(descriptionOf("pistil"), chosen, lines, handles, points);
	// The box that the view fits: all organs with some space around, and a piece of the stalk below.
	const halfWidth = Math.max(...points.map(({ x }) => Math.abs(x)), 5) * 1.12;
	const top = Math.min(...points.map(({ y }) => y), -5) * 1.12;
	const lowest = Math.max(...points.map(({ y }) => y), 0);
	const bottom = lowest + STALK * (lowest - top);
	const stemRadius = value(descriptionOf("stem"), "thickness") / 2;
	lines.unshift({
		d: `M${-stemRadius} 0V${bottom}M${stemRadius} 0V${bottom}`,
		kind: "organ",
		chosen: chosen === "stem",
	});
	lines.push({ d: `M0 ${top}V${bottom}`, kind: "axis" });
	return { box: { left: -halfWidth, right: halfWidth, top, bottom }, lines, handles };
}

/** Returns the handles of an organ: its tip sets length and rise, its middle the bend, its foot the whorl's radius. */
function lineHandles(
	organ: "sepal" | "petal" | "stamen",
	description: Description,
	line: readonly Point[],
): SceneHandle[] {
	const withValues = (values: Record<string, number>) => described(description, values);
	const [from, middle, tip] = [line[0], line[PIECES / 2], line[PIECES]];
	const [length, angle, bend] = ["length", "angle", "bend"].map((key) => value(description, key));
	const chord = { x: tip.x - from.x, y: tip.y - from.y };
	const chordLength = Math.hypot(chord.x, chord.y);
	// The rise of a point above the foot, degrees; y runs down, as in SVG.
	const slope = (to: Point) => degrees(Math.atan2(from.y - to.y, to.x - from.x));
	const radius = value(description, "radius");
	return [
		{
			id: `${organ}-tip`,
			label: text("handle_length_rise", { organ }),
			value: text("length_and_angle", { length, angle }),
			at: tip,
			pull: (to) => {
				// The organ turns by as much as the direction to its tip, and lengthens in proportion.
				const distance = Math.hypot(to.x - from.x, to.y - from.y);
				const turn = ((slope(to) - slope(tip) + 540) % 360) - 180;
				return withValues({
					length: chordLength > 0.1 ? (length * distance) / chordLength : distance,
					angle: angle + turn,
				});
			},
			nudge: (right, up, large) =>
				right === 0
					? withValues({ angle: angle + up * (large ? 10 : 1) })
					: withValues({ length: length + right * (large ? 10 : 1) * 0.5 }),
		},
		{
			id: `${organ}-bend`,
			label: text("handle_bend", { organ }),
			value: text("degrees", { value: bend }),
			at: middle,
			// The sagitta of an arc is about an eighth of its length times its angle; inward bends lie below the chord.
			pull: (to) => {
				const offset = (point: Point) =>
					((point.x - from.x) * chord.y - (point.y - from.y) * chord.x) / Math.max(chordLength, 0.1);
				const change = offset(to) - offset(middle);
				return withValues({ bend: bend + degrees((8 * change) / Math.max(length, 1)) });
			},
			nudge: (right, up, large) => withValues({ bend: bend + (right || up) * (large ? 10 : 1) }),
		},
		{
			id: `${organ}-foot`,
			label: text("handle_radius", { organ }),
			value: text("millimetres", { value: radius }),
			at: from,
			pull: ({ x }) => withValues({ radius: x }),
			nudge: (right, up, large) => withValues({ radius: radius + (right || up) * (large ? 1 : 0.1) }),
		},
	];
}

/** Adds the pistils in side view to a scene: ovary, style and stigma, with their handles. */
function pistilScene(
	description: Description,
	chosen: Organ | undefined,
	lines: SceneLine[],
	handles: SceneHandle[],
	points: Point[],
): void {
	if (value(description, "count") === 0) return;
	const [length, width, style, stigma] = ["length", "width", "style", "stigma"].map((key) => value(description, key));
	const foot = -6;
	const [shoulder, tip] = [foot - length, foot - length - style];
	// The right side from the foot up: belly of the ovary, shoulder, style, stigma.
	const side = [
		{ x: 0.35 * width, y: foot },
		{ x: 0.5 * width, y: foot - 0.4 * length },
		{ x: 0.15 * width, y: shoulder },
		{ x: 0.15 * width, y: tip },
		{ x: 0.5 * stigma, y: tip - 0.25 * stigma },
	];
	const mirrored = side.map(({ x, y }) => ({ x: -x, y })).reverse();
	lines.push({
		d: pathOf([...side, ...mirrored], true),
		kind: "organ",
		chosen: chosen === "pistil",
		fill: String(description.values.base),
	});
	points.push(...side);
	const withValue = (key: string, newValue: number) => described(description, { [key]: newValue });
	// A handle for a length that is measured upwards from `below`.
	const heightHandle = (id: string, label: string, key: string, y: number, below: number): SceneHandle => ({
		id,
		label,
		value: text("millimetres", { value: value(description, key) }),
		at: { x: 0, y },
		pull: (newValue) => withValue(key, below - newValue.y),
		nudge: (right, up, large) => withValue(key, value(description, key) + (up || right) * (large ? 5 : 0.5)),
	});
	handles.push(heightHandle("pistil-style", text("style_length"), "style", tip, shoulder));
	if (chosen !== "pistil") return;
	handles.push(heightHandle("pistil-length", text("ovary_length"), "length", shoulder, foot), {
		id: "pistil-width",
		label: text("ovary_width"),
		value: text("millimetres", { value: width }),
		at: { x: width / 2, y: foot - 0.4 * length },
		pull: ({ x }) => withValue("width", 2 * x),
		nudge: (right, up, large) => withValue("width", width + (right || up) * (large ? 2 : 0.1)),
	});
}
