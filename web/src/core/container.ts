/**
 * The container: the only data that crosses between page and core, both ways. A directory of named arrays and their
 * data in a single block of bytes (layout: wasm-core/src/foundation/container.hpp), used for requests and answers.
 */

/** Types of an array's elements, by their numbers in the layout. */
export const ELEMENTS = ["text", "uint8", "int32", "uint32", "float32"] as const;
export type ElementType = (typeof ELEMENTS)[number];

export type ColumnData = Uint8Array | Int32Array | Uint32Array | Float32Array;

/** A named array to send to the core: numbers, or a text. */
export interface Block {
	readonly name: string;
	readonly data: ColumnData | string;
	/** Elements per row; 1 where absent. */
	readonly width?: number;
}

const MAGIC = 0x4c434e50; // "PNCL"
const LAYOUT = 3;
const HEADER_WORDS = 4;
/** Index of the header's word for the bytes of the whole block. */
const LENGTH_WORD = 3;
const ENTRY_WORDS = 6;
/** Index of an entry's word for the position of the data. */
const DATA_WORD = 5;

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** Encodes blocks as a container. Names are unique. */
export function writeContainer(blocks: readonly Block[]): Uint8Array<ArrayBuffer> {
	const entries = blocks.map(({ name, data, width = 1 }) => ({
		name: encoder.encode(name),
		element: elementOf(data),
		bytes: typeof data === "string" ? encoder.encode(data) : bytesOf(data),
		count: typeof data === "string" ? undefined : data.length / width,
		width,
	}));
	let at = 4 * (HEADER_WORDS + ENTRY_WORDS * entries.length);
	const placed = entries.map((entry) => {
		const name = at;
		const data = name + padded(entry.name.length);
		at = data + padded(entry.bytes.length);
		return { ...entry, nameAt: name, dataAt: data };
	});
	const whole = new Uint8Array(at);
	const words = new Uint32Array(whole.buffer);
	words.set([MAGIC, LAYOUT, entries.length, at]);
	placed.forEach(({ name, nameAt, element, width, count, bytes, dataAt }, index) => {
		const row = HEADER_WORDS + ENTRY_WORDS * index;
		words.set([nameAt, name.length, element, width, count ?? bytes.length, dataAt], row);
		whole.set(name, nameAt);
		whole.set(bytes, dataAt);
	});
	return whole;
}

/**
 * Copies a container out of a WebAssembly memory as one block. To save a copy, the core leaves large arrays in place,
 * outside of its block: their positions in the directory may point anywhere in the memory, counted from `at` modulo
 * 2^32. The copy has these arrays appended to the block, and their positions are rewritten.
 * @throws RangeError where an array lies outside of the memory
 */
export function copyContainer(memory: ArrayBuffer, at: number): Uint8Array<ArrayBuffer> {
	const [, , count, length] = new Uint32Array(memory, at, HEADER_WORDS);
	const directory = new Uint32Array(memory, at + 4 * HEADER_WORDS, ENTRY_WORDS * count);
	const outside: { entry: number; from: number; bytes: number; to: number }[] = [];
	let copyLength = length;
	for (let entry = 0; entry < directory.length; entry += ENTRY_WORDS) {
		const [, , element, width, rows, data] = directory.subarray(entry, entry + ENTRY_WORDS);
		const bytes = width * rows * bytesPerElement(element);
		if (data + bytes <= length) continue;
		outside.push({ entry, from: (at + data) >>> 0, bytes, to: copyLength });
		copyLength += padded(bytes);
	}
	const copy = new Uint8Array(copyLength);
	copy.set(new Uint8Array(memory, at, length));
	const words = new Uint32Array(copy.buffer);
	words[LENGTH_WORD] = copyLength;
	for (const { entry, from, bytes, to } of outside) {
		copy.set(new Uint8Array(memory, from, bytes), to);
		words[HEADER_WORDS + entry + DATA_WORD] = to;
	}
	return copy;
}

/** Returns the bytes of an element by its type, an index of `ELEMENTS`. */
const bytesPerElement = (element: number): number => (element <= ELEMENTS.indexOf("uint8") ? 1 : 4);

interface Column {
	readonly element: ElementType;
	readonly width: number;
	readonly data: ColumnData;
}

/** The arrays of a container, by name. They are views of the container's bytes and belong to its owner. */
export class Columns {
	readonly #columns = new Map<string, Column>();

