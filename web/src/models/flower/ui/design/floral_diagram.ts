/**
 * The floral diagram, a schematic view from above: axis at the top, bract below, keeled sepals, plain crescents for
 * petals, stamens with two lobes, the ovary in cross-section. Angles start at the foot of the diagram and run
 * clockwise.
 */

import type { Point } from "../../../../ui/handles/point";
import { type Description, described } from "../../design/description";
import type { Organ } from "../../design/organs";
import { ringFor, WHORLS } from "../../design/whorl";
import { text } from "../../messages.generated";
import { pathOf, roundPath, type Scene, type SceneHandle, type SceneLine } from "./scene";

type Ringed = "sepal" | "petal" | "stamen";

/** Radius of each whorl's ring, and the range in which the organ's radius moves it. */
const RINGS: Readonly<Record<Ringed, readonly [pointAt: number, room: number]>> = {
	sepal: [86, 12],
	petal: [62, 14],
	stamen: [36, 12],
};
/** Greatest radius of a whorl, millimetres (design/organs.ts). */
const MAX_RADIUS = 25;
/** Distance between two whorls of one organ in the diagram. */
const BETWEEN = 7;
/** The ovary's radius in the diagram: of the thinnest one, and the range up to the widest; and the greatest width, millimetres. */
const OVARY = { least: 8, range: 9, maxWidth: 30 } as const;
const MAX_COUNT = { sepal: 12, petal: 21, stamen: 24, pistil: 16 } as const;

/** Returns the point at an angle and at a distance from the middle. */
const pointAt = (degrees: number, radius: number): Point => {
	const angle = (degrees * Math.PI) / 180;
	return { x: -radius * Math.sin(angle), y: radius * Math.cos(angle) };
};
/** Returns the angle of a point in degrees, 0 … 360 from the foot, clockwise. */
const degreesOf = ({ x, y }: Point): number => ((Math.atan2(-x, y) * 180) / Math.PI + 360) % 360;
/** Returns a number of a description. */
const value = ({ values }: Description, key: string): number => Number(values[key]);

/** Returns the radius of a ring in the diagram; by square roots, so that small radii differ visibly. */
const ringRadius = (organ: Ringed, description: Description): number => {
	const [from, room] = RINGS[organ];
	return from + room * (Math.sqrt(value(description, "radius") / MAX_RADIUS) - 0.5);
};
/** Returns the organ's radius in millimetres for a ring of that radius in the diagram; the inverse of `ringRadius`. */
const radiusAt = (organ: Ringed, ring: number): number => {
	const [from, room] = RINGS[organ];
	return MAX_RADIUS * Math.max(0, (ring - from) / room + 0.5) ** 2;
};

/** Returns the share of a gap between neighbours that an organ fills; organs as wide as long fill all of it. */
const shareOf = (description: Description): number =>
	Math.min(1.3, 0.25 + (0.75 * value(description, "width")) / value(description, "length"));

/**
 * Returns the scene of the diagram.
 * @param chosen organ whose lines are highlighted
 */
export function floralDiagram(descriptions: readonly Description[], chosen?: Organ): Scene {
	const descriptionOf = (organ: Organ) => descriptions.find((each) => each.organ === organ) as Description;
	const ringed = (["sepal", "petal", "stamen"] as const).map((organ) => ringScene(organ, descriptionOf(organ)));
	const ovary = ovaryScene(descriptionOf("pistil"));
	const parts = [...ringed, ovary];
	return {
		box: { left: -100, top: -112, right: 100, bottom: 110 },
		lines: [
			{ d: roundPath({ x: 0, y: -104 }, 4), kind: "around" },
			{ d: `M-26 98Q0 112 26 98Q0 104 -26 98Z`, kind: "around" },
			...parts.flatMap(({ lines, organ }) => lines.map((line) => ({ ...line, chosen: organ === chosen }))),
		],
		// Other organs show only the handle of their count; focusing it selects the organ.
		handles: parts.flatMap(({ handles, organ }) => (organ === chosen ? handles : handles.slice(0, 1))),
	};
}

interface Part {
	readonly organ: Organ;
	readonly lines: readonly SceneLine[];
	readonly handles: readonly SceneHandle[];
}

