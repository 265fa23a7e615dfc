/**
 * Grown → Wavefront OBJ with MTL, as the paper exports: metres, +Y up, every berry baked. The objects have the names
 * of the GLB's nodes, with underscores for spaces. What is in the files is in docs/export.md.
 */
import type { Grown, Mesh, StemMesh, StemPart } from "../core/grown";
import { encodeQuery } from "../specimen/link";
import type { Look, Specimen } from "../specimen/specimen";
import { GENERATOR } from "./generator";
import { type Material, skinMaterial, srgb, stemMaterial } from "./materials";
import { requireMeshes } from "./meshes";
import { berryName, plantName, stemName } from "./names";
import { rounded } from "./numbers";
import { fromUp, type Rows, rows } from "./orientation";
import { TextBuffer } from "./text_buffer";

/** Of a metre: a micrometre. */
const POSITION_DECIMALS = 6;
/** Of a unit vector, or of a texture's width: a shade no display shows. */
const SHADE_DECIMALS = 4;
/** What a vertex is likely to take with its share of the faces, in bytes; only a guess to begin with. */
const BYTES_PER_VERTEX = 160;
const SPACE = 0x20;
const SLASH = 0x2f;
const LINE_END = 0x0a;
const LETTER_F = 0x66;
const LETTER_N = 0x6e;
const LETTER_T = 0x74;
const LETTER_V = 0x76;
/** Light that the skin returns as a highlight, for readers that know no physically based values. */
const SPECULAR = { Skin: 0.25, Stem: 0.04 } as const;

/**
 * The two texts. `name` is what the files are called without their endings: the OBJ asks for `name.mtl`. Throws when
 * `grown` was asked for without meshes.
 */
export function exportObj(grown: Grown, specimen: Specimen, name: string): { obj: string; mtl: string } {
	const { stem, berry } = requireMeshes(grown);
	const vertices = (stem.positions.length + grown.berries.count * berry.positions.length) / 3;
	const writer = new ObjWriter(BYTES_PER_VERTEX * vertices);
	writer.line(`# ${GENERATOR}: ${plantName(specimen)}, metres, +Y up`);
	writer.line(`# ${encodeQuery(specimen)}`);
	writer.line(`mtllib ${name}.mtl`);
	for (const part of stem.parts) if (part.indexCount > 0) writer.stem(stem, part);
	if (grown.berries.count > 0) writer.berries(grown, berry);
	return { obj: writer.toString(), mtl: writeMtl(specimen.look) };
}

/** OBJ counts vertices, normals and texture coordinates from 1 through the whole file. */
class ObjWriter {
	readonly #out: TextBuffer;
	#vertices = 0;
	#uvs = 0;

	constructor(capacity: number) {
		this.#out = new TextBuffer(capacity);
	}

	line(text: string): void {
		this.#out.text(`${text.replace(/[\r\n]+/g, " ")}\n`);
	}

	stem(stem: StemMesh, part: StemPart): void {
		const last = part.firstVertex + part.vertexCount;
		this.#object(stemName(part.axis));
		for (let i = part.firstVertex; i < last; i++) {
			const [x, y, z] = at3(stem.positions, i);
			this.#position(x, y, z);
		}
		for (let i = part.firstVertex; i < last; i++) {
			const [x, y, z] = at3(stem.normals, i);
			this.#normal(x, y, z);
		}
		const firstUv = this.#textureCoordinates(stem.uvs.subarray(2 * part.firstVertex, 2 * last));
		this.line("usemtl Stem");
		const indices = stem.indices.subarray(part.firstIndex, part.firstIndex + part.indexCount);
		this.#faces(indices, this.#vertices + 1 - part.firstVertex, firstUv - part.firstVertex);
		this.#vertices += part.vertexCount;
	}

	/** All berries share one run of texture coordinates. */
	berries({ berries }: Grown, berry: Mesh): void {
		const firstUv = this.#textureCoordinates(berry.uvs);
		const vertexCount = berry.positions.length / 3;
		for (let i = 0; i < berries.count; i++) {
			const [dx, dy, dz] = at3(berries.directions, i);
			this.#object(berryName(i, berries.count));
			this.#baked(berry, berries.spheres.subarray(4 * i, 4 * i + 4), rows(fromUp(dx, dy, dz)));
			this.line("usemtl Skin");
			this.#faces(berry.indices, this.#vertices + 1, firstUv);
			this.#vertices += vertexCount;
		}
	}

