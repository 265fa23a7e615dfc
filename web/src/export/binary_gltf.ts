/**
 * A writer of binary glTF 2.0 for what Panicle exports: one buffer, geometry and pictures. Small on purpose; why not a library
 * is in docs/export.md.
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
 * How the accessors of one buffer view lie. `target` and `stride` (bytes) only for vertices and indices; data comes
 * padded to the stride.
 */
export interface ViewLayout {
	target?: "vertices" | "indices";
	stride?: number;
}

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

/** Collects typed arrays in named buffer views; a view exists once something is in it, so that none is ever unused. */
export class BinaryGltf {
	readonly #views = new Map<string, { index: number; layout: ViewLayout; chunks: AccessorData[]; bytes: number }>();
	readonly #accessors: Accessor[] = [];
	readonly #layouts: Record<string, ViewLayout>;

	/** @param layouts every view that may be asked for, by name. */
	constructor(layouts: Record<string, ViewLayout>) {
		this.#layouts = layouts;
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
		const view = this.#view(viewName);
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

	/** The whole file. `json` is the document without `accessors`, `bufferViews` and `buffers`. */
	finish(json: Record<string, unknown>): Uint8Array<ArrayBuffer> {
		const bufferViews: Record<string, unknown>[] = [];
		let bytes = 0;
		for (const { layout, bytes: byteLength } of this.#views.values()) {
			const view: Record<string, unknown> = { buffer: 0, byteOffset: bytes, byteLength };
			if (layout.stride) view.byteStride = layout.stride;
			if (layout.target) view.target = TARGETS[layout.target];
			bufferViews.push(view);
			bytes += aligned(byteLength);
		}
		const geometry =
			bytes > 0 ? { accessors: this.#accessors, bufferViews, buffers: [{ byteLength: bytes }] } : undefined;
		return pack(JSON.stringify({ ...json, ...geometry }), bytes, (target) => this.#copy(target));
	}

	#view(name: string) {
		let view = this.#views.get(name);
		if (!view) {
			view = { index: this.#views.size, layout: this.#layouts[name] ?? {}, chunks: [], bytes: 0 };
			this.#views.set(name, view);
		}
		return view;
	}

	#copy(target: Uint8Array): void {
		let at = 0;
		for (const { chunks } of this.#views.values()) {
			for (const chunk of chunks) {
				target.set(new Uint8Array(chunk.buffer, chunk.byteOffset, chunk.byteLength), at);
				at += aligned(chunk.byteLength);
			}
		}
	}
}

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

/** Every accessor and chunk starts at a multiple of four bytes. */
function aligned(bytes: number): number {
	return (bytes + 3) & ~3;
}

function componentType(data: AccessorData): number {
	if (data instanceof Float32Array) return 5126;
	if (data instanceof Uint32Array) return 5125;
	if (data instanceof Uint16Array) return 5123;
	if (data instanceof Int16Array) return 5122;
	return data instanceof Int8Array ? 5120 : 5121;
}

/** Of the first `components` of every `step` values, as they are stored. */
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