/** Returns the organs of one kind in the floral diagram, in their rings, with the handle of the ring's radius. */
function ringScene(organ: Ringed, description: Description): Part {
	const [count, whorls] = [value(description, "count"), Number(description.values.whorls ?? 1)];
	const [ring, halfGaps] = [ringRadius(organ, description), organ === "petal" ? 0 : 1];
	const positions = Array.from({ length: whorls }, (_, whorl) => {
		const { sides, faces } = ringFor(count, halfGaps + whorl);
		return faces.map((face) => ({ degrees: (360 * (face - 1)) / sides, radius: ring - BETWEEN * whorl }));
	}).flat();
	const lip = description.values.symmetry === "irregular" ? value(description, "lip") / 100 : 0;
	const lines = positions.map(({ degrees, radius }): SceneLine => {
		const lipFactor = 1 + lip * Math.cos((degrees * Math.PI) / 180);
		const width = (180 / Math.max(count, 3)) * Math.min(1.25, shareOf(description) * lipFactor);
		const fill = String(organ === "stamen" ? description.values.tip : description.values.base);
		const d = organ === "stamen" ? anther(degrees, radius) : crescent(degrees, radius, width, organ === "sepal");
		return { d, kind: "organ", fill };
	});
	const guide: SceneLine = { d: roundPath({ x: 0, y: 0 }, ring), kind: "faint" };
	const first = positions[0]?.degrees ?? 0;
	const handles = [
		...ringHandles(organ, description, ring, first),
		...(count === 0 || organ === "sepal" ? [] : [whorlsHandle(organ, description, ring, first)]),
	];
	return { organ, lines: count === 0 ? [guide] : lines, handles };
}

/** Returns the path of a crescent; a sepal's has a keel. */
function crescent(degrees: number, radius: number, halfAngle: number, keeled: boolean): string {
	const steps = Array.from({ length: 13 }, (_, i) => i / 6 - 1);
	const outer = steps.map((s) =>
		pointAt(degrees + s * halfAngle, radius + (keeled && s === 0 ? 6 : 3.2 * (1 - s * s))),
	);
	const inner = steps.map((s) => pointAt(degrees + s * halfAngle, radius - 2.4 * (1 - s * s))).reverse();
	return pathOf([...outer, ...inner], true);
}

/** Returns the path of an anther in cross-section: two lobes, open inwards. */
function anther(degrees: number, radius: number): string {
	const shares = [-1, -0.6, -0.2, 0, 0.2, 0.6, 1];
	const spread = 420 / Math.max(radius, 14);
	const outer = shares.map((s) => pointAt(degrees + s * spread * 0.6, radius + 4.5 - (s === 0 ? 2.2 : 2 * s * s)));
	const inner = shares
		.map((s) => pointAt(degrees + s * spread * 0.6, radius - 4.5 + (s === 0 ? 3 : 2 * s * s)))
		.reverse();
	return pathOf([...outer, ...inner], true);
}

/**
 * Returns a ring's handles: the count at the second organ's position, the radius outside the first, the width at the
 * first's edge.
 */
function ringHandles(organ: Ringed, description: Description, ring: number, first: number): SceneHandle[] {
	const count = value(description, "count");
	const withValue = (key: string, to: number) => described(description, { [key]: to });
	const gap = count > 0 ? 360 / count : 330;
	const handles: SceneHandle[] = [
		{
			id: `${organ}-count`,
			label: text("handle_count", { organ }),
			value: String(count),
			at: pointAt(first + countAngle(count, gap), ring),
			pull: (to) => withValue("count", countAt((degreesOf(to) - first + 360) % 360, MAX_COUNT[organ])),
			nudge: (right, up, large) => withValue("count", count + (right || up) * (large ? 5 : 1)),
		},
	];
	if (count === 0) return handles;
	const radius = value(description, "radius");
	handles.push({
		id: `${organ}-radius`,
		label: text("handle_radius", { organ }),
		value: text("millimetres", { value: radius }),
		at: pointAt(first, ring + 6),
		pull: ({ x, y }) => withValue("radius", radiusAt(organ, Math.hypot(x, y) - 6)),
		nudge: (right, up, large) => withValue("radius", radius + (right || up) * (large ? 1 : 0.1)),
	});
	if (organ === "stamen") return handles;
	const [width, length] = [value(description, "width"), value(description, "length")];
	// Half of the organ's drawn width, degrees.
	const halfWidth = (180 / Math.max(count, 3)) * shareOf(description);
	handles.push({
		id: `${organ}-width`,
		label: text("handle_width", { organ }),
		value: text("millimetres", { value: width }),
		at: pointAt(first - halfWidth, ring),
		pull: (to) => {
			const share = ((first - degreesOf(to) + 360) % 360) / (180 / Math.max(count, 3));
			return share > 3 ? description : withValue("width", (length * (share - 0.25)) / 0.75);
		},
		nudge: (right, up, large) => withValue("width", width + (right || up) * (large ? 5 : 0.5)),
	});
	return handles;
}

