/** Characteristics of single presets in the flat leaf; positions in leaf lengths. */
import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../../web/src/core/loader";
import { model } from "../../../../web/src/models/leaf/index";
import { curveOf } from "../../../../web/src/models/leaf/outline/spline";
import { leafFromPreset } from "../../../../web/src/models/leaf/schema";

let core: Core;
beforeAll(async () => {
	core = await loadCoreFromBytes(await readFile("build/core/particles.wasm"));
});

const grow = (name: string) => model.read(core.grow(model.encode(leafFromPreset(name), { meshes: false })));

/** Vein segments of at least a relative width, from below to above: x and y. */
function piecesOf(name: string, least: number) {
	const { chart, segments } = grow(name);
	const widest = segments.radii.reduce((most, radius) => Math.max(most, radius), 0);
	return Array.from({ length: segments.count }, (_, i) => i)
		.filter((i) => segments.radii[2 * i + 1] >= least * widest)
		.map((i) => chart.subarray(4 * i, 4 * i + 4));
}

describe("presets of leaves", () => {
	it("the tulip tree's side veins are few and straight, the lowest run to the lower lobes", () => {
		const sums = { straight: 0, all: 0 };
		const lateral = piecesOf("tulip-tree", 0.12).filter(([, , x]) => Math.abs(x) > 0.05);
		for (const [x1, y1, x2, y2] of lateral) {
			const angle = (Math.atan2(Math.abs(x2) - Math.abs(x1), y2 - y1) * 180) / Math.PI;
			const length = Math.hypot(x2 - x1, y2 - y1);
			sums.all += length;
			if (Math.abs(angle - 62) < 17) sums.straight += length;
		}
		expect(sums.straight / sums.all).toBeGreaterThan(0.95);
		// Their ends are thin.
		const ends = piecesOf("tulip-tree", 0.04);
		for (const side of [-1, 1]) {
			const away = ends.map(([, , x, y]) => Math.hypot(x - side * 0.56, y - 0.236));
			expect(Math.min(...away)).toBeLessThan(0.08);
		}
	});

	it("no great vein of the ivy runs into a bay", () => {
		for (const side of [-1, 1]) {
			const away = piecesOf("ivy", 0.12).map(([, , x, y]) => Math.hypot(x - side * 0.42, y - 0.11));
			expect(Math.min(...away)).toBeGreaterThan(0.07);
		}
	});

	it("a strawberry's leaflet is entire in its lower third, its teeth are blunt", () => {
		const { margin } = grow("strawberry");
		const { outline } = leafFromPreset("strawberry");
		const drawn = curveOf(outline, 100);
		const depths = Array.from({ length: margin.length / 2 }, (_, i) => {
			const [x, y] = margin.subarray(2 * i, 2 * i + 2);
			return { y, depth: Math.min(...drawn.map((place) => Math.hypot(place.x - x, place.y - y))) };
		});
		const deepest = (low: number, high: number) =>
			Math.max(...depths.filter(({ y }) => y > low && y < high).map(({ depth }) => depth));
		expect(deepest(0, 0.3)).toBeLessThan(0.004);
		expect(deepest(0.5, 0.9)).toBeGreaterThan(0.03);
		// The direction changes gradually along a protruding part.
		const turns = depths.map((_, i) => {
			const at = (by: number) => (i + by + depths.length) % depths.length;
			const [ax, ay, bx, by, cx, cy] = [-1, 0, 1].flatMap((k) => [margin[2 * at(k)], margin[2 * at(k) + 1]]);
			const [ux, uy, vx, vy] = [bx - ax, by - ay, cx - bx, cy - by];
			return (Math.atan2(ux * vy - uy * vx, ux * vx + uy * vy) * 180) / Math.PI;
		});
		expect(Math.max(...turns.filter((_, i) => depths[i].y > 0.3 && depths[i].y < 0.95))).toBeLessThan(50);
	});
});
