import { DataTexture, FloatType, NearestFilter, RGBAFormat } from "three";

/** Records side by side in one row of a texture; keeps the greatest bunches inside every device's texture limits. */
export const RECORDS_PER_ROW = 64;

/**
 * A growing array of records of four-float texels that shaders read by index. Memory is kept between bunches and
 * grows by halves, so that dragging neither allocates nor rebuilds.
 */
export class RecordTexture {
	texture: DataTexture;
	#capacity = 0;

	/** @param texels per record */
	constructor(readonly texels: number) {
		this.texture = this.#make(1);
	}

	/** Room for `count` records; `data` and `texture` may be new afterwards. */
	reserve(count: number): void {
		if (count <= this.#capacity) return;
		const rows = Math.ceil(Math.max(count, 1.5 * this.#capacity) / RECORDS_PER_ROW);
		this.texture.dispose();
		this.texture = this.#make(rows);
	}

	/** The records, one after another. */
	get data(): Float32Array {
		return this.texture.image.data as Float32Array;
	}

	/** Sends the records to the GPU with the next draw. */
	changed(): void {
		this.texture.needsUpdate = true;
	}

	dispose(): void {
		this.texture.dispose();
	}

	#make(rows: number): DataTexture {
		this.#capacity = rows * RECORDS_PER_ROW;
		const width = RECORDS_PER_ROW * this.texels;
		const texture = new DataTexture(new Float32Array(width * rows * 4), width, rows, RGBAFormat, FloatType);
		texture.magFilter = NearestFilter;
		texture.minFilter = NearestFilter;
		return texture;
	}
}
