/**
 * Writes parts of any plant as binary glTF 2.0, in metres, +Y up. docs/export.md has the contents and their reasons.
 */
import type { Colour } from "../plant/colour";
import type { Material, Picture } from "../plant/material";
import { everyPart, type Instances, type Part, type PartMesh, type Shape, TRANSFORM, type Vector } from "../plant/part";
import { tinted } from "../plant/picture";
import { swing } from "../plant/point_sway";
import type { Sway } from "../plant/sway";
import type { About } from "./about";
import type { Moment } from "./animation";
import type { Encoder } from "./binary_gltf";
import { GltfDocument, type Json, type Placed } from "./gltf_document";
import { gltfMaterial, type TextureIndices } from "./gltf_material";
import { rounded, shortFloat } from "./numbers";
import { onePixel } from "./one_pixel";
import { png } from "./png";
import { tangentsOf } from "./tangents";
import { together } from "./together";
import { brightest, sharesOf, writtenColours } from "./vertex_colours";
import { written } from "./written";

export interface GlbOptions {
	/**
	 * Draws instances by one node with EXT_mesh_gpu_instancing, in place of one node each, or of meshes for all
	 * instances that are no parts by themselves: smaller and faster, for readers that know the extension; others refuse
	 * the file. Meshes that are drawn once stay as they are.
	 */
	instancing?: boolean;
	/**
	 * Positions in 16 bits and normals in 8, with KHR_mesh_quantization: about two thirds of the size; readers must
	 * know it.
	 */
	compact?: boolean;
	/** Compresses a compact file (EXT_meshopt_compression, which readers must know). It must be ready. */
	encoder?: Encoder;
	/**
	 * When parts are visible, by their names: an animation. Parts that disappear are invisible in readers that play
	 * none.
	 */
	moments?: ReadonlyMap<string, Moment>;
	/** Motion in wind, for parts without instances: an endless animation. */
	sway?: Sway;
	/**
	 * The least shares of the view's area that each level of detail covers (MSFT_lod); the parts are the same plant at
	 * these levels, from near to far.
	 */
	coverage?: readonly number[];
	/**
	 * Whether light passes through flesh, which costs readers an extra pass; without it flesh is as bright, and opaque.
	 */
	translucent?: boolean;
}

const INSTANCING = "EXT_mesh_gpu_instancing";
/** Decimals of quaternions: well within the tolerance of validators for their length. */
const TURN_DECIMALS = 7;

/** Writes the file; `parts` are only read. The same parts give the same bytes. */
export function exportGlb(parts: Iterable<Part>, about: About, options: GlbOptions = {}): Uint8Array<ArrayBuffer> {
	const all = options.instancing ? [...parts] : [...parts].map(together);
	const document = new GltfDocument(options.compact ?? options.encoder !== undefined, options.encoder);
	return new PartsWriter(document, all, options).write(all, about);
}

/** The transform that a node inherits from its parent. */
interface Frame {
	/** Position in the plant, metres. */
	origin: readonly number[];
	/** Metres per unit of the mesh's written coordinates; 1 except in compact files, which write −1 … 1. */
	unit: number;
}

const WORLD: Frame = { origin: [0, 0, 0], unit: 1 };

class PartsWriter {
	readonly #document: GltfDocument;
	readonly #instancing: boolean;
	readonly #translucent: boolean;
	readonly #moments: GlbOptions["moments"];
	readonly #sway: Sway | undefined;
	readonly #coverage: GlbOptions["coverage"];
	/** The brightest vertex colour of each material. */
	readonly #bases = new Map<Material, Colour>();
	/** These colours as pictures, where materials have one. */
	readonly #painted = new Map<Material, Picture>();
	/** Materials that meshes without texture coordinates use. */
	readonly #bare = new Set<Material>();
	/** Indices by material, with and without vertex colours. */
	readonly #materials = { coloured: new Map<Material, number>(), plain: new Map<Material, number>() };
	/** Meshes with several instances, by mesh and material: one mesh may have several materials. */
	readonly #shared = new Map<PartMesh, Map<Material, Placed>>();
	/** Written vertex colours, by mesh. */
	readonly #colours = new Map<PartMesh, Float32Array>();

	/**
	 * Collects the data that all parts need before any is written: the vertex colours of each mesh, and for each
	 * material the brightest of them, which becomes its base colour (vertex colours only darken).
	 */
	constructor(
		document: GltfDocument,
		parts: readonly Part[],
		{ instancing = false, translucent = false, moments, sway, coverage }: GlbOptions,
	) {
		this.#document = document;
		this.#instancing = instancing;
		this.#translucent = translucent;
		this.#moments = moments;
		this.#sway = sway;
		this.#coverage = coverage;
		for (const { shape } of everyPart(parts)) {
			const colours = shape && writtenColours(shape.mesh, shape.material);
			if (!colours) continue;
			this.#colours.set(shape.mesh, colours);
			this.#bases.set(shape.material, brightest(colours, this.#bases.get(shape.material)));
		}
		if (!document.compact) this.#paintBases(parts);
	}

