import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../../web/src/core/core";
import { branchesOf, woodSvg } from "../../../../../web/src/models/particles/boundary/wood_svg";
import type { TrailPlant } from "../../../../../web/src/models/particles/trails";
import { model as root } from "../../../../../web/src/models/root/index";
import { model as tree } from "../../../../../web/src/models/tree/index";
import { fromPreset } from "../../../../../web/src/specimen/from_preset";
import { particlesCore } from "./particles";

/** A trunk 4 m high with two segments; at their fork a twig grows to the front and a thinner one to the back. */
const forked = {
	segments: {
		count: 4,
		ends: Float32Array.from([0, 0, 0, 0, 2, 0, 0, 2, 0, 0, 4, 0, 0, 2, 0, 1, 3, 2, 0, 2, 0, -1, 3, -2]),
		radii: Float32Array.of(0.2, 0.1, 0.1, 0.05, 0.05, 0.02, 0.04, 0.02),
		parent: Int32Array.of(-1, 0, 0, 0),
	},
	energy: Float32Array.of(9, 5, 3, 1),
} as unknown as TrailPlant;

const coordinates = (path: string) =>
	[...path.matchAll(/-?[\d.]+ -?[\d.]+/g)].map(([pair]) => pair.split(" ").map(Number));

describe("wood as SVG", () => {
	it("goes on at a fork where the most energy passes", () => {
		expect(branchesOf(forked)).toEqual([[0, 1], [2], [3]]);
	});

	it("is drawn from in front in millimetres at a round scale, tapering, far ones first and paler", () => {
		const svg = woodSvg(forked, "4 m tall, <bare>", "https://x.test/?a=1&b=2");
		expect(svg).toContain("<title>4 m tall, &lt;bare></title>");
		expect(svg).toContain("1 : 20. ");
		expect(svg).toContain("?a=1&amp;b=2</desc>");
		expect(svg).toContain('width="104mm" height="204mm" viewBox="-52 -202 104 204"');
		const paths = [...svg.matchAll(/<path d="([^"]+)"\/>/g)].map(([, path]) => coordinates(path));
		const tips = paths.map((places) => places[places.length / 2 - 1].map(Math.round));
		expect(tips).toEqual([
			[-49, -151],
			[3, -200],
			[51, -149],
		]);
		const [, trunk] = paths;
		// 40 cm wide at the base, 10 cm at the top.
		expect(Math.abs(trunk[0][0] - trunk[trunk.length - 1][0])).toBeCloseTo(20, 1);
		expect(Math.abs(trunk[2][0] - trunk[3][0])).toBeCloseTo(5, 1);
		// A twig begins at the trunk's surface, not at its axis.
		const [start, end] = [paths[2][0], paths[2][paths[2].length - 1]];
		expect((start[0] + end[0]) / 2).toBeCloseTo((50 * 0.05) / Math.hypot(1, 1, 2), 1);
		const greys = [...svg.matchAll(/fill="#(..)/g)].map(([, value]) => Number.parseInt(value, 16));
		expect(greys).toEqual([...greys].sort((a, b) => b - a));
		expect(greys.at(-1)).toBe(0);
		expect(new Set(greys).size).toBe(3);
	});
});

describe("the models' SVG", () => {
	let core: Core;
	beforeAll(async () => {
		core = await particlesCore();
	});

	it.each([
		[tree, "oak"],
		[root, "tap"],
	] as const)("holds every branch, each within the drawing", async (model, preset) => {
		const published = fromPreset(model as typeof tree, preset);
		const specimen = { ...published, parameters: { ...published.parameters, particles: 200, leaves: 0 } };
		const plant = (model as typeof tree).read(core.grow(model.encode(specimen as never, { meshes: false })), specimen);
		const [format] = (model as typeof tree).formats;
		expect([format.key, format.applies?.(plant)]).toEqual(["svg", true]);
		const svg = (await format.make(plant, specimen, "link")) as string;
		expect(svg).toContain(`<title>${(model as typeof tree).summary(plant)}`);
		const paths = [...svg.matchAll(/<path d="([^"]+)"\/>/g)];
		expect(paths).toHaveLength(branchesOf(plant).length);
		expect(paths.length).toBeGreaterThan(100);
		const [x, y, width, height] = (/viewBox="([^"]+)"/.exec(svg)?.[1] ?? "").split(" ").map(Number);
		const [reach] = [0.1 * Math.max(width, height)];
		for (const [right, down] of paths.flatMap(([, path]) => coordinates(path))) {
			expect(right).toBeGreaterThan(x - reach);
			expect(right).toBeLessThan(x + width + reach);
			expect(down).toBeGreaterThan(y - reach);
			expect(down).toBeLessThan(y + height + reach);
		}
	});
});
