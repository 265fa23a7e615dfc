/**
 * The floral diagram, a schematic view from above: axis at the top, bract below, keeled sepals, plain crescents for
 * petals, stamens with two lobes, the ovary in cross-section. Angles start at the foot of the diagram and run
 * clockwise.
 */
import type { Point } from "../../../../ui/handles/point";
import { type Description, described } from "../../design/description";
import type { Organ } from "../../design/organs";
import { ringFor, WHORLS } from "../../design/whorl";
import { pathOf, roundPath, type Scene, type SceneHandle, type SceneLine } from "./scene";

type Ringed = "sepal" | "petal" | "stamen";

/** Radius of each whorl's ring, and the range in which the organ's radius moves it. */
const RINGS: Readonly<Record<Ringed, readonly [at: number, room: number]>> = {
	sepal: [86, 12],
	petal: [62, 14],
	stamen: [36, 12],
};
const MOST_RADIUS = 25;
const BETWEEN = 7;
const NAMES: Readonly<Record<Organ, string>> = {
	stem: "Stem",
	leaf: "Leaves",
	sepal: "Sepals",
	petal: "Petals",
	stamen: "Stamens",
	pistil: "Carpels",
};

const at = (degrees: number, radius: number): Point => {
	const angle = (degrees * Math.PI) / 180;
	return { x: -radius * Math.sin(angle), y: radius * Math.cos(angle) };
};
/** Returns the angle of a point in degrees, 0 … 360 from the foot, clockwise. */
const degreesOf = ({ x, y }: Point): number => ((Math.atan2(-x, y) * 180) / Math.PI + 360) % 360;
const value = ({ values }: Description, key: string): number => Number(values[key]);

/** Returns the radius of a ring in the diagram; by square roots, so that small radii differ visibly. */
const ringRadius = (organ: Ringed, description: Description): number => {
	const [from, room] = RINGS[organ];
	return from + room * (Math.sqrt(value(description, "radius") / MOST_RADIUS) - 0.5);
};
const radiusAt = (organ: Ringed, ring: number): number => {
	const [from, room] = RINGS[organ];
	return MOST_RADIUS * Math.max(0, (ring - from) / room + 0.5) ** 2;
};

/** Returns the share of a gap between neighbours that an organ fills; organs as wide as long fill all of it. */
const shareOf = (description: Description): number =>
	Math.min(1.3, 0.25 + (0.75 * value(description, "width")) / value(description, "length"));

/**
 * Returns the scene of the diagram.
 * @param chosen organ whose lines are highlighted
 */
