import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import { loadCoreFromBytes } from "../../../../web/src/core/loader";
import type { Leaf } from "../../../../web/src/models/leaf/grown";
import { model } from "../../../../web/src/models/leaf/index";
import { bladeFields } from "../../../../web/src/models/leaf/parts/blade_fields";
import { FacePictures } from "../../../../web/src/models/leaf/parts/face_pictures";
import { FAINTEST, SHEATH, veinRaster } from "../../../../web/src/models/leaf/parts/vein_raster";
import { leafFromPreset } from "../../../../web/src/models/leaf/schema";
import type { LeafSpecimen } from "../../../../web/src/models/leaf/specimen";
import { polygonArea } from "../../../../web/src/models/leaf/words";
import { linear } from "../../../../web/src/plant/colour";
import type { Picture } from "../../../../web/src/plant/material";

const SIDE = 256;
const specimen = leafFromPreset("grapevine");
const { length, thickness } = specimen.parameters;
let leaf: Leaf;
beforeAll(async () => {
	const core = await loadCoreFromBytes(await readFile("build/core/particles.wasm"));
	leaf = model.read(core.grow(model.encode(specimen)));
});

const pictures = () => new FacePictures(leaf, length, SIDE);
const withLook = (look: Record<string, number | string>): LeafSpecimen => ({
	...specimen,
	look: { ...specimen.look, uneven: 0, scorch: 0, ...look },
});
const most = (values: Float32Array | Uint8Array) =>
	(values as Float32Array).reduce((one, other) => Math.max(one, other));
const pixel = ({ width, pixels }: Picture, x: number, y: number) => [
	...pixels.subarray(3 * (y * width + x), 3 * (y * width + x) + 3),
];

describe("the flat leaf in cells", () => {
	it("has the margin's inside, and veins as wide as they are", () => {
		const raster = veinRaster(leaf, length, SIDE);
		const { edge } = bladeFields(leaf, length, 1, SIDE);
		const inside = edge.reduce((sum, value) => sum + (value > 0 ? 1 : 0), 0) * raster.cell ** 2;
		expect(inside / (polygonArea(leaf.margin) * length ** 2)).toBeCloseTo(1, 2);
		const { chart, segments } = leaf;
		let veins = 0;
		for (let i = 0; i < segments.count; i++) {
			const piece = Math.hypot(chart[4 * i + 2] - chart[4 * i], chart[4 * i + 3] - chart[4 * i + 1]);
			veins += piece * length * 2 * (1000 * segments.radii[2 * i + 1] + SHEATH);
		}
		const covered = raster.cover.reduce((sum, share) => sum + share, 0) * raster.cell ** 2;
		expect(covered / veins).toBeGreaterThan(0.6);
		expect(covered / veins).toBeLessThan(1.4);
		// The widest vein is half as high as it is wide, where cells are small enough.
		const highest = most(veinRaster(leaf, length, 4 * SIDE).height) / (1000 * most(segments.radii));
		expect(highest).toBeGreaterThan(0.9);
		expect(highest).toBeLessThanOrEqual(1.0001);
	});

	it("has veins of the more of their colour the more energy passes, however wide they are", () => {
		const side = 90;
		// Three vertical veins of equal width, each in the centre of a third of the square.
		const chart = Float32Array.from([1, 3, 5].flatMap((sixth) => [sixth / 6, 0.1, sixth / 6, 0.9]));
		const square = { left: 0, bottom: 0, size: 1 };
		const inks = (energies: number[]) => {
			const segments = { count: 3, radii: new Float32Array(6).fill(0.001) };
			const { ink, cover } = veinRaster({ chart, square, segments, energy: Float32Array.from(energies) }, 90, side);
			return [15, 45, 75].map((x) => ink[45 * side + x] / cover[45 * side + x]);
		};
		const [least, middle, most] = inks([1, 10, 100]);
		expect(most).toBeCloseTo(1, 5);
		expect(middle).toBeCloseTo((1 + FAINTEST) / 2, 5);
		expect(least).toBeCloseTo(FAINTEST, 5);
		expect(inks([4, 4, 4])).toEqual([1, 1, 1]);
		// While particles move, some trails have no energy yet.
		expect(inks([0, 4, 4])[0]).toBeCloseTo(FAINTEST, 5);
		expect(inks([0, 4, 4])[2]).toBeCloseTo(1, 5);
	});

	it("is fed the farther about a vein the wider it is, fading outward", () => {
		const side = 200;
		/** The field along a row across one vertical vein in the centre. */
		const across = (radius: number) => {
			const margin = Float32Array.of(-0.5, 0, 0.5, 0, 0.5, 1, -0.5, 1);
			const segments = { radii: Float32Array.of(radius, radius, 0.001, 0.001) };
			// A second vein far below, the widest one.
			const chart = Float32Array.of(0, 0.3, 0, 1, -0.5, -9, 0.5, -9);
			const one = {
				chart,
				margin,
				square: { left: -0.5, bottom: 0, size: 1 },
				segments: { ...leaf.segments, ...segments },
			};
			const { fed } = bladeFields(one, 100, 1, side);
			return Array.from(fed.subarray(side * 160 + side / 2, side * 161));
		};
		const [wide, thin] = [across(0.001), across(0.0003)];
		expect(wide[0]).toBeGreaterThan(0.98);
		expect(thin[0]).toBeLessThan(0.8);
		for (let i = 1; i < 60; i++) {
			expect(wide[i]).toBeLessThan(wide[i - 1]);
			expect(wide[i - 1] - wide[i]).toBeLessThan(0.1);
			expect(thin[i]).toBeLessThan(wide[i]);
		}
		const reach = (field: number[]) => field.findIndex((value) => value < field[0] / 2);
		expect(reach(wide)).toBeGreaterThan(1.7 * reach(thin));
	});
});

