/**
 * A tree from tubes and cards: tubes for the wood, and cards with cut-out pictures of leaves. All levels of detail share
 * one atlas; each coarser one shows the cards of the finest in fewer planes, so that the silhouette stays the same.
 */
import { meanColour } from "../../plant/colour";
import type { Material, Picture } from "../../plant/material";
import type { Part, PartMesh, Shape, Vector } from "../../plant/part";
import type { Wooden } from "../../plant/wood/wooden";
import { shrunk } from "../shrunk";
import { plainBase, writtenColours } from "../vertex_colours";
import { AtlasPicture, packed, SAMPLES, type Tile } from "./atlas";
import { type Card, cardMesh, middleOf } from "./card";
import { type CrownFoliage, foliageOf } from "./foliage";
import { type Plane, planesOf } from "./planes";
import { Canvas, linearPicture, type OrthographicView } from "./raster";
import { Skeleton } from "./skeleton";
import { buildTubes, type Tubes } from "./tubes";
import { type CardOutline, outlineOf, twigCards } from "./twig_cards";
import { add, cross, dot, lengthOf, scaled, subtract } from "./vectors";
import { WoodGrid } from "./wood_grid";

/** The size of one level. */
export interface LevelOptions {
	/** The most triangles. */
	readonly triangles: number;
	/** The largest share of the triangles for wood. */
	readonly wood: number;
	/** Tolerance of centre lines, as a share of the height. */
	readonly tolerance: number;
	/** Sides of stems, the thickest first (tubes.ts). */
	readonly sides: readonly [number, number, number, number];
	/** The share of the atlas for this level. */
	readonly share: number;
}

/** The finest level of a tree, of 20,000 triangles. */
export const FINEST_LEVEL: LevelOptions = {
	triangles: 20_000,
	wood: 0.34,
	tolerance: 0.003,
	sides: [8, 5, 3, 3],
	share: 0.4,
};

export interface CardLevel {
	readonly tubes: Tubes;
	readonly cards: readonly Card[];
	readonly mesh: PartMesh;
}

export interface CardTree {
	readonly levels: readonly CardLevel[];
	readonly bark: Material;
	readonly leaves: Material;
	readonly skeleton: Skeleton;
	/** Parts that are neither wood nor leaves. */
	readonly others: readonly Part[];
}

/** The largest edge of the tile of a kind of leaves. */
const MOST_TILE = 256;
/** The largest factor by which cards are enlarged to make up for bent leaves. */
const MOST_FACTOR = 1.25;
/** Pictures of leaves are shrunk to this edge before they are drawn. */
const LEAF_PIXELS = 128;

/**
 * Makes a tree of cards; undefined for plants without wood or with few leaves.
 * @param plant its segments carry the parts
 * @param options of the levels, the finest first
 * @param edge of the atlas, in pixels
 */
export function cardTree(
	parts: readonly Part[],
	plant: Wooden,
	options: readonly LevelOptions[],
	edge: number,
): CardTree | undefined {
	const foliage = plant.segments.count > 0 ? foliageOf(parts) : undefined;
	const wood = foliage && woodShape(foliage.others, plant);
	if (!foliage || !wood) return undefined;
	const skeleton = new Skeleton(plant.segments);
	const colours = segmentColours(wood, plant);
	const repeats = repeatsOf(wood.mesh);
	const tubes = options.map(({ triangles, wood: share, tolerance, sides }) =>
		buildTubes(skeleton, { triangles: Math.round(share * triangles), tolerance, sides, repeats, colours }),
	);
	const room = (level: number) => options[level].triangles - tubes[level].mesh.indices.length / 3;
	const atlas = new AtlasPicture(edge, edge);
	let y = 0;
	const strip = (level: number): Tile => {
		const height = Math.floor(options[level].share * edge);
		y += height;
		return { x: 0, y: y - height, width: edge, height };
	};
	const first = finest(foliage, skeleton, tubes[0], room(0), atlas, strip(0));
	const crown = crownOf(foliage);
	const source = { mesh: cardMesh(first, crown), picture: linearPicture(atlas.picture()) };
	const counts = options.slice(1).map((_, i) => Math.max(1, Math.floor(room(i + 1) / 2)));
	const coarser = planesOf(first, counts).map((planes, i) =>
		planeCards(planes, first, source, atlas, strip(i + 1), new WoodGrid(skeleton, tubes[i + 1].retained)),
	);
	const all = [first, ...coarser];
	const levels = all.map((cards, i) => ({ tubes: tubes[i], cards, mesh: cardMesh(cards, crown) }));
	const leaves = leavesOf(foliage, atlas);
	const others = foliage.others.filter(({ shape }) => shape !== wood).map(({ children: _, ...part }) => part);
	return { levels, bark: wood.material, leaves, skeleton, others };
}

