/**
 * The side elevation of a flower: the middle line of each organ to the right of the axis, in millimetres, up being up.
 */
import type { Point } from "../../../../ui/handles/point";
import { type Description, described } from "../../design/description";
import type { Organ } from "../../design/organs";
import { pathOf, roundPath, type Scene, type SceneHandle, type SceneLine } from "./scene";

const PIECES = 24;
/** Share of the flower's height drawn of the stem, whose length has a slider. */
const STALK = 0.35;
const value = ({ values }: Description, key: string): number => Number(values[key] ?? 0);
const degrees = (radians: number): number => (radians * 180) / Math.PI;
const radians = (of: number): number => (of * Math.PI) / 180;

/**
 * Returns the middle line of an organ that starts at an angle `rise` and bends outwards by `bent`, both in degrees.
 */
export function lineFrom(from: Point, length: number, rise: number, bent: (along: number) => number): Point[] {
	const points = [from];
	let [{ x, y }, angle] = [from, rise];
	for (let i = 0; i < PIECES; i++) {
		angle -= bent((i + 0.5) / PIECES) / PIECES;
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

const LABELS: Readonly<Record<"sepal" | "petal" | "stamen", string>> = {
	sepal: "Sepal",
	petal: "Petal",
	stamen: "Stamen",
};

/**
 * Returns the scene of the elevation.
 * @param chosen organ whose lines are highlighted
 */
export function elevation(descriptions: readonly Description[], chosen?: Organ): Scene {
	const of = (organ: Organ) => descriptions.find((each) => each.organ === organ) as Description;
	const lines: SceneLine[] = [];
	const handles: SceneHandle[] = [];
	const points: Point[] = [{ x: 0, y: 0 }];
	const heights = { sepal: 0, petal: -1.5, stamen: -4 } as const;
	for (const organ of ["sepal", "petal", "stamen"] as const) {
		const description = of(organ);
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
		const own = lineHandles(organ, description, line);
		handles.push(...(organ === chosen ? own : own.slice(0, 1)));
	}
	pistilScene(of("pistil"), chosen, lines, handles, points);
	const across = Math.max(...points.map(({ x }) => Math.abs(x)), 5) * 1.12;
	const top = Math.min(...points.map(({ y }) => y), -5) * 1.12;
	const low = Math.max(...points.map(({ y }) => y), 0);
	const bottom = low + STALK * (low - top);
	const thick = value(of("stem"), "thickness") / 2;
	lines.unshift({ d: `M${-thick} 0V${bottom}M${thick} 0V${bottom}`, kind: "organ", chosen: chosen === "stem" });
	lines.push({ d: `M0 ${top}V${bottom}`, kind: "axis" });
	return { box: { left: -across, right: across, top, bottom }, lines, handles };
}

/** Returns the handles of an organ: its tip sets length and rise, its middle the bend, its foot the whorl's radius. */
function lineHandles(
	organ: "sepal" | "petal" | "stamen",
	description: Description,
	line: readonly Point[],
): SceneHandle[] {
	const name = LABELS[organ];
	const set = (values: Record<string, number>) => described(description, values);
	const [from, middle, tip] = [line[0], line[PIECES / 2], line[PIECES]];
	const [length, angle, bend] = ["length", "angle", "bend"].map((key) => value(description, key));
	const chord = { x: tip.x - from.x, y: tip.y - from.y };
	const reach = Math.hypot(chord.x, chord.y);
	const slope = (to: Point) => degrees(Math.atan2(from.y - to.y, to.x - from.x));
	const radius = value(description, "radius");
	return [
		{
			id: `${organ}-tip`,
			label: `${name}, length and rise`,
			value: `${length} mm, ${angle}°`,
			at: tip,
			pull: (to) => {
				const far = Math.hypot(to.x - from.x, to.y - from.y);
				const turned = ((slope(to) - slope(tip) + 540) % 360) - 180;
				return set({ length: reach > 0.1 ? (length * far) / reach : far, angle: angle + turned });
			},
			nudge: (right, up, large) =>
				right === 0
					? set({ angle: angle + up * (large ? 10 : 1) })
					: set({ length: length + right * (large ? 10 : 1) * 0.5 }),
		},
		{
			id: `${organ}-bend`,
			label: `${name}, bend`,
			value: `${bend}°`,
			at: middle,
			// The sagitta of an arc is about an eighth of its length times its angle; inward bends lie below the chord.
			pull: (to) => {
				const off = (point: Point) =>
					((point.x - from.x) * chord.y - (point.y - from.y) * chord.x) / Math.max(reach, 0.1);
				const more = off(to) - off(middle);
				return set({ bend: bend + degrees((8 * more) / Math.max(length, 1)) });
			},
			nudge: (right, up, large) => set({ bend: bend + (right || up) * (large ? 10 : 1) }),
		},
		{
			id: `${organ}-foot`,
			label: `${name}, radius of the whorl`,
			value: `${radius} mm`,
			at: from,
			pull: ({ x }) => set({ radius: x }),
			nudge: (right, up, large) => set({ radius: radius + (right || up) * (large ? 1 : 0.1) }),
		},
	];
}

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
	const set = (key: string, to: number) => described(description, { [key]: to });
	const upright = (id: string, label: string, key: string, y: number, below: number): SceneHandle => ({
		id,
		label,
		value: `${value(description, key)} mm`,
		at: { x: 0, y },
		pull: (to) => set(key, below - to.y),
		nudge: (right, up, large) => set(key, value(description, key) + (up || right) * (large ? 5 : 0.5)),
	});
	handles.push(upright("pistil-style", "Style, length", "style", tip, shoulder));
	if (chosen !== "pistil") return;
	handles.push(upright("pistil-length", "Ovary, length", "length", shoulder, foot), {
		id: "pistil-width",
		label: "Ovary, width",
		value: `${width} mm`,
		at: { x: width / 2, y: foot - 0.4 * length },
		pull: ({ x }) => set("width", 2 * x),
		nudge: (right, up, large) => set("width", width + (right || up) * (large ? 2 : 0.1)),
	});
}
