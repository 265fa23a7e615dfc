/**
 * A writer of binary glTF 2.0 for Panicle's exports: one buffer, geometry and pictures. Small on purpose;
 * docs/export.md has the reasons against a library.
 */
import { shortFloat } from "./numbers";

export type AccessorType = "SCALAR" | "VEC2" | "VEC3" | "VEC4";
export type AccessorData = Float32Array | Uint32Array | Uint16Array | Int16Array | Uint8Array | Int8Array;

interface Accessor {
	bufferView: number;
	byteOffset?: number;
	componentType: number;
	normalized?: true;
	count: number;
	type: AccessorType;
	min?: number[];
	max?: number[];
}

/**
 * The layout of accessors in a buffer view. `target` and `stride` (bytes) only for vertices and indices; data comes
 * padded to the stride.
 */
export interface ViewLayout {
	target?: "vertices" | "indices";
	stride?: number;
}

/**
 * An encoder like meshoptimizer's: packs `count` rows of `size` bytes, of vertices (`ATTRIBUTES`) or of indices
 * (`TRIANGLES`).
 */
export interface Encoder {
	encodeGltfBuffer(source: Uint8Array, count: number, size: number, mode: string): Uint8Array;
}

export const COMPRESSION = "EXT_meshopt_compression";

const TARGETS = { vertices: 34962, indices: 34963 } as const;
const COMPONENTS: Record<AccessorType, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
export const GLB_MAGIC = 0x46546c67;
export const GLB_VERSION = 2;
export const CHUNK_JSON = 0x4e4f534a;
const CHUNK_BINARY = 0x004e4942;
/** The header: magic, version, length. */
export const HEADER_BYTES = 12;
/** Before each chunk: its length and its type. */
export const CHUNK_HEADER_BYTES = 8;

interface View {
	index: number;
	layout: ViewLayout;
	chunks: AccessorData[];
	bytes: number;
}

/** The place of compressed data, and how to unpack it. */
interface CompressedView {
	buffer: 0;
	byteOffset: number;
	byteLength: number;
	byteStride: number;
	count: number;
	mode: "ATTRIBUTES" | "TRIANGLES";
}

/** Collects typed arrays in named buffer views; a view exists only once it has data. */
export class BinaryGltf {
	readonly #views = new Map<string, View>();
	readonly #accessors: Accessor[] = [];
	readonly #layouts: Record<string, ViewLayout>;
	readonly #encoder: Encoder | undefined;

	/**
	 * @param layouts every view that `add` may name
	 * @param encoder compresses vertices and indices (EXT_meshopt_compression); the document must then require that
	 * extension
	 */
	constructor(layouts: Record<string, ViewLayout>, encoder?: Encoder) {
		this.#layouts = layouts;
		this.#encoder = encoder;
	}

	/**
	 * Appends `data` to the view and describes it; returns the accessor's index. `bounds` writes min and max (positions
	 * must have them), `normalized` reads integers as 0 … 1 or −1 … 1.
	 */
	add(
		viewName: string,
		data: AccessorData,
		type: AccessorType,
		options: { bounds?: boolean; normalized?: boolean } = {},
	): number {
		// Compressed data is unpacked view by view: give each accessor its own view.
		const ownView = this.#encoder && this.#layouts[viewName]?.target ? ` ${this.#accessors.length}` : "";
		const view = this.#view(`${viewName}${ownView}`, this.#layouts[viewName]);
		const { stride } = view.layout;
		const step = stride ? stride / data.BYTES_PER_ELEMENT : COMPONENTS[type];
		const accessor: Accessor = {
			bufferView: view.index,
			componentType: componentType(data),
			count: data.length / step,
			type,
		};
		if (view.bytes > 0) accessor.byteOffset = view.bytes;
		if (options.normalized) accessor.normalized = true;
		if (options.bounds) Object.assign(accessor, bounds(data, COMPONENTS[type], step));
		view.chunks.push(data);
		view.bytes += aligned(data.byteLength);
		return this.#accessors.push(accessor) - 1;
	}

	/** Appends bytes that no accessor reads, a file within the file; returns the index of their view. */
	raw(bytes: Uint8Array): number {
		const view = this.#view(`raw ${this.#views.size}`);
		view.chunks.push(bytes);
		view.bytes = bytes.byteLength;
		return view.index;
	}