/** Returns the handle on the innermost whorl, away from other handles: dragging it inwards adds whorls. */
function whorlsHandle(organ: Ringed, description: Description, ring: number, first: number): SceneHandle {
	const whorls = value(description, "whorls");
	const set = (to: number) => described(description, { whorls: to });
	return {
		id: `${organ}-whorls`,
		label: text("handle_whorls", { organ }),
		value: String(whorls),
		at: pointAt(first + 225, ring - BETWEEN * (whorls - 1)),
		pull: ({ x, y }) => set(1 + (ring - Math.hypot(x, y)) / BETWEEN),
		nudge: (right, up, large) => set(whorls + (right || up) * (large ? 2 : 1)),
	};
}

/**
 * Returns the count for a handle of the second organ at an angle from the first: full turns by the gap between organs,
 * but 1 from 225, 0 from 300 and the greatest count from 345 degrees on.
 */
function countAt(degrees: number, most: number): number {
	if (degrees > 345) return most;
	if (degrees > 300) return 0;
	return degrees > 225 ? 1 : Math.round(360 / Math.max(degrees, 360 / most));
}

/**
 * Returns the angle of that handle from the first organ, in the middle of the range that `countAt` reads as this count.
 */
function countAngle(count: number, gap: number): number {
	if (count === 0) return 315;
	return count === 1 ? 260 : gap;
}

/**
 * Draws the ovary in cross-section: one wall with chambers for fused carpels, circles around the middle for free ones.
 */
function ovaryScene(description: Description): Part {
	const count = value(description, "count");
	const isApocarpous = description.values.fusion === "apocarpous";
	const size = OVARY.least + (OVARY.range * Math.sqrt(value(description, "width"))) / Math.sqrt(OVARY.maxWidth);
	const fill = String(description.values.base);
	const centres = Array.from({ length: count }, (_, i) =>
		pointAt((360 * i) / count, size * (isApocarpous ? 0.72 : 0.5)),
	);
	const chamberRadius = Math.min(size * 0.3, (size * 1.4) / Math.max(count, 1));
	const chambers = centres.map(
		(centre): SceneLine => ({ d: roundPath(centre, chamberRadius), kind: "organ", ...(isApocarpous && { fill }) }),
	);
	const wall: SceneLine = { d: roundPath({ x: 0, y: 0 }, size), kind: "organ", fill };
	const set = (key: string, to: number) => described(description, { [key]: to });
	const width = value(description, "width");
	return {
		organ: "pistil",
		lines:
			count === 0
				? [{ d: roundPath({ x: 0, y: 0 }, 4), kind: "faint" }]
				: isApocarpous
					? chambers
					: [wall, ...chambers],
		handles: [
			{
				id: "pistil-count",
				label: text("carpel_count"),
				value: String(count),
				at: pointAt(countAngle(count, 360 / Math.max(1, count)), size + 3),
				pull: (to) => set("count", countAt(degreesOf(to), MAX_COUNT.pistil)),
				nudge: (right, up, large) => set("count", count + (right || up) * (large ? 5 : 1)),
			},
			{
				id: "pistil-width",
				label: text("ovary_width"),
				value: text("millimetres", { value: width }),
				at: pointAt(0, size),
				pull: ({ x, y }) =>
					set("width", OVARY.maxWidth * Math.max(0, (Math.hypot(x, y) - OVARY.least) / OVARY.range) ** 2),
				nudge: (right, up, large) => set("width", width + (right || up) * (large ? 2 : 0.1)),
			},
		],
	};
}

/** Returns the floral formula, "K5 C5 A5+5 G3". Without sepals the petals are a perigone, "P3+3". */
export function floralFormula(descriptions: readonly Description[]): string {
	const perigone = descriptions.some(({ organ, values }) => organ === "sepal" && Number(values.count) === 0);
	const letters = { sepal: "K", petal: perigone ? "P" : "C", stamen: "A", pistil: "G" } as const;
	const terms = descriptions.flatMap((description) => {
		if (!Object.hasOwn(WHORLS, description.organ)) return [];
		if (perigone && description.organ === "sepal") return [];
		const count = value(description, "count");
		const whorls = count === 0 ? 1 : Number(description.values.whorls ?? 1);
		const fused = description.values.fusion === "syncarpous" && count > 1;
		const written = Array.from({ length: whorls }, () => String(count)).join("+");
		return [`${letters[description.organ as keyof typeof letters]}${fused ? `(${written})` : written}`];
	});
	const irregular = descriptions.some(({ values }) => values.symmetry === "irregular");
	return `${irregular ? "↓" : "✶"} ${terms.join(" ")}`;
}
