import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../../web/src/core/loader";
import { aboutPlant } from "../../../../web/src/formats/about_plant";
import { exportGlb } from "../../../../web/src/formats/glb";
import { exportJson } from "../../../../web/src/formats/json";
import { exportObj } from "../../../../web/src/formats/obj";
import { png } from "../../../../web/src/formats/png";
import type { Leaf } from "../../../../web/src/models/leaf/grown";
import { model } from "../../../../web/src/models/leaf/index";
import { movePoint } from "../../../../web/src/models/leaf/outline/points";
import { curveOf, enclosesBlade } from "../../../../web/src/models/leaf/outline/spline";
import { leafFromPreset } from "../../../../web/src/models/leaf/schema";
import type { LeafSpecimen } from "../../../../web/src/models/leaf/specimen";
import { leafSvg } from "../../../../web/src/models/leaf/svg";
import { polygonArea } from "../../../../web/src/models/leaf/words";
import type { GrowthOptions } from "../../../../web/src/models/model";
import type { Picture } from "../../../../web/src/plant/material";
import type { PartMesh } from "../../../../web/src/plant/part";
import { decodeLink, encodeLink } from "../../../../web/src/specimen/link";
import { inRun, namesInRun } from "../../../long_run.mjs";
import { documentOf } from "../../formats/reading";

let core: Core;
beforeAll(async () => {
	core = await loadCoreFromBytes(await readFile("build/core/particles.wasm"));
});

/** Presets of the quick check: leaves with lobes, with teeth and with neither. */
const GATE_PRESETS = ["grapevine", "oak", "maple", "willow"];
const names = namesInRun(
	model.presets.list.map(({ name }) => name),
	GATE_PRESETS,
);
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
		for (const [face, { edge }] of Object.entries(leaf.faces)) {
			expect(leaf.meshes.find((mesh) => mesh.name === face)?.positions).toHaveLength(3 * edge.length);
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
		const drawn = Float32Array.from(curveOf(specimen.outline, 100).flatMap(({ x, y }) => [x, y]));
		expect(polygonArea(margin)).toBeCloseTo(polygonArea(drawn), 2);
		let worst = 0;
		for (let at = 0; at < margin.length; at += 2) {
			let near = Number.POSITIVE_INFINITY;
			for (let k = 0; k < drawn.length; k += 2) {
				near = Math.min(near, Math.hypot(margin[at] - drawn[k], margin[at + 1] - drawn[k + 1]));
			}
			worst = Math.max(worst, near);
		}
		expect(worst).toBeLessThan(0.002);
	});

	it.each(["maple", "ivy"])(
		"%s crosses itself on the page where it does in the core, whichever point goes where",
		(name) => {
			const leaf = withValues(name, { particles: 200 });
			const verdicts = Array.from({ length: inRun(20, 60) }, (_, k) => {
				const at = 1 + ((7 * k) % Math.floor(leaf.outline.length / 2 - 1));
				const [{ x, y }, by] = [leaf.outline[at], 0.05 + 0.025 * ((13 * k) % 10)];
				const to = { x: x + by * Math.cos(2.4 * k), y: y + by * Math.sin(2.4 * k) };
				const outline = movePoint(leaf.outline, at, to, { mirror: true });
				const page = enclosesBlade(outline);
				let grown = true;
				try {
					grow({ ...leaf, outline }, { meshes: false, measures: false });
				} catch (error) {
					expect(String(error)).toContain("outline_crosses_itself");
					grown = false;
				}
				return { page, grown };
			});
			expect(verdicts.map(({ page }) => page)).toEqual(verdicts.map(({ grown }) => grown));
			expect(new Set(verdicts.map(({ page }) => page)).size).toBe(2);
		},
	);

	it("is a draft in previews: fewer triangles, no measures", () => {
		const [whole, draft] = [grow(leafFromPreset("oak")), grow(leafFromPreset("oak"), { preview: true })];
		expect(draft.meshes[0].indices.length).toBeLessThan(whole.meshes[0].indices.length / 2);
		expect(whole.measures).toHaveLength(model.table.measures.length);
		expect(draft.measures).toBeUndefined();
		expect(whole.meshes[0].sky).toBeDefined();
		expect(draft.meshes[0].sky).toBeUndefined();
	});

	it("has all its particles while they are watched, in a coarser blade", () => {
		const young = withValues("oak", { age: 50 });
		const [whole, preview] = [grow(young), grow(young, { preview: true })];
		expect(preview.counts).toEqual(whole.counts);
		expect(preview.fingerprint).toBe(whole.fingerprint);
		expect(preview.meshes[0].indices.length).toBeLessThan(whole.meshes[0].indices.length / 2);
	});

	it("is described in words", () => {
		const oak = leafFromPreset("oak");
		expect(model.summary(grow(oak), oak)).toMatch(/^Oak leaf, 4\d cm², 11 cm long, 4\.\d m of veins$/);
		const leaflet = leafFromPreset("strawberry");
		expect(model.summary(grow(leaflet), leaflet)).toMatch(/^Strawberry leaflet, /);
		const young = withValues("oak", { age: 40 });
		expect(model.summary(grow(young), young)).toMatch(/^Oak leaf, [\d,]+ particles, /);
	});

	it("has texture coordinates over the square that the core reports", () => {
		const flat = { curl: 0, fold: 0, undulation: 0 };
		for (const specimen of [withValues("grapevine", flat), withValues("willow", flat)]) {
			const { square, meshes } = grow(specimen);
			const { positions, uvs } = meshes[0];
			const scale = specimen.parameters.length / 1000;
			for (let i = 0; i < uvs.length / 2; i += 37) {
				expect(positions[3 * i] / scale).toBeCloseTo(square.left + square.size * uvs[2 * i], 4);
				expect(positions[3 * i + 1] / scale).toBeCloseTo(square.bottom + square.size * uvs[2 * i + 1], 4);
			}
		}
	});

	it("agrees with the core's measures", () => {
		const lime = leafFromPreset("lime");
		const { measures, margin } = grow(lime);
		const area = measures?.[model.table.measures.findIndex(({ key }) => key === "area")];
		expect(polygonArea(margin) * (lime.parameters.length / 10) ** 2).toBeCloseTo(area ?? 0, 0);
	});
});

