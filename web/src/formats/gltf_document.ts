/**
 * A glTF document under construction: nodes, meshes, materials and their buffer; validators require that each is in
 * use. Meshes are written in full (float32, read everywhere) or compact (KHR_mesh_quantization).
 */
import type { Mesh } from "../plant/plant";
import { AnimationWriter, keysOf, type Moment, swingKeys } from "./animation";
import { type AccessorData, BinaryGltf, COMPRESSION, type Encoder, type ViewLayout } from "./binary_gltf";
import { GENERATOR } from "./generator";
import type { GltfMaterial } from "./gltf_material";
import { shortFloat } from "./numbers";
import { quantised, quantisedNormals, quantisedTangents, relative, wholeBounds } from "./quantise";

export type Json = Record<string, unknown>;

export const QUANTIZATION = "KHR_mesh_quantization";
const LOD = "MSFT_lod";

/** One view for each kind of data, shared by all meshes. Attributes of instances are not vertices: no target there. */
const VIEWS: Record<string, ViewLayout> = {
	positions: { target: "vertices", stride: 12 },
	normals: { target: "vertices", stride: 12 },
	shortPositions: { target: "vertices", stride: 8 },
	byteNormals: { target: "vertices", stride: 4 },
	tangents: { target: "vertices", stride: 16 },
	byteTangents: { target: "vertices", stride: 4 },
	uvs: { target: "vertices", stride: 8 },
	shortUvs: { target: "vertices", stride: 4 },
	colours: { target: "vertices", stride: 4 },
	winds: { target: "vertices", stride: 4 },
	shortIndices: { target: "indices" },
	longIndices: { target: "indices" },
	swings: { target: "vertices", stride: 12 },
	times: {},
	weights: {},
	sizes: {},
	translations: {},
	rotations: {},
	scales: {},
};

/** Samplers: smooth, with mipmaps; without and with repetition. */
const CLAMPED = { magFilter: 9729, minFilter: 9987, wrapS: 33071, wrapT: 33071 };
const REPEATED = { magFilter: 9729, minFilter: 9987, wrapS: 10497, wrapT: 10497 };

/** The most vertices for 16-bit indices; 65535 itself restarts a strip. */
const SHORT_INDEX_VERTICES = 65535;

/** Texture coordinates and triangles that meshes may share. */
interface Pattern {
	/** Absent where there are none. */
	uvs?: number;
	indices: number;
}

export interface MeshOptions {
	/** The origin of the mesh; without it the origin stays. */
	centre?: readonly number[];
	/** 4 × vertices. */
	colours?: Uint8Array;
	/** 4 × vertices (tangents.ts). */
	tangents?: Float32Array;
	/** 3 × vertices each: displacement by a sine and a cosine of time. */
	swing?: readonly [sine: Float32Array, cosine: Float32Array];
}

/** One of several draw calls of a mesh, with data for shaders of games. */
export interface Primitive {
	readonly mesh: Mesh;
	/** Index of the material. */
	readonly material: number;
	/** 4 × vertices: the first vertex colours, which multiply the material's colour, and the second ones, which are data. */
	readonly colours?: Uint8Array | undefined;
	readonly data?: Uint8Array | undefined;
	/** 4 × vertices (tangents.ts). */
	readonly tangents?: Float32Array | undefined;
	/** 2 × vertices each, 0 … 65535 for 0 … 1: the second and third texture coordinates. */
	readonly furtherUvs?: readonly Uint16Array[] | undefined;
}

/** A mesh to draw by a node: its index, origin, and unit of its coordinates. */
export interface Placed {
	mesh: number;
	origin: readonly number[];
	unit: number;
}

const ORIGIN = [0, 0, 0];

export class GltfDocument {
	readonly #binary: BinaryGltf;
	readonly #nodes: Json[] = [];
	readonly #meshes: Json[] = [];
	readonly #materials: Json[] = [];
	readonly #images: Json[] = [];
	readonly #textures: Json[] = [];
	readonly #samplers: Json[] = [];
	readonly #animation = new AnimationWriter();
	/** Accessors of the keys that all swinging nodes share. */
	#swing: { input: number; output: number } | undefined;
	/** Accessors of shared texture coordinates and triangles. */
	readonly #charts = new Map<Float32Array, number>();
	readonly #lists = new Map<Uint32Array, number>();
	readonly #used = new Set<string>();
	readonly #required = new Set<string>();

	/** @param encoder compresses meshes, which are then compact (EXT_meshopt_compression) */
	constructor(
		readonly compact: boolean,
		encoder?: Encoder,
	) {
		this.#binary = new BinaryGltf(VIEWS, encoder);
		if (encoder) this.require(COMPRESSION);
	}

