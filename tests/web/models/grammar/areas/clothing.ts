/**
 * Measures for tests of topiaries: how well leaves cover growth areas, and which parts of a plant lie inside its own
 * area.
 */

import { type Area, rotate, type Triple } from "../../../../../web/src/models/grammar/areas/area";
import { surfaceOf } from "../../../../../web/src/models/grammar/areas/surface";
import type { GrammarPlant } from "../../../../../web/src/models/grammar/grammar_plant";

/** Samples an area's surface with even density; where areas overlap, only outside the others. */
export function surfacePlaces(area: Area, count: number): Triple[] {
	const { points, triangles } = surfaceOf(area);
	const corner = (i: number): Triple => [points[3 * i], points[3 * i + 1], points[3 * i + 2]];
	const faces = Array.from({ length: triangles.length / 3 }, (_, t) =>
		[0, 1, 2].map((k) => corner(triangles[3 * t + k])),
	);
	const areas = faces.map(([a, b, c]) => Math.hypot(...cross(minus(b, a), minus(c, a))));
	const whole = areas.reduce((sum, each) => sum + each, 0);
	const places: Triple[] = [];
	let done = 0;
	faces.forEach(([a, b, c], t) => {
		const from = Math.round((done / whole) * count);
		done += areas[t];
		const to = Math.round((done / whole) * count);
		for (let i = from; i < to; i++) {
			// An additive recurrence (Roberts 2018), folded into the triangle.
			let [u, v] = [(0.5 + 0.7548776662 * i) % 1, (0.5 + 0.569840291 * i) % 1];
			if (u + v > 1) [u, v] = [1 - u, 1 - v];
			places.push([0, 1, 2].map((k) => a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k])) as unknown as Triple);
		}
	});
	return places;
}

/** Returns the share of points within reach of a leaf's base. */
export function clothed(places: readonly Triple[], bases: readonly Triple[], reach: number): number {
	const cells = new Map<string, Triple[]>();
	const key = (x: number, y: number, z: number) => `${x},${y},${z}`;
	const cellOf = (at: Triple) => at.map((value) => Math.floor(value / reach)) as [number, number, number];
	for (const base of bases) {
		const name = key(...cellOf(base));
		cells.set(name, [...(cells.get(name) ?? []), base]);
	}
	const near = (at: Triple) => {
		const [x, y, z] = cellOf(at);
		for (let i = 0; i < 27; i++) {
			const inside = cells.get(key(x - 1 + (i % 3), y - 1 + (Math.floor(i / 3) % 3), z - 1 + Math.floor(i / 9)));
			if (inside?.some((base) => Math.hypot(...minus(base, at)) <= reach)) return true;
		}
		return false;
	};
	return places.filter(near).length / places.length;
}

/** Returns whether a point is inside, within single precision: by formula, for meshes by winding number. */
export function holds(area: Area, at: Triple): boolean {
	const [qx, qy, qz, qw] = area.rotation;
	const length = Math.hypot(...area.rotation);
	const back = [-qx / length, -qy / length, -qz / length, qw / length] as const;
	const own = rotate(minus(at, area.centre), back);
	const [x, y, z] = own.map((value, k) => (2 * value) / area.size[k]);
	const round = Math.hypot(x, z);
	const least = 1 + 1e-6;
	if (area.kind === "box") return Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) <= least;
	if (area.kind === "cylinder") return Math.max(round, Math.abs(y)) <= least;
	if (area.kind === "cone") return Math.abs(y) <= least && round <= (least - y) / 2;
	if (area.kind !== "mesh") return Math.hypot(x, y, z) <= least;
	const { points, triangles } = surfaceOf(area);
	// The sum of the solid angles of all triangles (Van Oosterom and Strackee 1983).
	let angle = 0;
	for (let t = 0; t < triangles.length; t += 3) {
		const [a, b, c] = [0, 1, 2].map((k) =>
			minus([0, 1, 2].map((i) => points[3 * triangles[t + k] + i]) as unknown as Triple, at),
		);
		const [la, lb, lc] = [a, b, c].map((each) => Math.hypot(...each));
		const below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
		angle += 2 * Math.atan2(dot(a, cross(b, c)), below);
	}
	return Math.abs(angle) > 2 * Math.PI;
}

/** Returns the bases of all leaves. */
export function leafBases({ organs }: GrammarPlant): Triple[] {
	const leaf = organs.tags.indexOf("elliptic");
	return Array.from({ length: organs.count }, (_, i) => i)
		.filter((i) => organs.tag[i] === leaf)
		.map((i): Triple => [organs.transforms[8 * i], organs.transforms[8 * i + 1], organs.transforms[8 * i + 2]]);
}

/** Returns the shortest and the longest leaf of each area, without those at the foot of the main branch. */
export function leafLengths({ organs, belongs }: GrammarPlant): Map<number, [number, number]> {
	const leaf = organs.tags.indexOf("elliptic");
	const found = new Map<number, [number, number]>();
	for (let i = 0; i < organs.count; i++) {
		if (organs.tag[i] !== leaf) continue;
		const area = belongs?.area[organs.segment[i]] ?? 0;
		if (area === 0) continue;
		const length = organs.transforms[8 * i + 7];
		const [least, most] = found.get(area) ?? [length, length];
		found.set(area, [Math.min(least, length), Math.max(most, length)]);
	}
	return new Map([...found].sort(([a], [b]) => a - b));
}

/** Returns the ends of laterals' terminal segments. */
export function lateralTips({ segments, belongs }: GrammarPlant): { at: Triple; area: number }[] {
	const parents = new Set(segments.parent);
	return Array.from({ length: segments.count }, (_, i) => i)
		.filter((i) => !parents.has(i) && belongs?.main[i] === 0)
		.map((i) => ({
			at: [segments.ends[6 * i + 3], segments.ends[6 * i + 4], segments.ends[6 * i + 5]],
			area: belongs?.area[i] ?? 0,
		}));
}

const dot = (a: Triple, b: Triple): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Triple, b: Triple): Triple => [
	a[1] * b[2] - a[2] * b[1],
	a[2] * b[0] - a[0] * b[2],
	a[0] * b[1] - a[1] * b[0],
];