	/** Returns the whole file. `json` is the document without `accessors`, `bufferViews` and `buffers`. */
	finish(json: Record<string, unknown>): Uint8Array<ArrayBuffer> {
		const bufferViews: Record<string, unknown>[] = [];
		const stored: AccessorData[] = [];
		let [bytes, unpacked] = [0, 0];
		for (const view of this.#views.values()) {
			const compressed = this.#compress(view, bytes);
			const { layout } = view;
			const byteLength = compressed ? compressed.place.count * compressed.place.byteStride : view.bytes;
			const bufferView: Record<string, unknown> = compressed
				? { buffer: 1, byteOffset: unpacked, byteLength }
				: { buffer: 0, byteOffset: bytes, byteLength };
			if (layout.stride) bufferView.byteStride = layout.stride;
			if (layout.target) bufferView.target = TARGETS[layout.target];
			if (compressed) bufferView.extensions = { [COMPRESSION]: compressed.place };
			bufferViews.push(bufferView);
			stored.push(...(compressed ? [compressed.data] : view.chunks));
			bytes += aligned(compressed ? compressed.data.byteLength : byteLength);
			if (compressed) unpacked += aligned(byteLength);
		}
		// The unpacked buffer has no data: it is a fallback that no reader uses, because the extension is required.
		const fallback = { byteLength: unpacked, extensions: { [COMPRESSION]: { fallback: true } } };
		const buffers = [{ byteLength: bytes }, ...(unpacked > 0 ? [fallback] : [])];
		const geometry = bytes > 0 ? { accessors: this.#accessors, bufferViews, buffers } : undefined;
		return pack(JSON.stringify({ ...json, ...geometry }), bytes, (target) => copy(stored, target));
	}

	/**
	 * Returns a compressed view and its place in the document; undefined where it is not compressed. `byteOffset` counts
	 * from the start of the buffer.
	 */
	#compress(
		{ layout, chunks, bytes }: View,
		byteOffset: number,
	): { data: Uint8Array; place: CompressedView } | undefined {
		if (!this.#encoder || !layout.target) return undefined;
		const source = new Uint8Array(bytes);
		copy(chunks, source);
		const byteStride = layout.stride ?? chunks[0].BYTES_PER_ELEMENT;
		// Padding follows an odd number of short indices.
		const count = Math.floor(chunks[0].byteLength / byteStride);
		const mode = layout.target === "indices" ? "TRIANGLES" : "ATTRIBUTES";
		const data = this.#encoder.encodeGltfBuffer(source.subarray(0, count * byteStride), count, byteStride, mode);
		return { data, place: { buffer: 0, byteOffset, byteLength: data.byteLength, byteStride, count, mode } };
	}

	/** Returns the buffer view of a name, which is made on first use. */
	#view(name: string, layout: ViewLayout = {}): View {
		const view = this.#views.get(name) ?? { index: this.#views.size, layout, chunks: [], bytes: 0 };
		this.#views.set(name, view);
		return view;
	}
}

/** Copies chunks one after the other, each from a multiple of four bytes on. */
function copy(chunks: readonly AccessorData[], target: Uint8Array): void {
	let written = 0;
	for (const chunk of chunks) {
		target.set(new Uint8Array(chunk.buffer, chunk.byteOffset, chunk.byteLength), written);
		written += aligned(chunk.byteLength);
	}
}

/** Writes the GLB container: header, JSON chunk padded with spaces, binary chunk if any. */
function pack(json: string, binaryBytes: number, copyBinary: (target: Uint8Array) => void): Uint8Array<ArrayBuffer> {
	const text = new TextEncoder().encode(json);
	const textBytes = aligned(text.length);
	const binaryChunk = binaryBytes > 0 ? CHUNK_HEADER_BYTES + binaryBytes : 0;
	const file = new Uint8Array(HEADER_BYTES + CHUNK_HEADER_BYTES + textBytes + binaryChunk);
	const header = new DataView(file.buffer);
	const words = [GLB_MAGIC, GLB_VERSION, file.length, textBytes, CHUNK_JSON];
	for (const [index, word] of words.entries()) header.setUint32(4 * index, word, true);
	const textStart = HEADER_BYTES + CHUNK_HEADER_BYTES;
	file.set(text, textStart);
	file.fill(0x20, textStart + text.length, textStart + textBytes);
	if (binaryBytes > 0) {
		const chunk = textStart + textBytes;
		header.setUint32(chunk, binaryBytes, true);
		header.setUint32(chunk + 4, CHUNK_BINARY, true);
		copyBinary(file.subarray(chunk + CHUNK_HEADER_BYTES));
	}
	return file;
}

/** Rounds a number of bytes up to a multiple of four, where every accessor and chunk begins. */
function aligned(bytes: number): number {
	return (bytes + 3) & ~3;
}

/** Returns glTF's code of an array's number type. */
function componentType(data: AccessorData): number {
	if (data instanceof Float32Array) return 5126;
	if (data instanceof Uint32Array) return 5125;
	if (data instanceof Uint16Array) return 5123;
	if (data instanceof Int16Array) return 5122;
	return data instanceof Int8Array ? 5120 : 5121;
}

/** Returns minimum and maximum of the first `components` of every `step` values, as they are stored. */
function bounds(data: AccessorData, components: number, step: number): { min: number[]; max: number[] } {
	const min = new Array<number>(components).fill(Number.POSITIVE_INFINITY);
	const max = new Array<number>(components).fill(Number.NEGATIVE_INFINITY);
	for (let i = 0; i < data.length; i += step) {
		for (let component = 0; component < components; component++) {
			const value = data[i + component];
			if (value < min[component]) min[component] = value;
			if (value > max[component]) max[component] = value;
		}
	}
	return { min: min.map(shortFloat), max: max.map(shortFloat) };
}
