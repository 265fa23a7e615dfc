/** The archive of a tree for games, read back piece by piece, and its levels compared by their silhouettes. */
import { unzipSync } from "fflate";
import { validateBytes } from "gltf-validator";
import { beforeAll, describe, expect, it } from "vitest";
import { aboutPlant } from "../../../../web/src/formats/about_plant";
import { gameTree } from "../../../../web/src/formats/game/game_tree";
import { FRAMES, frameDirection } from "../../../../web/src/formats/game/impostor";
import { lowGlb } from "../../../../web/src/formats/low_glb";
import { windGlb } from "../../../../web/src/formats/wind_glb";
import { modelNamed } from "../../../../web/src/models/index";
import { swayOf } from "../../../../web/src/plant/sway";
import type { Wooden } from "../../../../web/src/plant/wood/wooden";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { freshCore } from "../../core/wasm";
import {
	closed,
	coverageOf,
	drawnParts,
	type Frame,
	opaqueArea,
	overlap,
	type Primitive,
	pixelsOf,
	pointOf,
	readLevels,
	trianglesOf,
} from "./reading_levels";

const PIXELS = 128;
const AZIMUTHS = [0, 0.9, 2.1];
/** Gaps of the crown up to a fiftieth of the picture do not count: the outline is compared, and the covered area besides. */
const REACH = 3;

/** By step from one level to the next: of the plant to the first, and so on. */
const LEAST_OUTLINE = [0.94, 0.91, 0.87];
const MOST_AREA = [0.06, 0.08, 0.1];

/** Grows a preset. */
async function grow(preset: string) {
	const model = await modelNamed("growth");
	const specimen = fromPreset(model, preset);
	await model.prepare?.(specimen);
	const core = await freshCore(model.wasm);
	const plant = model.read(core.grow(model.encode(specimen)), specimen) as Wooden;
	const parts = () => [...model.parts(plant, specimen)];
	return { plant, parts, about: await aboutPlant(model, plant, specimen) };
}

let tree: Awaited<ReturnType<typeof grow>>;
let zip: Uint8Array;
let files: Record<string, Uint8Array>;
let levels: ReturnType<typeof readLevels>;
let source: Primitive[];
let wholeArea: number;

/** The area of all leaves: that of one of a kind times the squares of the scales. */
function areaOfSource(): number {
	return tree.parts().reduce((sum, { shape }) => {
		if (!shape?.instances || !shape.material.doubleSided) return sum;
		const one = opaqueArea([
			{
				material: "",
				positions: shape.mesh.positions,
				uvs: [],
				indices: shape.mesh.indices,
				attributes: {},
				cut: undefined,
			},
		]);
		const { transforms } = shape.instances;
		let squares = 0;
		for (let at = 7; at < transforms.length; at += 8) squares += transforms[at] ** 2;
		return sum + one * squares;
	}, 0);
}

/** Coverages of the source in the views, drawn once. */
const drawn = new Map<Primitive[], Float32Array[]>();
const viewsOf = (primitives: Primitive[]) => {
	const known = drawn.get(primitives) ?? frames().map((frame) => coverageOf(primitives, frame));
	drawn.set(primitives, known);
	return known;
};

beforeAll(async () => {
	tree = await grow("oak");
	zip = gameTree(tree.parts(), tree.about, tree.plant);
	files = unzipSync(zip);
	levels = readLevels(files["Oak.glb"]);
	source = drawnParts(tree.parts());
	wholeArea = areaOfSource();
}, 300_000);

/** The views from several sides in which plants are compared. */
function frames(): Frame[] {
	const points = levels.meshes.Oak_LOD0.flatMap((each) => each.attributes.POSITION);
	const [low, high] = [Math.min, Math.max].map((pick) =>
		[0, 1, 2].map((k) => points.reduce((best, point) => pick(best, point[k]), points[0][k])),
	);
	const middle = low.map((value, k) => 0.5 * (value + high[k]));
	const half = 0.6 * Math.max(...low.map((value, k) => high[k] - value));
	return AZIMUTHS.map((azimuth) => ({ azimuth, middle, half, pixels: PIXELS }));
}

/** The least overlap of the outlines, and the greatest difference of the covered areas as a share. */
function compared(one: Primitive[], other: Primitive[]) {
	const [first, second] = [viewsOf(one), viewsOf(other)];
	const views = first.map((view, i) => [view, second[i]] as const);
	const sum = (shares: Float32Array) => shares.reduce((total, share) => total + share, 0);
	return {
		outline: Math.min(...views.map(([a, b]) => overlap(closed(a, PIXELS, REACH), closed(b, PIXELS, REACH)))),
		area: Math.max(...views.map(([a, b]) => Math.abs(sum(b) / sum(a) - 1))),
	};
}

const countOf = (primitives: readonly Primitive[]) =>
	primitives.reduce((sum, { indices }) => sum + indices.length / 3, 0);