export function floralDiagram(descriptions: readonly Description[], chosen?: Organ): Scene {
	const of = (organ: Organ) => descriptions.find((each) => each.organ === organ) as Description;
	const ringed = (["sepal", "petal", "stamen"] as const).map((organ) => ringScene(organ, of(organ)));
	const ovary = ovaryScene(of("pistil"));
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

function ringScene(organ: Ringed, description: Description): Part {
	const [count, whorls] = [value(description, "count"), Number(description.values.whorls ?? 1)];
	const [ring, half] = [ringRadius(organ, description), organ === "petal" ? 0 : 1];
	const places = Array.from({ length: whorls }, (_, whorl) => {
		const { sides, faces } = ringFor(count, half + whorl);
		return faces.map((face) => ({ degrees: (360 * (face - 1)) / sides, radius: ring - BETWEEN * whorl }));
	}).flat();
	const lip = description.values.symmetry === "irregular" ? value(description, "lip") / 100 : 0;
	const lines = places.map(({ degrees, radius }): SceneLine => {
		const larger = 1 + lip * Math.cos((degrees * Math.PI) / 180);
		const width = (180 / Math.max(count, 3)) * Math.min(1.25, shareOf(description) * larger);
		const fill = String(organ === "stamen" ? description.values.tip : description.values.base);
		const d = organ === "stamen" ? anther(degrees, radius) : crescent(degrees, radius, width, organ === "sepal");
		return { d, kind: "organ", fill };
	});
	const guide: SceneLine = { d: roundPath({ x: 0, y: 0 }, ring), kind: "faint" };
	const first = places[0]?.degrees ?? 0;
	const handles = [
		...ringHandles(organ, description, ring, first),
		...(count === 0 || organ === "sepal" ? [] : [whorlsHandle(organ, description, ring, first)]),
	];
	return { organ, lines: count === 0 ? [guide] : lines, handles };
}

/** Returns the path of a crescent; a sepal's has a keel. */
function crescent(degrees: number, radius: number, half: number, keeled: boolean): string {
	const steps = Array.from({ length: 13 }, (_, i) => i / 6 - 1);
	const outer = steps.map((s) => at(degrees + s * half, radius + (keeled && s === 0 ? 6 : 3.2 * (1 - s * s))));
	const inner = steps.map((s) => at(degrees + s * half, radius - 2.4 * (1 - s * s))).reverse();
	return pathOf([...outer, ...inner], true);
}

/** Returns the path of an anther in cross-section: two lobes, open inwards. */
function anther(degrees: number, radius: number): string {
	const around = [-1, -0.6, -0.2, 0, 0.2, 0.6, 1];
	const spread = 420 / Math.max(radius, 14);
	const outer = around.map((s) => at(degrees + s * spread * 0.6, radius + 4.5 - (s === 0 ? 2.2 : 2 * s * s)));
	const inner = around.map((s) => at(degrees + s * spread * 0.6, radius - 4.5 + (s === 0 ? 3 : 2 * s * s))).reverse();
	return pathOf([...outer, ...inner], true);
}

/**
 * Returns a ring's handles: the count at the second organ's position, the radius outside the first, the width at the
 * first's edge.
 */
function ringHandles(organ: Ringed, description: Description, ring: number, first: number): SceneHandle[] {
	const count = value(description, "count");
	const name = NAMES[organ];
	const set = (key: string, to: number) => described(description, { [key]: to });
	const gap = count > 0 ? 360 / count : 330;
	const most = organ === "sepal" ? 12 : organ === "petal" ? 21 : 24;
	// Beyond 300 degrees the count is 1 or 0; below 15 degrees counts could not be distinguished.
	const counted = (to: Point) => {
		const turned = (degreesOf(to) - first + 360) % 360;
		return set(
			"count",
			turned > 345 ? most : turned > 300 ? 0 : turned > 225 ? 1 : Math.round(360 / Math.max(turned, 360 / most)),
		);
	};
	const shown = count === 0 ? 315 : count === 1 ? 260 : gap;
	const handles: SceneHandle[] = [
		{
			id: `${organ}-count`,
			label: `${name}, how many in a whorl`,
			value: String(count),
			at: at(first + shown, ring),
			pull: counted,
			nudge: (right, up, large) => set("count", count + (right || up) * (large ? 5 : 1)),
		},
	];
	if (count === 0) return handles;
	const radius = value(description, "radius");
	handles.push({
		id: `${organ}-radius`,
		label: `${name}, radius of the whorl`,
		value: `${radius} mm`,
		at: at(first, ring + 6),
		pull: ({ x, y }) => set("radius", radiusAt(organ, Math.hypot(x, y) - 6)),
		nudge: (right, up, large) => set("radius", radius + (right || up) * (large ? 1 : 0.1)),
	});
	if (organ === "stamen") return handles;
	const [width, length] = [value(description, "width"), value(description, "length")];
	const half = (180 / Math.max(count, 3)) * shareOf(description);
	handles.push({
		id: `${organ}-width`,
		label: `${name}, width`,
		value: `${width} mm`,
		at: at(first - half, ring),
		pull: (to) => {
			const share = ((first - degreesOf(to) + 360) % 360) / (180 / Math.max(count, 3));
			return share > 3 ? description : set("width", (length * (share - 0.25)) / 0.75);
		},
		nudge: (right, up, large) => set("width", width + (right || up) * (large ? 5 : 0.5)),
	});
	return handles;
}

/** Returns the handle on the innermost whorl, away from other handles: dragging it inwards adds whorls. */
function whorlsHandle(organ: Ringed, description: Description, ring: number, first: number): SceneHandle {
	const whorls = value(description, "whorls");
	const set = (to: number) => described(description, { whorls: to });
	return {
		id: `${organ}-whorls`,
		label: `${NAMES[organ]}, whorls`,
		value: String(whorls),
		at: at(first + 225, ring - BETWEEN * (whorls - 1)),
		pull: ({ x, y }) => set(1 + (ring - Math.hypot(x, y)) / BETWEEN),
		nudge: (right, up, large) => set(whorls + (right || up) * (large ? 2 : 1)),
	};
}

/**
 * Draws the ovary in cross-section: one wall with chambers for fused carpels, circles around the middle for free ones.
 */
function ovaryScene(description: Description): Part {
	const count = value(description, "count");
	const apart = description.values.fusion === "apocarpous";
	const size = 8 + (9 * Math.sqrt(value(description, "width"))) / Math.sqrt(30);
	const fill = String(description.values.base);
	const middles = Array.from({ length: count }, (_, i) => at((360 * i) / count, size * (apart ? 0.72 : 0.5)));
	const room = Math.min(size * 0.3, (size * 1.4) / Math.max(count, 1));
	const rooms = middles.map(
		(middle): SceneLine => ({ d: roundPath(middle, room), kind: "organ", ...(apart && { fill }) }),
	);
	const wall: SceneLine = { d: roundPath({ x: 0, y: 0 }, size), kind: "organ", fill };
	const set = (key: string, to: number) => described(description, { [key]: to });
	const turn = 360 / Math.max(1, count);
	const width = value(description, "width");
	return {
		organ: "pistil",
		lines: count === 0 ? [{ d: roundPath({ x: 0, y: 0 }, 4), kind: "faint" }] : apart ? rooms : [wall, ...rooms],
		handles: [
			{
				id: "pistil-count",
				label: `${NAMES.pistil}, how many`,
				value: String(count),
				at: at(count === 0 ? 315 : count === 1 ? 260 : turn, size + 3),
				pull: (to) => {
					const turned = degreesOf(to);
					return set(
						"count",
						turned > 345 ? 16 : turned > 300 ? 0 : turned > 225 ? 1 : Math.round(360 / Math.max(turned, 22.5)),
					);
				},
				nudge: (right, up, large) => set("count", count + (right || up) * (large ? 5 : 1)),
			},
			{
				id: "pistil-width",
				label: "Ovary, width",
				value: `${width} mm`,
				at: at(0, size),
				pull: ({ x, y }) => set("width", 30 * Math.max(0, (Math.hypot(x, y) - 8) / 9) ** 2),
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
		const times = count === 0 ? 1 : Number(description.values.whorls ?? 1);
		const joined = description.values.fusion === "syncarpous" && count > 1;
		const written = Array.from({ length: times }, () => String(count)).join("+");
		return [`${letters[description.organ as keyof typeof letters]}${joined ? `(${written})` : written}`];
	});
	const irregular = descriptions.some(({ values }) => values.symmetry === "irregular");
	return `${irregular ? "↓" : "✶"} ${terms.join(" ")}`;
}
