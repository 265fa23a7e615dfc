/**
 * Colours and shade of vertices, baked into pictures: what programs that paint, and readers that know no colours of vertices, can
 * use. Parts of one material share one picture, a tile each; the shade is a picture by itself (glTF's occlusion), so that
 * colours are those under an open sky. Only of parts whose texture coordinates stay on one picture.
 */
import { encoded } from "../plant/colour";
import type { Material, Picture } from "../plant/material";
import { everyPart, type Part, type PartMesh, type Shape } from "../plant/part";
import { bounced } from "../plant/shade";

/** Pixels of a picture and of a tile along an edge, at the most. */
const MOST_PIXELS = 2048;
const MOST_TILE = 256;
/** Round what is drawn in a tile, so that readers who blend neighbours find the same colour there. */
const MARGIN = 4;
/** Of a pixel, beyond a triangle's edge: what lies between two triangles belongs to one. */
const EDGE = 0.02;

/** The same parts; what has been baked has neither colours nor shade in its vertices. */
export function baked(parts: readonly Part[]): Part[] {
	const byMaterial = new Map<Material, Shape[]>();
	for (const { shape } of everyPart(parts)) {
		if (!shape || !isBakeable(shape)) continue;
		byMaterial.set(shape.material, [...(byMaterial.get(shape.material) ?? []), shape]);
	}
	const replaced = new Map<Shape, Shape>();
	for (const [material, shapes] of byMaterial) {
		const atlas = new Atlas(shapes.length);
		const meshes = shapes.map(({ mesh }, tile) => atlas.draw(mesh, material, tile));
		const textures = { colour: atlas.colour, occlusion: atlas.occlusion };
		const dressed = { ...material, textures };
		for (const [i, shape] of shapes.entries()) replaced.set(shape, { ...shape, mesh: meshes[i], material: dressed });
	}
	return parts.map((part) => withShapes(part, replaced));
}

function withShapes(part: Part, replaced: ReadonlyMap<Shape, Shape>): Part {
	const { shape, children } = part;
	return {
		...part,
		...(shape ? { shape: replaced.get(shape) ?? shape } : {}),
		...(children ? { children: children.map((child) => withShapes(child, replaced)) } : {}),
	};
}

function isBakeable({ mesh, material, instances }: Shape): boolean {
	const { colours, uvs } = mesh;
	if (!colours || instances || material.textures || uvs.length === 0) return false;
	return uvs.every((value) => value >= 0 && value <= 1);
}

/** Pictures of colour and shade in square tiles, row by row. */
class Atlas {
	readonly colour: Picture;
	readonly occlusion: Picture;
	readonly #tile: number;
	readonly #columns: number;