/** Makes the cards of the finest level: rectangles where the triangles suffice, else triangles. */
function finest(
	foliage: CrownFoliage,
	skeleton: Skeleton,
	tubes: Tubes,
	triangles: number,
	atlas: AtlasPicture,
	strip: Tile,
): Card[] {
	const isTriangle = 2 * foliage.leaves.length > triangles;
	const outlines = foliage.kinds.map(({ shape, twig }) => {
		const all = [...shape.mesh.positions, ...(twig?.mesh.positions ?? [])];
		return outlineOf({ ...shape.mesh, positions: Float32Array.from(all) }, isTriangle);
	});
	const tiles = kindTiles(outlines, strip);
	// A flat card shows less than a bent leaf from most sides: half of the difference is made up for by its size.
	const factors: number[] = [];
	const pictures = new Map<Picture, ReturnType<typeof linearPicture>>();
	for (const [i, { shape, twig }] of foliage.kinds.entries()) {
		const { mesh } = shape;
		const { low, high } = outlines[i];
		const canvas = new Canvas(SAMPLES * tiles[i].width, SAMPLES * tiles[i].height);
		const view: OrthographicView = {
			middle: [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0],
			right: [1, 0, 0],
			up: [0, 1, 0],
			towards: [0, 0, 1],
			halfWidth: 0.5 * (high[0] - low[0]),
			halfHeight: 0.5 * (high[1] - low[1]),
		};
		for (const { mesh: each, material } of twig ? [shape, twig] : [shape]) {
			const picture = material.textures?.colour;
			const linear = picture && (pictures.get(picture) ?? linearPicture(shrunk(picture, LEAF_PIXELS)));
			if (picture && linear) pictures.set(picture, linear);
			const colour = each.colours ? ([1, 1, 1] as const) : plainBase(material);
			canvas.draw({ ...each, colour: [...colour], picture: linear, doubleSided: true }, view);
		}
		atlas.copy(canvas, tiles[i]);
		const shown = canvas.covered.reduce((sum, value) => sum + value, 0) / canvas.covered.length;
		const flat = shown * (high[0] - low[0]) * (high[1] - low[1]);
		factors.push(Math.min(MOST_FACTOR, Math.max(1, (areaOf(mesh) / flat) ** 0.25)));
	}
	const uvOf = (kind: number, x: number, y: number) => {
		const { low, high } = outlines[kind];
		const tile = tiles[kind];
		const u = tile.x + (tile.width * (x - low[0])) / (high[0] - low[0]);
		const v = tile.y + (tile.height * (high[1] - y)) / (high[1] - low[1]);
		return [u / atlas.width, v / atlas.height] as const;
	};
	const count = Math.floor(triangles / (isTriangle ? 1 : 2));
	return twigCards(foliage, skeleton, tubes, count, { outlines, factors, uvOf });
}