describe("the pictures of a face", () => {
	it("show it tip up, the lower face mirrored, veins raised below and grooved above", () => {
		const faces = pictures();
		const { parameters } = specimen;
		const [above, below] = [faces.normal(parameters, "upper"), faces.normal(parameters, "lower")];
		const { height } = faces.raster;
		const flat = height.findIndex(
			(_, at) =>
				at > SIDE && [at, at - 1, at + 1, at - SIDE, at + SIDE].every((each) => height[each] === 0) && at % SIDE > 1,
		);
		expect(pixel(above, flat % SIDE, SIDE - 1 - Math.floor(flat / SIDE))).toEqual([128, 128, 255]);
		// The steepest slope of a vein has opposite directions above and below.
		for (const channel of [0, 1]) {
			let steepest = { x: 0, y: 0, lean: 0 };
			for (let y = 1; y < SIDE - 1; y++) {
				for (let x = 1; x < SIDE - 1; x++) {
					const lean = pixel(below, x, y)[channel] - 127.5;
					if (lean > steepest.lean) steepest = { x, y, lean };
				}
			}
			expect(steepest.lean).toBeGreaterThan(20);
			const there = pixel(above, SIDE - 1 - steepest.x, steepest.y)[channel];
			// The lower face is mirrored, so its slope to the right is one on the upper face.
			if (channel === 0) expect(there).toBeGreaterThan(128);
			else expect(there).toBeLessThan(127);
		}
		const thick = faces.thickness(parameters, "lower");
		expect(most(thick.pixels)).toBe(255);
		const least = thick.pixels.reduce((one, other) => Math.min(one, other));
		expect(least).toBe(Math.round((255 * thickness) / faces.thickest(parameters)));
	});

	it("are green with paler veins, and each face of its own colour", () => {
		const faces = pictures();
		const summer = withLook({ autumn: 0 });
		const upper = faces.colour(summer, "upper");
		const lower = faces.colour(summer, "lower");
		expect(upper.mean[1]).toBeGreaterThan(1.5 * upper.mean[0]);
		expect(lower.mean[2]).toBeGreaterThan(2 * upper.mean[2]);
		// On the midrib, above the base.
		const on = (picture: Picture) => {
			const [row] = [0.6].map((share) => Math.round(share * SIDE));
			const middle = Array.from({ length: 9 }, (_, i) => pixel(picture, SIDE / 2 - 4 + i, SIDE - 1 - row));
			return Math.max(...middle.map(([red]) => red));
		};
		expect(on(upper.picture)).toBeGreaterThan(upper.picture.pixels[0] + 40);
		const white = faces.colour(withLook({ autumn: 0, vein_colour: "ffffff" }), "upper");
		expect(on(white.picture)).toBeGreaterThan(on(upper.picture) + 20);
	});

	it("are made once, but for colours", () => {
		const faces = pictures();
		expect(faces.normal(specimen.parameters, "upper")).toBe(faces.normal({ ...specimen.parameters }, "upper"));
		expect(faces.raster).toBe(faces.raster);
	});
});