	toString(): string {
		return this.#out.toString();
	}

	#object(name: string): void {
		this.line(`o ${name.replaceAll(" ", "_")}`);
	}

	/** The shared berry turned by `turn`, scaled and moved to its place; `sphere` is centre and radius. */
	#baked(berry: Mesh, sphere: Float32Array, turn: Rows): void {
		const [a, b, c, d, e, f, g, h, k] = turn;
		const [cx, cy, cz, radius] = sphere as unknown as [number, number, number, number];
		const count = berry.positions.length / 3;
		for (let i = 0; i < count; i++) {
			const [x, y, z] = at3(berry.positions, i);
			this.#position(
				cx + radius * (a * x + b * y + c * z),
				cy + radius * (d * x + e * y + f * z),
				cz + radius * (g * x + h * y + k * z),
			);
		}
		for (let i = 0; i < count; i++) {
			const [x, y, z] = at3(berry.normals, i);
			this.#normal(a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + k * z);
		}
	}

	#position(x: number, y: number, z: number): void {
		this.#out.character(LETTER_V);
		this.#numbers(x, y, z, POSITION_DECIMALS);
	}

	#normal(x: number, y: number, z: number): void {
		this.#out.character(LETTER_V);
		this.#out.character(LETTER_N);
		this.#numbers(x, y, z, SHADE_DECIMALS);
	}

	#numbers(x: number, y: number, z: number, decimals: number): void {
		const out = this.#out;
		out.character(SPACE);
		out.fixed(x, decimals);
		out.character(SPACE);
		out.fixed(y, decimals);
		out.character(SPACE);
		out.fixed(z, decimals);
		out.character(LINE_END);
	}

	/**
	 * Returns the number of the first. OBJ measures v from the picture's lower edge, Panicle and glTF from the upper one:
	 * turned over, so that the same picture fits both files.
	 */
	#textureCoordinates(uvs: Float32Array): number {
		const out = this.#out;
		for (let i = 0; i < uvs.length; i += 2) {
			out.character(LETTER_V);
			out.character(LETTER_T);
			out.character(SPACE);
			out.fixed(uvs[i], SHADE_DECIMALS);
			out.character(SPACE);
			out.fixed(1 - uvs[i + 1], SHADE_DECIMALS);
			out.character(LINE_END);
		}
		const first = this.#uvs + 1;
		this.#uvs += uvs.length / 2;
		return first;
	}

	/** Index i is vertex and normal `firstVertex + i`, texture coordinate `firstUv + i` of the file. */
	#faces(indices: Uint32Array, firstVertex: number, firstUv: number): void {
		const out = this.#out;
		for (let i = 0; i < indices.length; i++) {
			if (i % 3 === 0) out.character(LETTER_F);
			const vertex = firstVertex + indices[i];
			out.character(SPACE);
			out.integer(vertex);
			out.character(SLASH);
			out.integer(firstUv + indices[i]);
			out.character(SLASH);
			out.integer(vertex);
			if (i % 3 === 2) out.character(LINE_END);
		}
	}
}

function at3(values: Float32Array, index: number): [number, number, number] {
	return [values[3 * index], values[3 * index + 1], values[3 * index + 2]];
}

/** MTL's own values, then the physically based ones that newer readers know (Pr roughness, Pm metallic). */
function writeMtl(look: Look): string {
	const blocks = [
		{ material: skinMaterial(look), hex: look.skin },
		{ material: stemMaterial(look), hex: look.stem },
	].map(({ material, hex }) => mtlBlock(material, hex));
	return [`# ${GENERATOR}\n`, ...blocks].join("\n");
}

function mtlBlock({ name, roughness, sheen }: Material, hex: string): string {
	const specular = SPECULAR[name];
	const lines = [
		`newmtl ${name}`,
		`Kd ${srgb(hex)
			.map((value) => rounded(value, 4))
			.join(" ")}`,
		`Ks ${specular} ${specular} ${specular}`,
		// Blinn–Phong's exponent of the same width of highlight as this roughness.
		`Ns ${rounded(2 / roughness ** 4 - 2, 1)}`,
		"d 1",
		"illum 2",
		`Pr ${roughness}`,
		"Pm 0",
	];
	if (sheen) lines.push(`Ps ${Math.max(...sheen.colour)}`);
	return `${lines.join("\n")}\n`;
}