	/** Moves base colours into pictures, where all meshes of the material have texture coordinates. */
	#paintBases(parts: readonly Part[]): void {
		for (const { shape } of everyPart(parts)) if (shape?.mesh.uvs.length === 0) this.#bare.add(shape.material);
		for (const [material, base] of this.#bases) {
			if (material.textures?.colour || this.#bare.has(material)) continue;
			const { picture, colour } = onePixel(base);
			this.#bases.set(material, colour);
			this.#painted.set(material, picture);
		}
	}

	/** Writes all parts below one root node, and finishes the document. */
	write(parts: readonly Part[], { name, link, extras }: About): Uint8Array<ArrayBuffer> {
		const root: Json = { name };
		const roots = [this.#document.node(root)];
		const children = parts.map((part) => this.#writePart(part, WORLD));
		if (this.#coverage) this.#document.levels(children.splice(1), children[0], this.#coverage);
		if (children.length > 0) root.children = children;
		return this.#document.finish(roots, { link, ...extras });
	}

	/**
	 * Writes the nodes of a part and of its children.
	 * @param parent the transform that the part's node inherits
	 * @returns the index of the part's node
	 */
	#writePart({ name, shape, extras, children = [] }: Part, parent: Frame): number {
		const node: Json = extras ? { name, extras: written(extras) } : { name };
		const index = this.#document.node(node);
		const held: number[] = [];
		let frame = parent;
		if (shape?.instances)
			held.push(...this.#instances(node, name, shape, shape.instances, parent, children.length > 0));
		else if (shape) {
			frame = this.#draw(node, name, shape, parent);
			if (this.#sway) this.#document.swing(index);
		}
		held.push(...children.map((child) => this.#writePart(child, frame)));
		if (held.length > 0) node.children = held;
		const moment = this.#moments?.get(name);
		if (moment) this.#document.show(node, index, moment);
		return index;
	}

	/** Gives a node the mesh of a shape, and its transform; returns the frame of its children. */
	#draw(node: Json, name: string, shape: Shape, parent: Frame): Frame {
		const { mesh, ...frame } = this.#mesh(shape, name);
		Object.assign(node, { mesh, ...placed(frame, parent) });
		return frame;
	}

	/**
	 * Gives a node a mesh with instances, or makes child nodes for the instances.
	 * @param apart whether the node has children, which must not turn with the mesh
	 * @returns the child nodes made
	 */
	#instances(node: Json, name: string, shape: Shape, instances: Instances, parent: Frame, apart: boolean): number[] {
		const { mesh, unit } = this.#sharedMesh(shape, name);
		const { transforms, each } = instances;
		if (each && !this.#instancing) return this.#instanceNodes(instances, each, mesh, unit, parent);
		const many = each !== undefined || transforms.length > TRANSFORM;
		const drawn = many
			? { mesh, ...this.#gpuInstances(transforms, unit) }
			: { mesh, ...transformed(transforms, 0, unit, parent) };
		if (apart) return [this.#document.node({ name: shape.mesh.name ?? name, ...drawn })];
		Object.assign(node, drawn);
		return [];
	}

	/**
	 * Writes one node per instance.
	 * @param each returns name and properties of the instance of an index
	 * @param mesh index of the instances' mesh
	 * @param unit metres per unit of the mesh's written coordinates
	 * @returns the nodes
	 */
	#instanceNodes(
		{ transforms }: Instances,
		each: NonNullable<Instances["each"]>,
		mesh: number,
		unit: number,
		parent: Frame,
	): number[] {
		return Array.from({ length: transforms.length / TRANSFORM }, (_, i) => {
			const { name, extras } = each(i);
			const node = { name, mesh, ...transformed(transforms, i, unit, parent) };
			return this.#document.node(extras ? { ...node, extras: written(extras) } : node);
		});
	}

	/**
	 * Returns the properties of a node that draws a mesh once per instance (EXT_mesh_gpu_instancing). The transforms are
	 * written as they are, without a parent's frame: callers that instance pass parts whose instances belong to groups,
	 * which do not move (alike.ts).
	 * @param unit metres per unit of the mesh's written coordinates, which multiplies the instances' scales
	 */
	#gpuInstances(transforms: Float32Array, unit: number): Json {
		const count = transforms.length / TRANSFORM;
		const translations = new Float32Array(3 * count);
		const rotations = new Float32Array(4 * count);
		const scales = new Float32Array(3 * count);
		for (let i = 0; i < count; i++) {
			const first = TRANSFORM * i;
			translations.set(transforms.subarray(first, first + 3), 3 * i);
			rotations.set(transforms.subarray(first + 3, first + 7), 4 * i);
			scales.fill(transforms[first + 7] * unit, 3 * i, 3 * i + 3);
		}
		this.#document.require(INSTANCING);
		const attributes = {
			TRANSLATION: this.#document.instances("translations", translations),
			ROTATION: this.#document.instances("rotations", rotations),
			SCALE: this.#document.instances("scales", scales),
		};
		return { extensions: { [INSTANCING]: { attributes } } };
	}

	/** Returns the written mesh of instances; each combination of mesh and material is written once. */
	#sharedMesh(shape: Shape, name: string): Placed {
		const byMaterial = this.#shared.get(shape.mesh) ?? new Map<Material, Placed>();
		this.#shared.set(shape.mesh, byMaterial);
		const known = byMaterial.get(shape.material);
		if (known) return known;
		// The mesh needs an origin only where it has a unit of its own.
		const made = this.#mesh(this.#document.compact ? { ...shape, centre: [0, 0, 0] } : shape, name);
		byMaterial.set(shape.material, made);
		return made;
	}

	/** Writes a mesh with its colours, tangents and motion. */
	#mesh({ mesh, material, centre }: Shape, name: string): Placed {
		const written = this.#colours.get(mesh);
		const base = written && this.#bases.get(material);
		const colours = written && base && sharesOf(written, base);
		const tangents = material.textures?.normal && tangentsOf(mesh);
		const moved = this.#sway && swingOf(mesh, this.#sway);
		const options = { centre, colours, tangents, ...(moved ? { swing: moved } : {}) };
		return this.#document.mesh(mesh.name ?? name, mesh, this.#material(material, base), options);
	}

	/**
	 * Returns the index of a material; written on first use.
	 * @param base factor of the meshes' vertex colours; undefined for meshes without vertex colours
	 */
	#material(material: Material, base: Colour | undefined): number {
		const indices = base ? this.#materials.coloured : this.#materials.plain;
		const known = indices.get(material);
		if (known !== undefined) return known;
		// Compact meshes reach from −1 to 1, each scaled by its own node.
		const thickness = this.#document.compact ? 2 : (material.flesh?.thickness ?? 0);
		const written = this.#translucent ? material : opaque(material);
		const textures = this.#textures(written, base, base && this.#painted.get(material));
		// Some readers support pictures and vertex colours, but no factor besides: put the factor into the picture.
		const factor: Colour = textures.colour === undefined ? (base ?? material.colour) : [1, 1, 1];
		const index = this.#document.material(gltfMaterial(written, factor, thickness, textures));
		indices.set(material, index);
		return index;
	}

	/**
	 * Writes the pictures of a material; returns the indices of their textures by kind.
	 * @param base factor for the colour picture
	 * @param plain picture for materials without a colour picture of their own
	 */
	#textures({ name, textures = {} }: Material, base: Colour = [1, 1, 1], plain?: Picture): TextureIndices {
		const { repeats, colour, ...others } = textures;
		const shown = colour ? tinted(colour, base) : plain;
		const pictures = { ...(shown ? { colour: shown } : {}), ...others };
		const kinds = Object.entries(pictures) as [keyof TextureIndices, Picture][];
		return Object.fromEntries(
			kinds.map(([kind, picture]) => [kind, this.#document.texture(`${name} ${kind}`, png(picture), repeats)]),
		);
	}
}

/** Returns the displacement of every vertex by a sine and a cosine of time, 3 × vertices each. */
function swingOf({ positions, feet = positions }: PartMesh, sway: Sway): [sine: Float32Array, cosine: Float32Array] {
	const [sines, cosines] = [new Float32Array(positions.length), new Float32Array(positions.length)];
	for (let i = 0; i < positions.length; i += 3) {
		const pointIn = (all: Float32Array): Vector => [all[i], all[i + 1], all[i + 2]];
		const { sine, cosine } = swing(sway, pointIn(positions), pointIn(feet));
		sines.set(sine, i);
		cosines.set(cosine, i);
	}
	return [sines, cosines];
}

/** Returns the material without translucent flesh. */
function opaque(material: Material): Material {
	if (!material.flesh) return material;
	const { flesh: _, textures: { thickness: __, ...textures } = {}, ...others } = material;
	return Object.keys(textures).length > 0 ? { ...others, textures } : others;
}

/** Returns the translation and scale of a node below its parent; omits defaults. */
function placed({ origin, unit }: Frame, parent: Frame): Json {
	const moved = origin.map((value, k) => (Math.fround(value) - Math.fround(parent.origin[k])) / parent.unit);
	const scale = short(unit / parent.unit);
	return {
		...(moved.some((value) => value !== 0) ? { translation: moved.map(short) } : {}),
		...(scale === 1 ? {} : { scale: [scale, scale, scale] }),
	};
}

/**
 * Returns translation, rotation and scale of the node of instance `index`.
 * @param unit metres per unit of the mesh's written coordinates
 */
function transformed(transforms: Float32Array, index: number, unit: number, parent: Frame): Json {
	const [x, y, z, ...rest] = transforms.subarray(TRANSFORM * index, TRANSFORM * (index + 1));
	const rotation = rest.slice(0, 4).map((value) => rounded(value, TURN_DECIMALS));
	const size = Math.fround(rest[4] * unit);
	return { ...placed({ origin: [x, y, z], unit: size }, parent), rotation };
}

/** Rounds to float32, as the shortest decimal. */
function short(value: number): number {
	return shortFloat(Math.fround(value));
}