/** Of every seventh triangle: the greatest distance of a cut-out triangle from the wood of the same level: of its nearest corner, metres. */
function farthestLeaf(primitives: readonly Primitive[]): number {
	const shares = Array.from({ length: 9 }, (_, i) => i / 8);
	const wood = primitives
		.filter(({ cut }) => !cut)
		.flatMap((primitive) =>
			trianglesOf(primitive).map((corners) => corners.map((corner) => pointOf(primitive, corner))),
		)
		.flatMap(([a, b, c]) => [
			[a, b],
			[b, c],
			[c, a],
		])
		.flatMap(([from, to]) => shares.map((share) => from.map((value, k) => value + share * (to[k] - value))));
	const size = 0.5;
	const cells = new Map<string, number[][]>();
	const keyOf = (point: readonly number[]) => point.map((value) => Math.floor(value / size)).join();
	for (const point of wood) {
		const cell = cells.get(keyOf(point));
		if (cell) cell.push(point);
		else cells.set(keyOf(point), [point]);
	}
	let most = 0;
	for (const primitive of primitives) {
		if (!primitive.cut) continue;
		for (const corners of trianglesOf(primitive).filter((_, i) => i % 7 === 0)) {
			let least = Number.POSITIVE_INFINITY;
			for (const corner of corners.map((vertex) => pointOf(primitive, vertex)))
				for (let x = -1; x <= 1; x++)
					for (let y = -1; y <= 1; y++)
						for (let z = -1; z <= 1; z++)
							for (const point of cells.get(keyOf(corner.map((value, k) => value + size * [x, y, z][k]))) ?? [])
								least = Math.min(least, Math.hypot(...point.map((value, k) => value - corner[k])));
			most = Math.max(most, least);
		}
	}
	return most;
}

