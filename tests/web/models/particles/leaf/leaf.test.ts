import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../../../web/src/core/loader";
import { aboutPlant } from "../../../../../web/src/export/about_plant";
import { exportGlb } from "../../../../../web/src/export/glb";
import { exportJson } from "../../../../../web/src/export/json";
import { exportObj } from "../../../../../web/src/export/obj";
import type { GrowthOptions } from "../../../../../web/src/models/model";
import { model } from "../../../../../web/src/models/particles/leaf/index";
import { curveOf } from "../../../../../web/src/models/particles/leaf/outline/spline";
import { leafFromPreset } from "../../../../../web/src/models/particles/leaf/species";
import type { LeafSpecimen } from "../../../../../web/src/models/particles/leaf/specimen";
import { leafSvg } from "../../../../../web/src/models/particles/leaf/svg";
import { polygonArea } from "../../../../../web/src/models/particles/leaf/words";
import { decodeLink, encodeLink } from "../../../../../web/src/specimen/link";
import { complaints } from "../../../export/reading";

let core: Core;
beforeAll(async () => {
	core = await loadCoreFromBytes(await readFile("build/core/particles.wasm"));
});

const names = model.presets.list.map(({ name }) => name);
const grow = (specimen: LeafSpecimen, options?: GrowthOptions) =>
	model.read(core.grow(model.encode(specimen, options)));
const withValues = (name: string, values: Record<string, number>): LeafSpecimen => {
	const leaf = leafFromPreset(name);
	return { ...leaf, parameters: { ...leaf.parameters, ...values } };
};

describe("a grown leaf", () => {
	it.each(names)("%s has veins to which all its particles came, without a note", (name) => {
		const leaf = grow(leafFromPreset(name));
		const { counts, segments, notes, arrived } = leaf;
		expect(notes).toEqual([]);
		expect(arrived.reduce((sum, energy) => sum + energy, 0)).toBe(counts.particles);
		expect(leaf.chart).toHaveLength(4 * segments.count);
		expect(segments.count).toBeGreaterThan(counts.particles);
		expect(leaf.meshes.map((mesh) => mesh.name)).toEqual(expect.arrayContaining(["upper", "lower", "petiole"]));
		for (const [face, { vein, edge }] of Object.entries(leaf.faces)) {
			const vertices = (leaf.meshes.find((mesh) => mesh.name === face)?.positions.length ?? 0) / 3;
			expect([vein.length, edge.length]).toEqual([vertices, vertices]);
		}
	});

	it.each(names)("%s comes back from its link and is the same leaf", async (name) => {
		const specimen = { ...leafFromPreset(name), seed: 7 };
		const { specimen: back, notes } = await decodeLink(model, await encodeLink(model, specimen));
		expect(notes).toEqual([]);
		expect(grow(back, { meshes: false }).fingerprint).toBe(grow(specimen, { meshes: false }).fingerprint);
	});

	it.each(names)("%s has the margin that the editor draws, where there are no teeth", (name) => {
		const specimen = withValues(name, { teeth: 0 });
		const { margin } = grow(specimen, { meshes: false });
		const drawn = Float32Array.from(curveOf(specimen.outline, 24).flatMap(({ x, y }) => [x, y]));
		expect(polygonArea(margin)).toBeCloseTo(polygonArea(drawn), 2);
		let worst = 0;
		for (let at = 0; at < margin.length; at += 2) {
			let near = Number.POSITIVE_INFINITY;
			for (let k = 0; k < drawn.length; k += 2) {
				near = Math.min(near, Math.hypot(margin[at] - drawn[k], margin[at + 1] - drawn[k + 1]));
			}
			worst = Math.max(worst, near);
		}
		expect(worst).toBeLessThan(0.01);
	});

	it("is a draft in passing: fewer triangles, no measures", () => {
		const [whole, draft] = [grow(leafFromPreset("oak")), grow(leafFromPreset("oak"), { passing: true })];
		expect(draft.meshes[0].indices.length).toBeLessThan(whole.meshes[0].indices.length / 2);
		expect(whole.measures).toHaveLength(model.table.measures.length);
		expect(draft.measures).toBeUndefined();
		expect(whole.meshes[0].sky).toBeDefined();
		expect(draft.meshes[0].sky).toBeUndefined();
	});

	it("has all its particles while they are watched, in a coarser blade", () => {
		const young = withValues("oak", { age: 50 });
		const [whole, passing] = [grow(young), grow(young, { passing: true })];
		expect(passing.counts).toEqual(whole.counts);
		expect(passing.fingerprint).toBe(whole.fingerprint);
		expect(passing.meshes[0].indices.length).toBeLessThan(whole.meshes[0].indices.length / 2);
	});

	it("is told in words", () => {
		const oak = leafFromPreset("oak");
		expect(model.words(grow(oak), oak)).toMatch(/^Oak leaf, 4\d cm², 11 cm long, 4\.\d m of veins$/);
		const leaflet = leafFromPreset("strawberry");
		expect(model.words(grow(leaflet), leaflet)).toMatch(/^Strawberry leaflet, /);
		const young = withValues("oak", { age: 40 });
		expect(model.words(grow(young), young)).toMatch(/^Oak leaf, \d+ particles, /);
	});

	it("agrees with what the core measures", () => {
		const lime = leafFromPreset("lime");
		const { measures, margin } = grow(lime);
		const area = measures?.[model.table.measures.findIndex(({ key }) => key === "area")];
		expect(polygonArea(margin) * (lime.parameters.length / 10) ** 2).toBeCloseTo(area ?? 0, 0);
	});
});