	/** Appends a node; returns its index. A list of children may still grow. */
	node(node: Json): number {
		return this.#nodes.push(node) - 1;
	}

	/** Appends a material; returns its index. */
	material(material: GltfMaterial): number {
		for (const name of Object.keys(material.extensions ?? {})) this.#used.add(name);
		return this.#materials.push({ ...material }) - 1;
	}

	/**
	 * Appends a PNG; returns the index of its texture.
	 * @param repeats whether it repeats beyond its edges
	 */
	texture(name: string, bytes: Uint8Array, repeats = false): number {
		const bufferView = this.#binary.raw(bytes);
		const source = this.#images.push({ name, mimeType: "image/png", bufferView }) - 1;
		const samplerSettings = repeats ? REPEATED : CLAMPED;
		if (!this.#samplers.includes(samplerSettings)) this.#samplers.push(samplerSettings);
		return this.#textures.push({ name, source, sampler: this.#samplers.indexOf(samplerSettings) }) - 1;
	}

	/** Requires an extension: readers without it must not read the file. */
	require(extension: string): void {
		this.#used.add(extension);
		this.#required.add(extension);
	}

	/** Makes a node visible only at its moment, by its scale. */
	show(node: Json, index: number, moment: Moment): void {
		const { times, scales, scale } = keysOf(moment);
		if (scale === 0) node.scale = [0, 0, 0];
		const input = this.#binary.add("times", Float32Array.from(times), "SCALAR", { bounds: true });
		const output = this.#binary.add("sizes", Float32Array.from(scales), "VEC3");
		this.#animation.step(index, "scale", input, output);
	}

	/** Animates the swing of a node's mesh. */
	swing(index: number): void {
		this.#swing ??= this.#swingKeys();
		this.#animation.run(index, "weights", this.#swing.input, this.#swing.output);
	}

	/** Writes the keys of a swing, which all swinging nodes share; returns their accessors. */
	#swingKeys() {
		const { times, weights } = swingKeys();
		return {
			input: this.#binary.add("times", Float32Array.from(times), "SCALAR", { bounds: true }),
			output: this.#binary.add("weights", Float32Array.from(weights), "SCALAR"),
		};
	}

	/**
	 * Gives a node its coarser levels of detail (MSFT_lod).
	 * @param others from near to far
	 * @param coverage the least share of the view's area that it covers at each level, its own first
	 */
	levels(others: readonly number[], index: number | undefined, coverage: readonly number[]): void {
		if (index === undefined || others.length === 0) return;
		const node = this.#nodes[index];
		node.extensions = { [LOD]: { ids: others } };
		node.extras = { ...(node.extras as Json), MSFT_screencoverage: coverage };
		this.#used.add(LOD);
	}

	/** Appends attributes of instances to the view of that name; returns the accessor. */
	instances(view: "translations" | "rotations" | "scales", data: AccessorData): number {
		return this.#binary.add(view, data, view === "rotations" ? "VEC4" : "VEC3");
	}

