/** The statements of an OBJ, object by object: positions, normals, then the faces between them. */
import { TextBuffer } from "./text_buffer";

/** Decimals of a metre: a micrometre. */
const POSITION_DECIMALS = 6;
/** Decimals of a unit vector, or of texture coordinates: an invisible error. */
const SHADE_DECIMALS = 4;
const SPACE = 0x20;
const SLASH = 0x2f;
const LINE_END = 0x0a;

/** Triangles in the plant's frame. */
export interface ObjMesh {
	positions: Float32Array | Float64Array;
	normals: Float32Array | Float64Array;
	uvs: Float32Array;
	indices: Uint32Array;
}

/** Writes objects. OBJ counts vertices, normals and texture coordinates from 1 through the whole file. */
export class ObjWriter {
	readonly #out = new TextBuffer();
	/** Vertices of all objects so far. */
	#vertices = 0;
	#uvs = 0;
	/** The number of the first coordinate of each shared array. */
	readonly #known = new Map<Float32Array, number>();

	/** Writes a line; line breaks in the text become blanks. */
	line(text: string): void {
		this.#out.text(`${text.replace(/[\r\n]+/g, " ")}\n`);
	}

	/** Writes an object, `name` with underscores for spaces. Shared texture coordinates are written once. */
	object(name: string, { positions, normals, uvs, indices }: ObjMesh, material: string): void {
		this.line(`o ${name.replaceAll(" ", "_")}`);
		const first = this.#vertices + 1;
		this.#vertices += positions.length / 3;
		this.#vectors("v ", positions, POSITION_DECIMALS);
		this.#vectors("vn ", normals, SHADE_DECIMALS);
		this.#faces(indices, material, first, this.#textureCoordinates(uvs));
	}

	/** All statements; write nothing afterwards. */
	get text(): TextBuffer {
		return this.#out;
	}

	/**
	 * Writes texture coordinates, unless the same array has been written; returns the number of the first coordinate. OBJ
	 * measures v from the picture's lower edge, Panicle and glTF from the upper one: v is flipped, so that the same
	 * picture fits both files.
	 */
	#textureCoordinates(uvs: Float32Array): number {
		const known = this.#known.get(uvs);
		if (known !== undefined) return known;
		const out = this.#out;
		for (let i = 0; i < uvs.length; i += 2) {
			out.word("vt ");
			out.fixed(uvs[i], SHADE_DECIMALS, SPACE);
			out.fixed(1 - uvs[i + 1], SHADE_DECIMALS, LINE_END);
		}
		const first = this.#uvs + 1;
		this.#uvs += uvs.length / 2;
		this.#known.set(uvs, first);
		return first;
	}

	/** Writes the triangles: index i is vertex and normal `first + i`, texture coordinate `firstUv + i` of the file. */
	#faces(indices: Uint32Array, material: string, first: number, firstUv: number): void {
		const out = this.#out;
		this.line(`usemtl ${material}`);
		for (let i = 0; i < indices.length; i++) {
			const corner = i % 3;
			if (corner === 0) out.word("f ");
			const vertex = first + indices[i];
			out.integer(vertex, SLASH);
			out.integer(firstUv + indices[i], SLASH);
			out.integer(vertex, corner === 2 ? LINE_END : SPACE);
		}
	}

	/** Writes one line per vector of three numbers. */
	#vectors(keyword: string, values: Float32Array | Float64Array, decimals: number): void {
		const out = this.#out;
		for (let i = 0; i < values.length; i += 3) {
			out.word(keyword);
			out.fixed(values[i], decimals, SPACE);
			out.fixed(values[i + 1], decimals, SPACE);
			out.fixed(values[i + 2], decimals, LINE_END);
		}
	}
}