/** Total length of a path's subpaths. */
function lengthOf(d: string): number {
	const runs = d.split("M").slice(1);
	return runs.reduce((sum, run) => {
		const places = run.split("L").map((place) => place.split(" ").map(Number));
		const steps = places.slice(1).map(([x, y], i) => Math.hypot(x - places[i][0], y - places[i][1]));
		return sum + steps.reduce((all, step) => all + step, 0);
	}, 0);
}

/** Total length times mean width, square millimetres. */
function veinArea({ chart, segments }: Leaf, millimetres: number): number {
	let sum = 0;
	for (let i = 0; i < segments.count; i++) {
		const length = Math.hypot(chart[4 * i + 2] - chart[4 * i], chart[4 * i + 3] - chart[4 * i + 1]);
		sum += length * millimetres * (segments.radii[2 * i] + segments.radii[2 * i + 1]) * 1000;
	}
	return sum;
}

describe("files of a leaf", () => {
	const specimen = leafFromPreset("grapevine");

	it("is an OBJ with an object for each part", async () => {
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
		// The drawing covers as much area as the veins, and steps along veins are invisible.
		const drawn = classes.reduce((sum, [, width, d]) => sum + Number(width) * lengthOf(d), 0);
		expect(drawn / veinArea(leaf, specimen.parameters.length)).toBeCloseTo(1, 1);
		const main = widths.filter((width) => width > 0.2);
		for (let i = 1; i < main.length; i++) expect(main[i] / main[i - 1]).toBeLessThan(1.25);
		const [, width] = /width="([\d.]+)mm"/.exec(svg) ?? [];
		expect(Number(width)).toBeGreaterThan(specimen.parameters.length);
		const [, height] = /height="([\d.]+)mm"/.exec(svg) ?? [];
		const ys = leaf.margin.filter((_, at) => at % 2 === 1);
		expect(Number(height)).toBeCloseTo((Math.max(...ys) - Math.min(...ys)) * specimen.parameters.length + 4, 1);
		expect(svg).not.toContain("NaN");
	});

	it("has the same textures in GLB and OBJ as in the view, larger ones when it is grown", async () => {
		const sizes = [{ measures: false }, { preview: true }].map((options) =>
			[...model.parts(grow(specimen, options), specimen)].map(({ shape }) => shape?.material.textures?.colour?.width),
		);
		expect(sizes).toEqual([
			[1024, 1024, undefined],
			[256, 256, undefined],
		]);
		const leaf = grow(specimen, { preview: true });
		const parts = [...model.parts(leaf, specimen)];
		const textures = parts.map(({ shape }) => shape?.material.textures);
		expect(parts.map(({ shape }) => shape?.mesh.colours)).toEqual([undefined, undefined, undefined]);
		const about = await aboutPlant(model, leaf, specimen);
		const { obj, mtl, pictures } = exportObj(parts, about, "leaf");
		const wanted = textures.slice(0, 2).flatMap((each) => [each?.colour, each?.normal].map((it) => png(it as Picture)));
		expect(pictures.map(({ bytes }) => bytes).slice(0, wanted.length)).toEqual(wanted);
		expect(pictures.map(({ name }) => name).slice(wanted.length)).toEqual(["leaf-Petiole-colour.png"]);
		for (const each of pictures) expect(mtl).toContain(` ${each.name}\n`);
		expect(obj.match(/^usemtl .*$/gm)).toEqual([
			"usemtl Blade,_upper_face",
			"usemtl Blade,_lower_face",
			"usemtl Petiole",
		]);
		const glb = exportGlb(parts, about);
		const { images = [], bufferViews = [] } = documentOf(glb);
		const embedded = images.map(({ bufferView }) => bufferViews[bufferView]);
		const binary = 28 + new DataView(glb.buffer).getUint32(12, true);
		const bytes = embedded.map(({ byteOffset, byteLength }) =>
			glb.slice(binary + byteOffset, binary + byteOffset + byteLength),
		);
		expect(bytes).toEqual(wanted);
	});

	it("has textures in each face's own orientation, not mirrored", () => {
		const [upper, lower] = [...model.parts(grow(specimen), specimen)].map(({ shape }) => shape?.mesh as PartMesh);
		for (const { positions, normals, uvs, indices } of [upper, lower]) {
			let right = 0;
			for (let at = 0; at < indices.length; at += 3) {
				const [a, b, c] = indices.subarray(at, at + 3);
				const [ux, uy] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]];
				const [vx, vy] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]];
				const turn = ux * vy - uy * vx;
				// The rim has no area in the chart.
				if (Math.abs(turn) > 1e-7) right += turn < 0 ? 1 : -1;
				else right += 1;
			}
			expect(right).toBe(indices.length / 3);
			const top = uvs.findIndex(
				(value, at) => at % 2 === 1 && value === uvs.filter((_, i) => i % 2 === 1).reduce((x, y) => Math.min(x, y)),
			);
			expect(positions[3 * ((top - 1) / 2) + 1]).toBeGreaterThan(0.09);
			expect(normals.length).toBe(positions.length);
		}
	});
});
