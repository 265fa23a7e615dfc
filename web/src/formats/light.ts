/**
 * A plant with few triangles and few draw calls, for pages, games and phones: hidden triangles are removed, each
 * material is one mesh, and single parts lose their names. For parts of any model.
 */
import type { Material, Picture, Textures } from "../plant/material";
import type { Part, Vector } from "../plant/part";
import { drawCalls } from "./draw_calls";
import { Cover } from "./hidden";
import { mergedBodies, solidGroups } from "./merged_bodies";
import { agreement, outlinesBeside } from "./outline";
import { extentOf, type Piece, piecesOf } from "./piece";
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
}

/** Simplifies the parts and merges them into one per draw call, at most 5. */
export async function lightParts(parts: Iterable<Part>, { triangles, pixels, still }: Light): Promise<Part[]> {
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

/** Halves a picture until no side is longer than `most` pixels, each pixel the mean of four. */
export function shrunk(picture: Picture, most: number): Picture {
	const { width, height, pixels } = picture;
	if (Math.max(width, height) <= most) return picture;
	const channels = pixels.length / (width * height);
	const [w, h] = [Math.max(1, width >> 1), Math.max(1, height >> 1)];
	const half = new Uint8Array(channels * w * h);
	for (let y = 0, to = 0; y < h; y++) {
		const upper = channels * width * 2 * y;
		const lower = channels * width * Math.min(height - 1, 2 * y + 1);
		for (let x = 0; x < w; x++) {
			const left = channels * 2 * x;
			const right = channels * Math.min(width - 1, 2 * x + 1);
			for (let k = 0; k < channels; k++, to++) {
				const sum =
					pixels[upper + left + k] + pixels[upper + right + k] + pixels[lower + left + k] + pixels[lower + right + k];
				half[to] = Math.round(sum / 4);
			}
		}
	}
	return shrunk({ width: w, height: h, pixels: half }, most);
}
