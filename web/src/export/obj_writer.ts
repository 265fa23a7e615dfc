/** The statements of an OBJ, object by object: positions, normals, then the faces between them. */
import type { Mesh } from "../models/bunch/grown";
import { TextBuffer } from "./text_buffer";

/** Of a metre: a micrometre. */
const POSITION_DECIMALS = 6;
/** Of a unit vector, or of a texture's width: a shade no display shows. */
const SHADE_DECIMALS = 4;
const SPACE = 0x20;
const SLASH = 0x2f;
const LINE_END = 0x0a;

/** OBJ counts vertices, normals and texture coordinates from 1 through the whole file. */
export class ObjWriter {
	readonly #out: TextBuffer;
	/** Of all objects so far, the present one's included. */
	#vertices = 0;
	/** Of the present object. */
	#first = 0;
	#uvs = 0;

	/** @param capacity bytes to begin with */
	constructor(capacity: number) {
		this.#out = new TextBuffer(capacity);
	}

	line(text: string): void {
		this.#out.text(`${text.replace(/[\r\n]+/g, " ")}\n`);
	}

	/** Begins an object, `name` with underscores for spaces; with a mesh, writes all of it. */
	object(name: string, mesh?: Mesh, material = ""): void {
		this.line(`o ${name.replaceAll(" ", "_")}`);
		this.#first = this.#vertices;
		if (!mesh) return;
		this.positions(mesh.positions);
		this.normals(mesh.normals);
		this.faces(mesh.indices, material, this.textureCoordinates(mesh.uvs));
	}

	positions(values: Float32Array | Float64Array): void {
		this.#vertices += values.length / 3;
		this.#vectors("v ", values, POSITION_DECIMALS);
	}

	normals(values: Float32Array | Float64Array): void {
		this.#vectors("vn ", values, SHADE_DECIMALS);
	}

	/**
	 * Returns the number of the first. OBJ measures v from the picture's lower edge, Panicle and glTF from the upper one:
	 * turned over, so that the same picture fits both files.
	 */
	textureCoordinates(uvs: Float32Array): number {
		const out = this.#out;
		for (let i = 0; i < uvs.length; i += 2) {
			out.word("vt ");
			out.fixed(uvs[i], SHADE_DECIMALS, SPACE);
			out.fixed(1 - uvs[i + 1], SHADE_DECIMALS, LINE_END);
		}
		const first = this.#uvs + 1;
		this.#uvs += uvs.length / 2;
		return first;
	}

	/** Index i is the object's vertex and normal i, texture coordinate `firstUv + i` of the file. */
	faces(indices: Uint32Array, material: string, firstUv: number): void {
		const out = this.#out;
		this.line(`usemtl ${material}`);
		for (let i = 0; i < indices.length; i++) {
			const corner = i % 3;
			if (corner === 0) out.word("f ");
			const vertex = this.#first + 1 + indices[i];
			out.integer(vertex, SLASH);
			out.integer(firstUv + indices[i], SLASH);
			out.integer(vertex, corner === 2 ? LINE_END : SPACE);
		}
	}

	toString(): string {
		return this.#out.toString();
	}

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