	/**
	 * @param bytes written by `writeContainer` or the core; the view must begin at a multiple of four
	 * @throws RangeError where the bytes are no container
	 */
	constructor(readonly bytes: Uint8Array<ArrayBuffer>) {
		if (bytes.byteOffset % 4 !== 0 || bytes.length < 4 * HEADER_WORDS) throw new RangeError("No container.");
		const words = new Uint32Array(bytes.buffer, bytes.byteOffset, Math.floor(bytes.length / 4));
		const [magic, layout, count, length] = words;
		if (magic !== MAGIC || layout !== LAYOUT || length !== bytes.length) throw new RangeError("No container.");
		for (let row = HEADER_WORDS; row < HEADER_WORDS + ENTRY_WORDS * count; row += ENTRY_WORDS) {
			const [nameAt, nameLength, element, width, rows, dataAt] = words.subarray(row, row + ENTRY_WORDS);
			const name = decoder.decode(bytes.subarray(nameAt, nameAt + nameLength));
			this.#columns.set(name, {
				element: ELEMENTS[element],
				width,
				data: typedView(bytes, element, width * rows, dataAt),
			});
		}
	}

	/** Returns whether there is a column of that name. */
	has(name: string): boolean {
		return this.#columns.has(name);
	}

	/** The names of all columns. */
	get names(): string[] {
		return [...this.#columns.keys()];
	}

	/** Returns the number of elements per row of a column. */
	width(name: string): number {
		return this.#column(name).width;
	}

	/** Returns a text. Throws a RangeError, as all of these do, where there is no such column of that type. */
	text(name: string): string {
		return decoder.decode(this.#dataOf(name, "text"));
	}

	/** Returns the non-empty lines of a text; none where there is no such text. */
	lines(name: string): string[] {
		return this.has(name) ? this.text(name).split("\n").filter(Boolean) : [];
	}

	/** Returns a column of float32 numbers. */
	floats(name: string): Float32Array<ArrayBuffer> {
		return this.#dataOf(name, "float32") as Float32Array<ArrayBuffer>;
	}

	/** Returns a column of int32 numbers. */
	ints(name: string): Int32Array<ArrayBuffer> {
		return this.#dataOf(name, "int32") as Int32Array<ArrayBuffer>;
	}

	/** Returns a column of uint32 numbers. */
	uint32(name: string): Uint32Array<ArrayBuffer> {
		return this.#dataOf(name, "uint32") as Uint32Array<ArrayBuffer>;
	}

	/** Returns a column of bytes. */
	uint8(name: string): Uint8Array<ArrayBuffer> {
		return this.#dataOf(name, "uint8") as Uint8Array<ArrayBuffer>;
	}

	/** Returns a column of any element type. */
	any(name: string): ColumnData {
		return this.#column(name).data;
	}

	/** Returns a column; throws a RangeError where there is none of that name. */
	#column(name: string): Column {
		const column = this.#columns.get(name);
		if (!column) throw new RangeError(`There is no column “${name}”.`);
		return column;
	}

	/** Returns the data of a column; throws a RangeError where its elements are of another type. */
	#dataOf(name: string, element: ElementType): ColumnData {
		const column = this.#column(name);
		if (column.element !== element) throw new RangeError(`Column “${name}” is ${column.element}, not ${element}.`);
		return column.data;
	}
}

/** Returns the type of an array's elements as an index of `ELEMENTS`; of a text 0. */
function elementOf(data: Block["data"]): number {
	if (typeof data === "string") return 0;
	if (data instanceof Uint8Array) return 1;
	if (data instanceof Int32Array) return 2;
	return data instanceof Uint32Array ? 3 : 4;
}

/** Returns the bytes of a typed array, without copying them. */
function bytesOf({ buffer, byteOffset, byteLength }: ColumnData): Uint8Array {
	return new Uint8Array(buffer, byteOffset, byteLength);
}

/**
 * Returns a typed array of `length` elements over the container's own bytes, from byte `at` on; text is viewed as
 * bytes.
 * @param element index of `ELEMENTS`
 */
function typedView(
	{ buffer, byteOffset }: Uint8Array<ArrayBuffer>,
	element: number,
	length: number,
	at: number,
): ColumnData {
	const from = byteOffset + at;
	if (element === 2) return new Int32Array(buffer, from, length);
	if (element === 3) return new Uint32Array(buffer, from, length);
	if (element === 4) return new Float32Array(buffer, from, length);
	return new Uint8Array(buffer, from, length);
}

/** Rounds up to a multiple of four: every array begins at a 32-bit word. */
function padded(bytes: number): number {
	return (bytes + 3) & ~3;
}