describe("autumn", () => {
	const meanIn = (autumn: number, extra = {}) =>
		pictures().colour(withLook({ autumn, autumn_colour: "d8a020", ...extra }), "upper");
	/** Greenness of a position from its red: 0 for late autumn … 1 for summer. */
	const greenness = (autumn: number) => {
		const [summer, now, late] = [meanIn(0), meanIn(autumn), meanIn(1)].map(({ picture }) => picture);
		return (x: number, y: number) => {
			const [from, at, to] = [late, now, summer].map((picture) => pixel(picture, x, y)[0]);
			return (at - from) / (to - from);
		};
	};

	it("turns all of the blade in the end, none before it begins", () => {
		const turned = linear("d8a020");
		const { mean } = meanIn(1);
		for (const k of [0, 1, 2]) expect(mean[k]).toBeCloseTo(turned[k], 1);
		const fresh = linear(specimen.look.green as string);
		for (const k of [0, 1, 2]) expect(meanIn(0).mean[k]).toBeCloseTo(fresh[k], 1);
	});

	it("takes margins first and main veins last, and fades between", () => {
		const { edge, fed } = bladeFields(leaf, length, specimen.seed, SIDE);
		const green = greenness(0.55);
		const groups = { rim: [] as number[], far: [] as number[], near: [] as number[] };
		const by: number[][] = Array.from({ length: 8 }, () => []);
		for (let at = 0; at < edge.length; at++) {
			if (edge[at] <= 0.01) continue;
			const share = green(at % SIDE, SIDE - 1 - Math.floor(at / SIDE));
			if (edge[at] < 0.04) groups.rim.push(share);
			else if (edge[at] > 0.11) {
				(fed[at] > 0.6 ? groups.near : fed[at] < 0.2 ? groups.far : []).push(share);
				by[Math.min(7, Math.floor(8 * fed[at]))].push(share);
			}
		}
		const mean = (values: number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;
		expect(mean(groups.rim)).toBeLessThan(0.15);
		expect(mean(groups.near)).toBeGreaterThan(mean(groups.far) + 0.4);
		// The colour changes smoothly with the supply by veins.
		const steps = by.filter(({ length: count }) => count > 20).map(mean);
		for (let i = 1; i < steps.length; i++) {
			expect(steps[i]).toBeGreaterThan(steps[i - 1] - 0.02);
			expect(steps[i] - steps[i - 1]).toBeLessThan(0.4);
		}
	});

	it("turns brown as much as requested, margins before the centre", () => {
		const luminance = ({ mean: [red, green, blue] }: { mean: number[] }) => red + green + blue;
		const [none, some, most] = [0, 0.4, 0.9].map((scorch) => meanIn(1, { scorch }));
		expect(luminance(some)).toBeLessThan(0.95 * luminance(none));
		expect(luminance(most)).toBeLessThan(0.8 * luminance(some));
		const { edge } = bladeFields(leaf, length, specimen.seed, SIDE);
		const red = (from: number, to: number) => {
			const reds = [...edge.keys()]
				.filter((at) => edge[at] > from && edge[at] <= to)
				.map((at) => pixel(some.picture, at % SIDE, SIDE - 1 - Math.floor(at / SIDE))[0]);
			return reds.reduce((sum, value) => sum + value, 0) / reds.length;
		};
		expect(red(0, 0.03)).toBeLessThan(red(0.15, 1) - 20);
		expect(luminance(meanIn(0, { scorch: 1 }))).toBeCloseTo(luminance(meanIn(0)), 5);
	});
});