	constructor(tiles: number) {
		// Powers of two, as graphics cards like them.
		this.#columns = powerFrom(Math.sqrt(tiles));
		this.#tile = Math.min(MOST_TILE, MOST_PIXELS / this.#columns);
		const [width, height] = [this.#columns * this.#tile, powerFrom(tiles / this.#columns) * this.#tile];
		this.colour = { width, height, pixels: new Uint8Array(3 * width * height) };
		// Roughness and metal, if anyone looks for them in the other channels: all of the factor.
		this.occlusion = { width, height, pixels: new Uint8Array(3 * width * height).fill(255) };
	}

	/** Draws a mesh on its tile; returns it with texture coordinates that lie there. */
	draw(mesh: PartMesh, material: Material, tile: number): PartMesh {
		const { colours: _, sky: __, ...bare } = mesh;
		const side = this.#tile;
		const left = (tile % this.#columns) * side;
		const top = Math.floor(tile / this.#columns) * side;
		const inner = side - 2 * MARGIN;
		const local = mesh.uvs.map((value) => MARGIN + value * inner);
		const drawn = new Uint8Array(side * side);
		const texels = texelsOf(mesh, material);
		for (let t = 0; t < mesh.indices.length; t += 3)
			this.#fill(mesh.indices.subarray(t, t + 3), local, texels, left, top, drawn);
		this.#spread(drawn, left, top);
		const { width, height } = this.colour;
		const uvs = local.map((value, i) => (i % 2 === 0 ? (left + value) / width : (top + value) / height));
		return { ...bare, uvs };
	}

	/** Draws one triangle, in the tile's pixels. */
	#fill(corners: Uint32Array, at: Float32Array, texels: Float32Array, left: number, top: number, drawn: Uint8Array) {
		const [a, b, c] = corners;
		const [ax, ay, bx, by, cx, cy] = [a, b, c].flatMap((corner) => [at[2 * corner], at[2 * corner + 1]]);
		const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
		if (area === 0) return;
		const least = -EDGE;
		for (let y = Math.floor(Math.min(ay, by, cy)); y <= Math.min(this.#tile - 1, Math.max(ay, by, cy)); y++) {
			for (let x = Math.floor(Math.min(ax, bx, cx)); x <= Math.min(this.#tile - 1, Math.max(ax, bx, cx)); x++) {
				const [px, py] = [x + 0.5 - ax, y + 0.5 - ay];
				const second = (px * (cy - ay) - (cx - ax) * py) / area;
				const third = ((bx - ax) * py - px * (by - ay)) / area;
				const first = 1 - second - third;
				if (first < least || second < least || third < least) continue;
				drawn[y * this.#tile + x] = 1;
				const to = (top + y) * this.colour.width + left + x;
				const mixed = (k: number) => first * texels[4 * a + k] + second * texels[4 * b + k] + third * texels[4 * c + k];
				this.#put(to, [mixed(0), mixed(1), mixed(2)], mixed(3));
			}
		}
	}

	#put(to: number, colour: [number, number, number], open: number): void {
		encoded(colour).forEach((value, k) => {
			this.colour.pixels[3 * to + k] = Math.round(255 * value);
		});
		this.occlusion.pixels[3 * to] = Math.round(255 * open);
	}

	/** What no triangle has covered takes the colour of a neighbour, until all of the tile is drawn. */
	#spread(drawn: Uint8Array, left: number, top: number): void {
		const side = this.#tile;
		const { width } = this.colour;
		let edge = [...drawn.keys()].filter((i) => drawn[i] === 1);
		while (edge.length > 0) {
			const next: number[] = [];
			for (const from of edge) {
				const [x, y] = [from % side, Math.floor(from / side)];
				for (const [nx, ny] of [
					[x - 1, y],
					[x + 1, y],
					[x, y - 1],
					[x, y + 1],
				]) {
					if (nx < 0 || ny < 0 || nx >= side || ny >= side || drawn[ny * side + nx]) continue;
					drawn[ny * side + nx] = 1;
					next.push(ny * side + nx);
					const source = 3 * ((top + y) * width + left + x);
					const target = 3 * ((top + ny) * width + left + nx);
					this.colour.pixels.copyWithin(target, source, source + 3);
					this.occlusion.pixels.copyWithin(target, source, source + 3);
				}
			}
			edge = next;
		}
	}
}

/** The least power of two that is no smaller. */
const powerFrom = (value: number) => 2 ** Math.ceil(Math.log2(value));

/** 4 × vertices: colour, linear, and the share of light from all around that the shade leaves. */
function texelsOf({ colours = new Float32Array(0), sky }: PartMesh, { colour }: Material): Float32Array {
	const texels = new Float32Array((4 * colours.length) / 3);
	const albedo = (colour[0] + colour[1] + colour[2]) / 3;
	for (let vertex = 0; vertex < colours.length / 3; vertex++) {
		texels.set(colours.subarray(3 * vertex, 3 * vertex + 3), 4 * vertex);
		texels[4 * vertex + 3] = sky ? Math.min(1, bounced(sky[vertex] / 255, albedo)) : 1;
	}
	return texels;
}
