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

type Vector = [x: number, y: number, z: number];

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
		this.#vectors("v ", stem.positions.subarray(3 * part.firstVertex, 3 * last), POSITION_DECIMALS);
		this.#vectors("vn ", stem.normals.subarray(3 * part.firstVertex, 3 * last), SHADE_DECIMALS);
		const firstUv = this.#textureCoordinates(stem.uvs.subarray(2 * part.firstVertex, 2 * last));
		this.line("usemtl Stem");
		const indices = stem.indices.subarray(part.firstIndex, part.firstIndex + part.indexCount);
		this.#faces(indices, this.#vertices + 1 - part.firstVertex, firstUv - part.firstVertex);
		this.#vertices += part.vertexCount;
	}

	/** All berries share one run of texture coordinates. */
	berries({ berries }: Grown, berry: Mesh): void {
		const firstUv = this.#textureCoordinates(berry.uvs);
		const turned = new Float64Array(berry.positions.length);
		for (let i = 0; i < berries.count; i++) {
			const [x, y, z, radius] = berries.spheres.subarray(4 * i, 4 * i + 4);
			const [dx, dy, dz] = berries.directions.subarray(3 * i, 3 * i + 3);
			const turn = rows(fromUp(dx, dy, dz));
			this.#object(berryName(i, berries.count));
			this.#vectors("v ", placed(berry.positions, turn, radius, [x, y, z], turned), POSITION_DECIMALS);
			this.#vectors("vn ", placed(berry.normals, turn, 1, [0, 0, 0], turned), SHADE_DECIMALS);
			this.line("usemtl Skin");
			this.#faces(berry.indices, this.#vertices + 1, firstUv);
			this.#vertices += berry.positions.length / 3;
		}
	}

	toString(): string {
		return this.#out.toString();
	}

	#object(name: string): void {
		this.line(`o ${name.replaceAll(" ", "_")}`);
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

	/**
	 * Returns the number of the first. OBJ measures v from the picture's lower edge, Panicle and glTF from the upper one:
	 * turned over, so that the same picture fits both files.
	 */
	#textureCoordinates(uvs: Float32Array): number {
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

	/** Index i is vertex and normal `firstVertex + i`, texture coordinate `firstUv + i` of the file. */
	#faces(indices: Uint32Array, firstVertex: number, firstUv: number): void {
		const out = this.#out;
		for (let i = 0; i < indices.length; i++) {
			const corner = i % 3;
			if (corner === 0) out.word("f ");
			const vertex = firstVertex + indices[i];
			out.integer(vertex, SLASH);
			out.integer(firstUv + indices[i], SLASH);
			out.integer(vertex, corner === 2 ? LINE_END : SPACE);
		}
	}
}

/** `vectors` turned, scaled and moved, written into `into` and returned. */
function placed(vectors: Float32Array, turn: Rows, scale: number, centre: Vector, into: Float64Array): Float64Array {
	const [a, b, c, d, e, f, g, h, k] = turn;
	const [cx, cy, cz] = centre;
	for (let i = 0; i < vectors.length; i += 3) {
		const x = vectors[i];
		const y = vectors[i + 1];
		const z = vectors[i + 2];
		into[i] = cx + scale * (a * x + b * y + c * z);
		into[i + 1] = cy + scale * (d * x + e * y + f * z);
		into[i + 2] = cz + scale * (g * x + h * y + k * z);
	}
	return into;
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
