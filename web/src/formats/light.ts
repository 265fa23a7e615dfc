/**
 * A plant with few triangles and few draw calls, for pages, games and phones: hidden triangles are removed, each
 * material is one mesh, and single parts lose their names. For parts of any model.
 */
import type { Material, Picture, Textures } from "../plant/material";
import { everyPart, type Part, type Shape, TRANSFORM, type Vector } from "../plant/part";
import type { Wooden } from "../plant/wood/wooden";
import type { Card } from "./cards/card";
import { type CardTree, cardTree, FINEST_LEVEL } from "./cards/card_tree";
import { drawCalls } from "./draw_calls";
import { Cover } from "./hidden";
import { mergedBodies, solidGroups } from "./merged_bodies";
import { agreement, outlinesBeside } from "./outline";
import { extentOf, type Piece, piecesOf } from "./piece";
import { shrunk } from "./shrunk";
import { simplified } from "./simplified";
import { sparse } from "./sparse";

/** The most draw calls. */
const MAX_DRAWN = 5;
/**
 * An invisible error, as a share of the plant's extent: a quarter of a pixel where the plant fills a view a thousand
 * pixels high.
 */
const UNSEEN = 1 / 4000;

/** Overlap of outlines (outline.ts) above which bodies stay separate. */
const SAME_OUTLINE = 0.975;
/** Reaches tried for merged bodies (merged_bodies.ts): the fewer the triangles, the smoother the best body. */
const REACHES = [4, 5, 7];

export interface Light {
	/** The most triangles; without it as few as look the same. */
	triangles?: number;
	/** The fixed point of still parts, for plants that are to sway: vertices then have fixed points (`feet`). */
	still?: Vector | undefined;
	/** The most pixels along an edge of a picture. */
	pixels: number;
	/** The plant of the parts. With a budget of triangles, the leaves of a tree become cards attached to its wood. */
	plant?: Wooden | undefined;
}

/** The edge of the atlas of a tree's cards, in pixels. */
const ATLAS = 512;
/** The share of the triangles for parts of a tree besides wood and leaves, such as bunches. */
const OTHER_SHARE = 0.15;

/** Simplifies the parts and merges them into one per draw call, at most 5. */
export async function lightParts(parts: Iterable<Part>, light: Light): Promise<Part[]> {
	const { triangles, plant } = light;
	if (triangles === undefined || !plant) return lightPieces(parts, light);
	const own = [...parts];
	const tree = treeOfCards(own, plant, triangles);
	if (!tree) return lightPieces(own, light);
	const { levels, bark, leaves, others } = tree;
	const [{ tubes, mesh, cards }] = levels;
	const drawn = [
		{ name: bark.name, shape: { mesh: tubes.mesh, material: bark } },
		{ name: leaves.name, shape: { mesh: light.still ? { ...mesh, feet: feetOf(cards) } : mesh, material: leaves } },
	];
	const left = triangles - (tubes.mesh.indices.length + mesh.indices.length) / 3;
	return others.length > 0 ? [...drawn, ...(await lightPieces(others, { ...light, triangles: left }))] : drawn;
}

/** Returns a tree as tubes and cards; undefined for plants with few leaves, or whose parts fit the budget as they are. */
function treeOfCards(parts: readonly Part[], plant: Wooden, triangles: number): CardTree | undefined {
	const isLeaf = ({ shape }: Part) => shape?.instances !== undefined && !shape.instances.each;
	const all = [...everyPart(parts)].filter(({ shape }) => shape !== undefined);
	const count = all.reduce((sum, { shape }) => sum + (shape ? trianglesOf(shape) : 0), 0);
	if (count <= triangles) return undefined;
	const hasOthers = all.filter((part) => !isLeaf(part)).length > 1;
	const room = hasOthers ? Math.floor((1 - OTHER_SHARE) * triangles) : triangles;
	return cardTree(parts, plant, [{ ...FINEST_LEVEL, triangles: room, share: 1 }], ATLAS);
}

/** Returns the number of triangles of all instances of a shape. */
const trianglesOf = ({ mesh, instances }: Shape) =>
	(mesh.indices.length / 3) * (instances ? instances.transforms.length / TRANSFORM : 1);

/** Returns the fixed points of the cards' corners. */
function feetOf(cards: readonly Card[]): Float32Array {
	return Float32Array.from(cards.flatMap(({ corners, anchor }) => corners.flatMap(() => anchor)));
}

/** Simplifies any parts. */
async function lightPieces(parts: Iterable<Part>, { triangles, pixels, still }: Light): Promise<Part[]> {
	const all = triangles === undefined ? parts : sparse([...parts], triangles);
	const pieces = [...piecesOf(all, still)];
	const light =
		triangles === undefined
			? await simplified(drawCallsOf(pieces), { error: UNSEEN })
			: await simplifiedTo(pieces, triangles);
	const small = new Map<Picture, Picture>();
	return light.map(({ material, mesh }) => {
		const shape = { mesh, material: withPictures(material, (picture) => cachedSmall(small, picture, pixels)) };
		return { name: material.name, shape };
	});
}

/** Merges pieces into one per draw call, without hidden triangles. */
const drawCallsOf = (pieces: readonly Piece[]) => drawCalls(visible(pieces), MAX_DRAWN);

/**
 * Simplifies pieces to at most `triangles`. Where separate bodies would lose the outline, solid ones are merged first,
 * if that preserves more of the outline.
 */
async function simplifiedTo(pieces: readonly Piece[], triangles: number): Promise<Piece[]> {
	let best = await simplified(drawCallsOf(pieces), { triangles });
	const groups = solidGroups(pieces);
	if (groups.size === 0) return best;
	const outline = outlinesBeside(pieces);
	const wholeOutline = outline(pieces);
	let bestAgreement = agreement(wholeOutline, outline(best));
	for (const reach of REACHES) {
		if (bestAgreement >= SAME_OUTLINE) break;
		const light = await simplified(drawCallsOf(mergedBodies(pieces, groups, reach)), { triangles, moves: true });
		const share = agreement(wholeOutline, outline(light));
		if (share > bestAgreement) [best, bestAgreement] = [light, share];
	}
	return best;
}

/** The pieces without triangles that are hidden from outside. */
export function visible<Own extends Piece>(pieces: readonly Own[]): Own[] {
	return coverOf(pieces).visible();
}

/** Returns the cover of pieces by each other. */
export function coverOf<Own extends Piece>(pieces: readonly Own[]): Cover<Own> {
	return new Cover(pieces, UNSEEN * extentOf(pieces));
}

/** Returns a picture shrunk to at most `pixels`, once for all materials that share it. */
function cachedSmall(pictures: Map<Picture, Picture>, picture: Picture, pixels: number): Picture {
	const small = pictures.get(picture) ?? shrunk(picture, pixels);
	pictures.set(picture, small);
	return small;
}

/** Returns a material with each of its pictures changed. */
function withPictures(material: Material, change: (picture: Picture) => Picture): Material {
	if (!material.textures) return material;
	const { repeats, ...pictures } = material.textures;
	const entries = Object.entries(pictures).map(([kind, picture]) => [kind, change(picture)]);
	return { ...material, textures: { ...(Object.fromEntries(entries) as Textures), ...(repeats ? { repeats } : {}) } };
}
