/** An atlas: pictures of many meshes, in square tiles row by row. A callback colours each pixel. */
import type { Picture } from "../plant/material";

/** The most pixels along an edge of a picture, and of a tile. */
const MAX_PIXELS = 2048;
const MAX_TILE = 256;
/** Pixels around a tile that repeat its edge, for readers that blend neighbouring pixels. */
const MARGIN = 4;
/** Tolerance beyond a triangle's edge, in pixels: a pixel between two triangles belongs to one of them. */
const EDGE = 0.02;

/** The colour of a pixel in each picture, by the pictures' names: red, green, blue, 0 … 255. */
export type Paint<Kind extends string> = (
	corners: readonly number[],
	weights: readonly number[],
) => Readonly<Record<Kind, readonly number[]>>;

export class Atlas<Kind extends string> {
	readonly pictures: Record<Kind, Picture>;
	readonly #layers: [Kind, Uint8Array][];
	readonly #width: number;
	readonly #height: number;
	readonly #tile: number;
	readonly #columns: number;

	/**
	 * @param kinds the pictures to make, all of the same layout
	 * @param tiles number of tiles; the tile's edge in pixels shrinks where there are many, to stay within MAX_PIXELS
	 */
	constructor(kinds: readonly Kind[], tiles: number) {
		// Powers of two, which graphics cards prefer.
		this.#columns = powerFrom(Math.sqrt(tiles));
		this.#tile = Math.min(MAX_TILE, MAX_PIXELS / this.#columns);
		this.#width = this.#columns * this.#tile;
		this.#height = powerFrom(tiles / this.#columns) * this.#tile;
		this.#layers = kinds.map((kind) => [kind, new Uint8Array(3 * this.#width * this.#height)]);
		const size = { width: this.#width, height: this.#height };
		this.pictures = Object.fromEntries(this.#layers.map(([kind, pixels]) => [kind, { ...size, pixels }])) as Record<
			Kind,
			Picture
		>;
	}

	/** Returns texture coordinates of a mesh, 0 … 1 within its tile, as coordinates in the whole atlas. */
	placed(uvs: Float32Array, tile: number): Float32Array {
		const { left, top } = this.#corner(tile);
		const local = this.#pixelsInTile(uvs);
		return local.map((value, i) => (i % 2 === 0 ? (left + value) / this.#width : (top + value) / this.#height));
	}

	/** Draws triangles on a tile, by their texture coordinates in a picture of their own. */
	draw(uvs: Float32Array, indices: Uint32Array, tile: number, paint: Paint<Kind>): void {
		const local = this.#pixelsInTile(uvs);
		const drawn = new Uint8Array(this.#tile ** 2);
		for (let t = 0; t < indices.length; t += 3) this.#fill([...indices.subarray(t, t + 3)], local, tile, paint, drawn);
		this.#spread(drawn, tile);
	}

	/** Returns the upper left corner of a tile, in pixels of the atlas. */
	#corner(tile: number): { left: number; top: number } {
		return { left: (tile % this.#columns) * this.#tile, top: Math.floor(tile / this.#columns) * this.#tile };
	}

	/** Converts texture coordinates, 0 … 1, to pixels within a tile, inside its margin. */
	#pixelsInTile(uvs: Float32Array): Float32Array {
		const inner = this.#tile - 2 * MARGIN;
		return uvs.map((value) => MARGIN + value * inner);
	}

	/**
	 * Draws one triangle by barycentric coordinates of each pixel's middle; pixels that an earlier triangle covers stay.
	 * @param corners indices of its vertices
	 * @param positions 2 × vertices, in the tile, pixels
	 * @param drawn 1 for each pixel of the tile that is drawn
	 */
	#fill(
		corners: readonly number[],
		positions: Float32Array,
		tile: number,
		paint: Paint<Kind>,
		drawn: Uint8Array,
	): void {
		const [ax, ay, bx, by, cx, cy] = corners.flatMap((corner) => [positions[2 * corner], positions[2 * corner + 1]]);
		const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
		if (area === 0) return;
		const { left, top } = this.#corner(tile);
		for (let y = Math.floor(Math.min(ay, by, cy)); y <= Math.min(this.#tile - 1, Math.max(ay, by, cy)); y++) {
			for (let x = Math.floor(Math.min(ax, bx, cx)); x <= Math.min(this.#tile - 1, Math.max(ax, bx, cx)); x++) {
				const [px, py] = [x + 0.5 - ax, y + 0.5 - ay];
				const second = (px * (cy - ay) - (cx - ax) * py) / area;
				const third = ((bx - ax) * py - px * (by - ay)) / area;
				const first = 1 - second - third;
				if (drawn[y * this.#tile + x] || first < -EDGE || second < -EDGE || third < -EDGE) continue;
				drawn[y * this.#tile + x] = 1;
				const to = 3 * ((top + y) * this.#width + left + x);
				const shown = paint(corners, within(first, second, third));
				for (const [kind, pixels] of this.#layers) pixels.set(shown[kind], to);
			}
		}
	}

	/**
	 * Spreads colours to neighbouring pixels that no triangle covers, until the whole tile is drawn: breadth first, from
	 * the edge of the drawn area.
	 * @param drawn 1 for each pixel of the tile that is drawn
	 */
	#spread(drawn: Uint8Array, tile: number): void {
		const side = this.#tile;
		const { left, top } = this.#corner(tile);
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
					const source = 3 * ((top + y) * this.#width + left + x);
					const target = 3 * ((top + ny) * this.#width + left + nx);
					for (const [, pixels] of this.#layers) pixels.copyWithin(target, source, source + 3);
				}
			}
			edge = next;
		}
	}
}

/** Returns the weights of the nearest point in a triangle: negative ones become 0, and the sum 1. */
function within(...weights: number[]): number[] {
	const inside = weights.map((weight) => Math.max(0, weight));
	const sum = inside[0] + inside[1] + inside[2];
	return inside.map((weight) => weight / sum);
}

/** Returns the least power of two that is at least `value`. */
const powerFrom = (value: number) => 2 ** Math.ceil(Math.log2(value));