describe("the game tree of an oak", () => {
	it("is one archive of at most 1.5 MB, whose GLB has no errors or warnings", async () => {
		expect(zip.length).toBeLessThanOrEqual(1.5e6);
		expect(Object.keys(files).toSorted()).toEqual([
			"Oak.glb",
			"Oak.json",
			"Oak_Impostor.png",
			"Oak_Impostor_Surface.png",
			"README.txt",
		]);
		const { issues } = await validateBytes(files["Oak.glb"], { maxIssues: 0 });
		expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
		expect(levels.json.extensionsRequired).toBeUndefined();
	});

	it("has four levels with ever fewer triangles, each with two draw calls and materials at most", () => {
		const names = Object.keys(levels.meshes).filter((name) => name.includes("LOD"));
		expect(names.toSorted()).toEqual(["Oak_LOD0", "Oak_LOD1", "Oak_LOD2", "Oak_LOD3"]);
		for (const [i, most] of [20_000, 6000, 1500, 16].entries()) {
			const primitives = levels.meshes[`Oak_LOD${i}`];
			expect(countOf(primitives)).toBeLessThanOrEqual(most);
			expect(countOf(primitives)).toBeGreaterThan(0.45 * most);
			expect(primitives.length).toBeLessThanOrEqual(2);
		}
		expect(
			JSON.parse(new TextDecoder().decode(files["Oak.json"])).levels.map(
				({ triangles }: { triangles: number }) => triangles,
			),
		).toEqual([0, 1, 2, 3].map((i) => countOf(levels.meshes[`Oak_LOD${i}`])));
	});

	it("shows the finest level in the first scene, and all levels and the collision body in the second", () => {
		const { scenes, nodes } = levels.json;
		const namesOf = ({ nodes: roots }: { nodes: number[] }) => roots.map((root) => nodes[root].name);
		expect(scenes.map(namesOf)).toEqual([["Oak_LOD0"], ["Oak_LOD0", "Oak_LOD1", "Oak_LOD2", "Oak_LOD3", "UCX_Oak_00"]]);
		const [first] = scenes[0].nodes;
		expect(nodes[first].extensions.MSFT_lod.ids.map((id: number) => nodes[id].name)).toEqual([
			"Oak_LOD1",
			"Oak_LOD2",
			"Oak_LOD3",
		]);
	});

	it("has the outline of the plant in its finest level, and each level has that of the one before", () => {
		const steps = [source, levels.meshes.Oak_LOD0, levels.meshes.Oak_LOD1, levels.meshes.Oak_LOD2];
		for (let i = 1; i < steps.length; i++) {
			const { outline, area } = compared(steps[i - 1], steps[i]);
			expect(outline).toBeGreaterThan(LEAST_OUTLINE[i - 1]);
			expect(area).toBeLessThan(MOST_AREA[i - 1]);
		}
	}, 300_000);

	it("keeps the area of leaves, each attached to wood", () => {
		const leavesOf = (primitives: readonly Primitive[]) =>
			primitives.filter(({ material }) => /lea(f|ves)/i.test(material));
		const finest = opaqueArea(leavesOf(levels.meshes.Oak_LOD0));
		expect(finest / wholeArea).toBeGreaterThan(0.75);
		expect(farthestLeaf(levels.meshes.Oak_LOD0)).toBeLessThan(0.45);
	}, 300_000);

	it("has an octahedral impostor of at most 64 kB, that covers what the second level covers in frames of the horizon", () => {
		const [colour, surface] = ["Oak_Impostor.png", "Oak_Impostor_Surface.png"].map((name) => files[name]);
		expect(colour.length + surface.length).toBeLessThanOrEqual(64_000);
		const [shown, normals] = [pixelsOf(colour), pixelsOf(surface)];
		expect([shown.channels, normals.channels, normals.width]).toEqual([4, 3, shown.width]);
		const { impostor } = JSON.parse(new TextDecoder().decode(files["Oak.json"]));
		const edge = impostor.framePixels;
		for (let column = 0; column < FRAMES; column += 3) {
			const [x, y, z] = frameDirection(column, 0);
			expect(y).toBeCloseTo(0, 6);
			const frame = { azimuth: Math.atan2(x, z), middle: impostor.middle, half: impostor.radius, pixels: edge };
			const real = coverageOf(levels.meshes.Oak_LOD1, frame);
			const own = real.map(
				(_, i) => shown.pixels[4 * (shown.width * Math.floor(i / edge) + edge * column + (i % edge)) + 3] / 255,
			);
			const [least, most] = [Math.min, Math.max].map((pick) =>
				real.reduce((sum, share, i) => sum + pick(share, own[i]), 0),
			);
			expect(least / most).toBeGreaterThan(0.75);
		}
	}, 300_000);

	it("holds wind data in second vertex colours, or in the first ones by choice, and pivots inside the box", () => {
		for (const { attributes, cut } of levels.meshes.Oak_LOD0) {
			const wind = attributes.COLOR_1;
			const weights = wind.map(([, weight]) => weight);
			expect(Math.max(...weights.slice(0, 50_000))).toBeGreaterThan(0.5);
			if (!cut) expect(weights[0]).toBe(0);
			expect(new Set(wind.map(([, , phase]) => phase)).size).toBeGreaterThanOrEqual(cut ? 100 : 1);
			expect(attributes.TEXCOORD_1.every(([u, v]) => u >= 0 && u <= 1 && v >= 0 && v <= 1)).toBe(true);
		}
		const chosen = readLevels(unzipSync(gameTree(tree.parts(), tree.about, tree.plant, true))["Oak.glb"]);
		expect(chosen.meshes.Oak_LOD0[0].attributes.COLOR_1).toBeUndefined();
		expect(chosen.meshes.Oak_LOD0[0].attributes.COLOR_0).toEqual(levels.meshes.Oak_LOD0[0].attributes.COLOR_1);
	}, 300_000);

	it("has a convex body for collisions that holds the trunk", () => {
		const [hull] = levels.meshes.UCX_Oak_00;
		const positions = hull.attributes.POSITION;
		const planes = trianglesOf(hull).map(([a, b, c]) => {
			const [u, v] = [b, c].map((corner) => positions[corner].map((value, k) => value - positions[a][k]));
			return {
				normal: [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]],
				point: positions[a],
			};
		});
		const isInside = (point: readonly number[], slack: number) =>
			planes.every(
				({ normal, point: on }) => normal.reduce((sum, value, k) => sum + value * (point[k] - on[k]), 0) <= slack,
			);
		expect(positions.every((corner) => isInside(corner, 1e-3))).toBe(true);
		const { ends } = tree.plant.segments;
		expect(isInside([0.5 * (ends[0] + ends[3]), 0.5 * (ends[1] + ends[4]), 0.5 * (ends[2] + ends[5])], 0)).toBe(true);
	});
});

describe("a tree with few triangles", () => {
	it("keeps its wood and its outline, and every leaf is attached", async () => {
		const low = Object.values(readLevels(await lowGlb(tree.parts(), tree.about, 20_000, tree.plant)).meshes).flat();
		expect(countOf(low)).toBeLessThanOrEqual(20_000);
		expect(countOf(low.filter(({ cut }) => !cut))).toBeGreaterThan(4000);
		expect(compared(source, low).outline).toBeGreaterThan(0.93);
		expect(farthestLeaf(low)).toBeLessThan(0.45);
	}, 300_000);

	it("sways in the wind with as many leaves", async () => {
		const glb = await windGlb(tree.parts(), tree.about, swayOf(tree.plant), 20_000, tree.plant);
		const { json, meshes } = readLevels(glb);
		expect(countOf(Object.values(meshes).flat())).toBeGreaterThan(15_000);
		expect(json.animations).toHaveLength(1);
		const { issues } = await validateBytes(glb, { maxIssues: 0 });
		expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
	}, 300_000);
});