/** Returns the area of a mesh, in squares of its unit. */
function areaOf({ positions, indices }: PartMesh): number {
	let sum = 0;
	for (let at = 0; at < indices.length; at += 3) {
		const corner = (k: number): Vector => {
			const first = 3 * indices[at + k];
			return [positions[first], positions[first + 1], positions[first + 2]];
		};
		const [a, b, c] = [corner(0), corner(1), corner(2)];
		sum += 0.5 * lengthOf(cross(subtract(b, a), subtract(c, a)));
	}
	return sum;
}

/** Returns the tile of each kind of leaves, in proportion to its outline. */
function kindTiles(outlines: readonly CardOutline[], strip: Tile): Tile[] {
	const sizes = outlines.map(({ low, high }) => [high[0] - low[0], high[1] - low[1]] as const);
	const longest = Math.max(...sizes.flat());
	const { tiles } = packed(
		sizes.map(([w, h]) => [w / longest, h / longest] as const),
		strip,
	);
	return tiles.map(({ width, height, ...place }) => ({
		...place,
		width: Math.min(MOST_TILE, width),
		height: Math.min(MOST_TILE, height),
	}));
}

/** Makes the cards of a coarser level: planes that show the cards of the finest level. */
function planeCards(
	planes: readonly Plane[],
	finer: readonly Card[],
	source: { mesh: PartMesh; picture: ReturnType<typeof linearPicture> },
	atlas: AtlasPicture,
	strip: Tile,
	grid: WoodGrid,
): Card[] {
	const { tiles } = packed(
		planes.map(({ width, height }) => [width, height] as const),
		strip,
	);
	const firsts = [0];
	for (const { corners } of finer) firsts.push(firsts[firsts.length - 1] + 3 * (corners.length - 2));
	return planes.map((plane, i): Card => {
		const tile = tiles[i];
		const canvas = new Canvas(SAMPLES * tile.width, SAMPLES * tile.height);
		const indices = plane.members.flatMap((member) => [
			...source.mesh.indices.subarray(firsts[member], firsts[member + 1]),
		]);
		drawPlane(canvas, plane, indices, source);
		atlas.copy(canvas, tile);
		const [left, right] = [tile.x / atlas.width, (tile.x + tile.width) / atlas.width];
		const [top, bottom] = [tile.y / atlas.height, (tile.y + tile.height) / atlas.height];
		const at = (x: number, y: number): Vector =>
			add(plane.corner, add(scaled(plane.across, x * plane.width), scaled(plane.along, y * plane.height)));
		const sky = plane.members.reduce((sum, member) => sum + finer[member].sky, 0) / plane.members.length;
		const card = {
			corners: [at(0, 0), at(1, 0), at(0, 1), at(1, 1)],
			uvs: [
				[left, bottom],
				[right, bottom],
				[left, top],
				[right, top],
			] as const,
			face: plane.face,
			sky,
		};
		const { place: anchor, segment } = grid.nearest(middleOf(card));
		return { ...card, anchor, segment };
	});
}

/** Draws the triangles of cards on their plane. */
function drawPlane(
	canvas: Canvas,
	{ corner, across, along, face, width, height }: Plane,
	corners: readonly number[],
	{ mesh, picture }: { mesh: PartMesh; picture: ReturnType<typeof linearPicture> },
): void {
	const from = [...new Set(corners)];
	const to = new Map(from.map((vertex, i) => [vertex, i]));
	const pick = (values: ArrayLike<number>, size: number) =>
		Float32Array.from({ length: size * from.length }, (_, i) => values[size * from[Math.floor(i / size)] + (i % size)]);
	canvas.draw(
		{
			positions: pick(mesh.positions, 3),
			normals: pick(mesh.normals, 3),
			uvs: pick(mesh.uvs, 2),
			indices: corners.map((vertex) => to.get(vertex) as number),
			colour: [1, 1, 1],
			picture,
			doubleSided: true,
		},
		{
			middle: add(corner, add(scaled(across, 0.5 * width), scaled(along, 0.5 * height))),
			right: across,
			up: along,
			towards: face,
			halfWidth: 0.5 * width,
			halfHeight: 0.5 * height,
		},
	);
}

