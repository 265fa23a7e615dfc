import { DataTexture, FloatType, NearestFilter, RGBAFormat, RGBAIntegerFormat, UnsignedIntType } from "three";

/** Records per row of the texture, so that the largest plants fit into every device's texture limits. */
export const RECORDS_PER_ROW = 64;

/** Type of a texel's four words; shaders read `words` through a `usampler2D`. */
export type TexelKind = "floats" | "words";

/**
 * Growing array of records of four-word texels, which shaders read by index. Memory is reused between plants and grows
 * by half, so that dragging neither allocates nor rebuilds.
 */
export class RecordTexture {
	texture: DataTexture;
	#capacity = 0;

	/**
	 * @param texels per record
	 * @param perRow records side by side
	 */
	constructor(
		readonly texels: number,
		readonly kind: TexelKind = "floats",
		readonly perRow = RECORDS_PER_ROW,
	) {
		this.texture = this.#make(1);
	}

	/** Makes room for `count` records; `data` and `texture` may be replaced. */
	reserve(count: number): void {
		if (count <= this.#capacity) return;
		const rows = Math.ceil(Math.max(count, 1.5 * this.#capacity) / this.perRow);
		this.texture.dispose();
		this.texture = this.#make(rows);
	}

	/** The records as floats, one after another. */
	get data(): Float32Array {
		const { buffer } = this.texture.image.data as Float32Array | Uint32Array;
		return new Float32Array(buffer);
	}

	/** The same memory as words. */
	get uint32(): Uint32Array {
		return new Uint32Array(this.data.buffer);
	}

	/** Sends the records to the GPU with the next draw. */
	changed(): void {
		this.texture.needsUpdate = true;
	}

	/** Releases the graphics memory. */
	dispose(): void {
		this.texture.dispose();
	}

	/** Creates the texture for a number of rows; shaders read its texels without interpolation. */
	#make(rows: number): DataTexture {
		this.#capacity = rows * this.perRow;
		const width = this.perRow * this.texels;
		const length = width * rows * 4;
		const texture =
			this.kind === "floats"
				? new DataTexture(new Float32Array(length), width, rows, RGBAFormat, FloatType)
				: new DataTexture(new Uint32Array(length), width, rows, RGBAIntegerFormat, UnsignedIntType);
		texture.magFilter = NearestFilter;
		texture.minFilter = NearestFilter;
		return texture;
	}
}