describe("files of a leaf", () => {
	const specimen = leafFromPreset("grapevine");

	it("is a GLB to which Khronos' validator has nothing to say, grown or on the way, and an OBJ", async () => {
		for (const each of [specimen, withValues("maple", { age: 35, particles: 200 })]) {
			const leaf = grow(each);
			const about = await aboutPlant(model, leaf, each);
			expect(await complaints(exportGlb(model.parts(leaf, each), about))).toEqual([]);
		}
		const leaf = grow(specimen);
		const { obj } = exportObj(model.parts(leaf, specimen), await aboutPlant(model, leaf, specimen), "leaf");
		expect(obj.match(/^o /gm)).toHaveLength(3);
	});

	it("is JSON with its trails, targets and outline", () => {
		const json = exportJson(model, grow(specimen), specimen);
		expect(json.specimen.outline).toEqual(specimen.outline);
		expect(json.counts).toMatchObject({ energy: json.counts.particles, targets: 5 });
		expect(json.targets).toHaveLength(5);
		expect(json.segments[0]).toMatchObject({ parent: -1, kind: "vein" });
		expect(json.segments.every(({ parent }, index) => parent < index)).toBe(true);
		expect(Object.keys(json.measures)).toContain("vein_density");
	});

	it("is an SVG in millimetres: a closed margin, every vein in one class of widths", () => {
		const leaf = grow(specimen);
		const svg = leafSvg(leaf, specimen, "?v=2&model=leaf");
		expect(svg).toContain("<desc>Panicle");
		expect(svg).toContain("?v=2&amp;model=leaf");
		expect(svg.match(/id="margin"[^>]* d="M[^"]*Z"/)).not.toBeNull();
		const classes = [...svg.matchAll(/<path stroke-width="([\d.]+)" d="([^"]+)"/g)];
		const widths = classes.map(([, width]) => Number(width));
		expect(widths).toEqual([...widths].sort((a, b) => a - b));
		expect(widths.at(-1)).toBeLessThanOrEqual(specimen.parameters.vein + 0.01);
		expect(svg.match(/L/g)?.length).toBeGreaterThanOrEqual(leaf.segments.count);
		const [, width] = /width="([\d.]+)mm"/.exec(svg) ?? [];
		expect(Number(width)).toBeGreaterThan(specimen.parameters.length);
		expect(svg).not.toContain("NaN");
	});

	it("has the colours of its look: veins pale, autumn turned, the lower face its own", () => {
		const leaf = grow(specimen);
		const meanOf = (look: LeafSpecimen["look"], face: number) => {
			const [...parts] = model.parts(leaf, { ...specimen, look });
			const colours = parts[face].shape?.mesh.colours ?? new Float32Array(0);
			return [0, 1, 2].map(
				(k) => colours.filter((_, at) => at % 3 === k).reduce((a, b) => a + b) / (colours.length / 3),
			);
		};
		const [green, turned] = [meanOf(specimen.look, 0), meanOf({ ...specimen.look, autumn: 1 }, 0)];
		expect(green[1]).toBeGreaterThan(1.5 * green[0]);
		expect(turned[0]).toBeGreaterThan(turned[1]);
		expect(meanOf(specimen.look, 1)[2]).toBeGreaterThan(2 * green[2]);
		const pale = meanOf({ ...specimen.look, vein_colour: "ffffff" }, 0);
		expect(pale[2]).toBeGreaterThan(green[2]);
	});
});