/** Returns the shape of the wood among parts: the largest one whose vertices belong to segments. */
function woodShape(parts: readonly Part[], { vertexSegments }: Wooden): Shape | undefined {
	const shapes = parts.flatMap(({ shape }) => (shape && !shape.instances ? [shape] : []));
	const own = shapes.filter(({ mesh }) => vertexSegments?.length === mesh.positions.length / 3);
	const all = own.length > 0 ? own : shapes.filter(({ material }) => !material.doubleSided);
	return all.sort((a, b) => b.mesh.indices.length - a.mesh.indices.length)[0];
}

/** Returns the mean colour of each segment's vertices, with their shade; undefined without such colours. */
function segmentColours({ mesh, material }: Shape, { vertexSegments, segments }: Wooden): Float32Array | undefined {
	const written = writtenColours(mesh, material);
	if (!written || vertexSegments?.length !== mesh.positions.length / 3) return undefined;
	const [sums, counts] = [new Float32Array(3 * segments.count), new Float32Array(segments.count)];
	for (let vertex = 0; vertex < vertexSegments.length; vertex++) {
		const segment = vertexSegments[vertex];
		counts[segment]++;
		for (let k = 0; k < 3; k++) sums[3 * segment + k] += written[3 * vertex + k];
	}
	const mean = meanColour(written);
	for (let segment = 0; segment < segments.count; segment++) {
		// Segments without vertices of their own look like their parents.
		const from = segments.parent[segment];
		for (let k = 0; k < 3; k++) {
			const inherited = from >= 0 ? sums[3 * from + k] : mean[k];
			sums[3 * segment + k] = counts[segment] > 0 ? sums[3 * segment + k] / counts[segment] : inherited;
		}
	}
	return sums;
}

/** Returns how often the bark's picture repeats per metre: by areas in the picture and in the plant, thick wood first. */
function repeatsOf({ positions, uvs, indices }: PartMesh): number {
	if (uvs.length === 0) return 1;
	let [pictured, real] = [0, 0];
	for (let at = 0; at < indices.length; at += 3) {
		const [a, b, c] = [indices[at], indices[at + 1], indices[at + 2]];
		const [du1, dv1] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]];
		const [du2, dv2] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]];
		const edge = (to: number): Vector => [0, 1, 2].map((k) => positions[3 * to + k] - positions[3 * a + k]) as Vector;
		const [u, v] = [edge(b), edge(c)];
		const area = Math.sqrt(Math.max(0, dot(u, u) * dot(v, v) - dot(u, v) ** 2));
		pictured += area * Math.abs(du1 * dv2 - du2 * dv1);
		real += area * area;
	}
	return real > 0 && pictured > 0 ? Math.sqrt(pictured / real) : 1;
}

/** Returns the middle of the crown, lowered so that its lower side faces down only a little. */
function crownOf({ leaves }: CrownFoliage): Vector {
	const low: Vector = [...leaves[0].place];
	const high: Vector = [...leaves[0].place];
	for (const { place } of leaves)
		for (let k = 0; k < 3; k++) [low[k], high[k]] = [Math.min(low[k], place[k]), Math.max(high[k], place[k])];
	return [0.5 * (low[0] + high[0]), low[1] + 0.35 * (high[1] - low[1]), 0.5 * (low[2] + high[2])];
}

/** Returns the material of the cards: that of the leaves, with the atlas. */
function leavesOf({ kinds }: CrownFoliage, atlas: AtlasPicture): Material {
	const { roughness, sheet } = kinds[0].shape.material;
	return {
		name: "Leaves",
		colour: atlas.colour,
		roughness,
		doubleSided: true,
		cutout: true,
		...(sheet ? { sheet } : {}),
		textures: { colour: atlas.picture() },
	};
}