	/**
	 * Appends a mesh of one material; arrays of texture coordinates and triangles that are already in the file are
	 * shared.
	 */
	mesh(name: string, mesh: Mesh, material: number, { centre, colours, tangents, swing }: MeshOptions = {}): Placed {
		const { attributes, ...place } = this.compact
			? this.#compactAttributes(mesh, centre)
			: this.#fullAttributes(mesh, centre);
		const { uvs, indices } = this.#pattern(mesh);
		if (uvs !== undefined) attributes.TEXCOORD_0 = uvs;
		if (tangents) attributes.TANGENT = this.#tangents(tangents);
		if (colours) attributes.COLOR_0 = this.#binary.add("colours", colours, "VEC4", { normalized: true });
		const targets = swing?.map((each) => ({ POSITION: this.#binary.add("swings", each, "VEC3", { bounds: true }) }));
		const moved = targets ? { weights: [0, 0], extras: { targetNames: ["sine", "cosine"] } } : {};
		const primitive = { attributes, indices, material, ...(targets ? { targets } : {}) };
		const index = this.#meshes.push({ name, primitives: [primitive], ...moved }) - 1;
		return { mesh: index, ...place };
	}

	/** Appends a mesh of several materials; texture coordinates within one picture take half the size. */
	meshOf(name: string, primitives: readonly Primitive[]): number {
		const written = primitives.map(({ mesh, material, colours, data, tangents, furtherUvs = [] }) => {
			const { attributes } = this.#fullAttributes(mesh);
			if (tangents) attributes.TANGENT = this.#tangents(tangents);
			const bytes = (values: Uint8Array) => this.#binary.add("winds", values, "VEC4", { normalized: true });
			if (mesh.uvs.length > 0) attributes.TEXCOORD_0 = this.#textureCoordinates(mesh.uvs, true);
			for (const [i, uvs] of furtherUvs.entries())
				attributes[`TEXCOORD_${i + 1}`] = this.#binary.add("shortUvs", uvs, "VEC2", { normalized: true });
			if (colours) attributes.COLOR_0 = bytes(colours);
			if (data) attributes.COLOR_1 = bytes(data);
			return { attributes, indices: this.#triangles(mesh.indices, mesh.positions.length / 3), material };
		});
		return this.#meshes.push({ name, primitives: written }) - 1;
	}

	/**
	 * Writes the whole file.
	 * @param roots nodes of the scene that programs show
	 * @param further other scenes, for programs that read more than one
	 */
	finish(roots: number[], extras: Json, further: readonly Json[] = []): Uint8Array<ArrayBuffer> {
		return this.#binary.finish({
			asset: { version: "2.0", generator: GENERATOR, extras },
			...withoutEmpty({ extensionsUsed: [...this.#used], extensionsRequired: [...this.#required] }),
			scene: 0,
			scenes: [{ nodes: roots }, ...further],
			nodes: this.#nodes,
			...withoutEmpty({
				meshes: this.#meshes,
				materials: this.#materials,
				textures: this.#textures,
				images: this.#images,
				samplers: this.#samplers,
				animations: this.#animation.written(this.#swing ? "Wind" : "Growth"),
			}),
		});
	}

	/** Writes tangents, in compact meshes as bytes. */
	#tangents(tangents: Float32Array): number {
		if (!this.compact) return this.#binary.add("tangents", tangents, "VEC4");
		return this.#binary.add("byteTangents", quantisedTangents(tangents), "VEC4", { normalized: true });
	}

	/** Writes a mesh's texture coordinates and triangles, or finds those already in the file. */
	#pattern({ positions, uvs, indices }: Mesh): Pattern {
		const pattern: Pattern = { indices: this.#triangles(indices, positions.length / 3) };
		if (uvs.length > 0) pattern.uvs = this.#charts.get(uvs) ?? this.#textureCoordinates(uvs);
		if (pattern.uvs !== undefined) this.#charts.set(uvs, pattern.uvs);
		return pattern;
	}

	/**
	 * Returns the accessor of triangles, written once for all meshes that share the array; with 16-bit indices where the
	 * number of vertices allows them.
	 */
	#triangles(indices: Uint32Array, vertices: number): number {
		const known = this.#lists.get(indices);
		if (known !== undefined) return known;
		const list =
			vertices <= SHORT_INDEX_VERTICES
				? this.#binary.add("shortIndices", Uint16Array.from(indices), "SCALAR")
				: this.#binary.add("longIndices", indices, "SCALAR");
		this.#lists.set(indices, list);
		return list;
	}

	/** Writes texture coordinates; in short ones, those within one picture take half the size. */
	#textureCoordinates(uvs: Float32Array, short = this.compact): number {
		const within = short && uvs.every((value) => value >= 0 && value <= 1);
		if (!within) return this.#binary.add("uvs", uvs, "VEC2");
		return this.#binary.add(
			"shortUvs",
			Uint16Array.from(uvs, (value) => Math.round(65535 * value)),
			"VEC2",
			{ normalized: true },
		);
	}

	/** Writes positions and normals as floats, positions relative to `centre`. */
	#fullAttributes({ positions, normals }: Mesh, centre?: readonly number[]) {
		const moved = centre ? relative(positions, centre) : positions;
		const attributes: Record<string, number> = {
			POSITION: this.#binary.add("positions", moved, "VEC3", { bounds: true }),
			NORMAL: this.#binary.add("normals", normals, "VEC3"),
		};
		return { attributes, origin: centre ?? ORIGIN, unit: 1 };
	}

	/**
	 * Writes quantised positions and normals. A node must place the mesh: positions are `origin` + `unit` × written
	 * values (−1 … 1).
	 * @param centre the origin, metres; without it, the middle of the bounding box
	 */
	#compactAttributes({ positions, normals }: Mesh, centre?: readonly number[]) {
		this.require(QUANTIZATION);
		const origin = (centre ?? wholeBounds(positions)).map(Math.fround).map(shortFloat);
		const { values, scale } = quantised(positions, origin);
		const attributes: Record<string, number> = {
			POSITION: this.#binary.add("shortPositions", values, "VEC3", { bounds: true, normalized: true }),
			NORMAL: this.#binary.add("byteNormals", quantisedNormals(normals), "VEC3", { normalized: true }),
		};
		return { attributes, origin, unit: scale };
	}
}

/** Leaves out empty lists, which glTF forbids. */
function withoutEmpty(lists: Record<string, unknown[]>): Json {
	return Object.fromEntries(Object.entries(lists).filter(([, list]) => list.length > 0));
}
