/**
 * Grown → binary glTF 2.0, in metres, +Y up. What is in the file, and why it is so, is in docs/export.md.
 */
import type { Grown, Mesh, StemMesh, StemPart } from "../core/grown";
import { encodeLink } from "../specimen/link";
import type { Specimen } from "../specimen/specimen";
import { BinaryGltf, type ViewLayout } from "./binary_gltf";
import { GENERATOR } from "./generator";
import { type Material, SCAR_TINT, skinMaterial, stemMaterial } from "./materials";
import { requireMeshes } from "./meshes";
import { berryName, plantName, stemName } from "./names";
import { rounded, shortFloat } from "./numbers";
import { fromUp } from "./orientation";
import { scarShare } from "./scar";

export interface GlbOptions {
	/**
	 * One node `Berries` drawn with EXT_mesh_gpu_instancing in place of one node per berry: smaller and faster, for
	 * readers that know the extension; others refuse the file.
	 */
	instancing?: boolean;
	/** The link that brings the specimen back; without it the query alone, `?v=1&…`. */
	link?: string;
}

type Json = Record<string, unknown>;

const SHEEN = "KHR_materials_sheen";
const INSTANCING = "EXT_mesh_gpu_instancing";

/** One view for each kind of data, shared by all meshes. Attributes of instances are not vertices: no target there. */
const VIEWS: Record<string, ViewLayout> = {
	positions: { target: "vertices", stride: 12 },
	normals: { target: "vertices", stride: 12 },
	uvs: { target: "vertices", stride: 8 },
	colours: { target: "vertices", stride: 4 },
	shortIndices: { target: "indices" },
	longIndices: { target: "indices" },
	translations: {},
	rotations: {},
	scales: {},
};

/** Most vertices 16-bit indices reach; 65535 itself means a restart of the strip. */
const SHORT_INDEX_VERTICES = 65535;
/** Well inside what validators allow a quaternion to be off its unit length. */
const ROTATION_DECIMALS = 7;

/**
 * The file. Rejects with a message for people when `grown` was asked for without meshes. `grown` is only read.
 */
export async function exportGlb(
	grown: Grown,
	specimen: Specimen,
	options: GlbOptions = {},
): Promise<Uint8Array<ArrayBuffer>> {
	const { instancing = false, link = await encodeLink(specimen) } = options;
	return new GlbScene(grown, specimen).write(instancing, link);
}

/** The lists of a glTF document while they fill; every entry is used by another, as validators ask. */
class GlbScene {
	readonly #binary = new BinaryGltf(VIEWS);
	readonly #nodes: Json[] = [];
	readonly #meshes: Json[] = [];
	readonly #materials: Json[] = [];
	readonly #extensionsUsed: string[] = [];
	readonly #extensionsRequired: string[] = [];
	readonly #grown: Grown;
	readonly #specimen: Specimen;

	constructor(grown: Grown, specimen: Specimen) {
		this.#grown = grown;
		this.#specimen = specimen;
	}

	write(instancing: boolean, link: string): Uint8Array<ArrayBuffer> {
		const { stem, berry } = requireMeshes(this.#grown);
		const root: Json = { name: plantName(this.#specimen) };
		this.#nodes.push(root);
		const children = [...this.#stems(stem)];
		if (this.#grown.berries.count > 0) children.push(this.#berries(berry, instancing));
		if (children.length > 0) root.children = children;
		return this.#binary.finish({
			asset: { version: "2.0", generator: GENERATOR, extras: this.#extras(link) },
			...filled({ extensionsUsed: this.#extensionsUsed, extensionsRequired: this.#extensionsRequired }),
			scene: 0,
			scenes: [{ nodes: [0] }],
			nodes: this.#nodes,
			...filled({ meshes: this.#meshes, materials: this.#materials }),
		});
	}

	/** Where the file came from: enough to grow it again and to check that it is the same. */
	#extras(link: string): Json {
		const { plan, second, counts, fingerprint } = this.#grown;
		return { link, specimen: this.#specimen, plan: { ...plan, second }, counts, fingerprint };
	}

	*#stems(stem: StemMesh): Generator<number> {
		const parts = stem.parts.filter((part) => part.indexCount > 0);
		if (parts.length === 0) return;
		const material = this.#material(stemMaterial(this.#specimen.look));
		for (const part of parts) {
			const mesh = this.#mesh(stemName(part.axis), cut(stem, part), material);
			yield this.#nodes.push({ name: stemName(part.axis), mesh }) - 1;
		}
	}

	/** The node `Berries`: a group of one node per berry, or the instances themselves. */
	#berries(berry: Mesh, instancing: boolean): number {
		const colours = this.#binary.add("colours", scarColours(berry), "VEC4", { normalized: true });
		const material = this.#material(skinMaterial(this.#specimen.look));
		const mesh = this.#mesh("Berry", berry, material, { COLOR_0: colours });
		if (instancing) return this.#nodes.push({ name: "Berries", mesh, ...this.#instances() }) - 1;
		const children: number[] = [];
		const group = this.#nodes.push({ name: "Berries", children }) - 1;
		for (let i = 0; i < this.#grown.berries.count; i++) children.push(this.#nodes.push(this.#berry(i, mesh)) - 1);
		return group;
	}

	#berry(index: number, mesh: number): Json {
		const { count, spheres, directions, parent } = this.#grown.berries;
		const [x, y, z, radius] = Array.from(spheres.subarray(4 * index, 4 * index + 4), shortFloat);
		const [dx, dy, dz] = directions.subarray(3 * index, 3 * index + 3);
		const turn = fromUp(dx, dy, dz);
		const pedicel = parent[index];
		return {
			name: berryName(index, count),
			mesh,
			translation: [x, y, z],
			rotation: [turn.x, turn.y, turn.z, turn.w].map((value) => rounded(value, ROTATION_DECIMALS)),
			scale: [radius, radius, radius],
			extras: { pedicel, axis: this.#grown.internodes.axis[pedicel] },
		};
	}

	#instances(): Json {
		const { count, spheres, directions } = this.#grown.berries;
		const translations = new Float32Array(3 * count);
		const rotations = new Float32Array(4 * count);
		const scales = new Float32Array(3 * count);
		for (let i = 0; i < count; i++) {
			translations.set(spheres.subarray(4 * i, 4 * i + 3), 3 * i);
			const [dx, dy, dz] = directions.subarray(3 * i, 3 * i + 3);
			const turn = fromUp(dx, dy, dz);
			rotations.set([turn.x, turn.y, turn.z, turn.w], 4 * i);
			scales.fill(spheres[4 * i + 3], 3 * i, 3 * i + 3);
		}
		this.#extensionsUsed.push(INSTANCING);
		this.#extensionsRequired.push(INSTANCING);
		const attributes = {
			TRANSLATION: this.#binary.add("translations", translations, "VEC3"),
			ROTATION: this.#binary.add("rotations", rotations, "VEC4"),
			SCALE: this.#binary.add("scales", scales, "VEC3"),
		};
		return { extensions: { [INSTANCING]: { attributes } } };
	}

	#mesh(name: string, mesh: Mesh, material: number, more: Record<string, number> = {}): number {
		const attributes = {
			POSITION: this.#binary.add("positions", mesh.positions, "VEC3", { bounds: true }),
			NORMAL: this.#binary.add("normals", mesh.normals, "VEC3"),
			TEXCOORD_0: this.#binary.add("uvs", mesh.uvs, "VEC2"),
			...more,
		};
		const short = mesh.positions.length / 3 <= SHORT_INDEX_VERTICES;
		const indices = short
			? this.#binary.add("shortIndices", Uint16Array.from(mesh.indices), "SCALAR")
			: this.#binary.add("longIndices", mesh.indices, "SCALAR");
		return this.#meshes.push({ name, primitives: [{ attributes, indices, material }] }) - 1;
	}

	#material({ name, colour, roughness, sheen }: Material): number {
		const material: Json = {
			name,
			pbrMetallicRoughness: { baseColorFactor: [...colour, 1], metallicFactor: 0, roughnessFactor: roughness },
		};
		if (sheen) {
			this.#extensionsUsed.push(SHEEN);
			material.extensions = { [SHEEN]: { sheenColorFactor: sheen.colour, sheenRoughnessFactor: sheen.roughness } };
		}
		return this.#materials.push(material) - 1;
	}
}

/** One part of the stem as a mesh of its own, indices counted from its first vertex. */
function cut(stem: StemMesh, part: StemPart): Mesh {
	const { firstVertex, vertexCount, firstIndex, indexCount } = part;
	const lastVertex = firstVertex + vertexCount;
	return {
		positions: stem.positions.subarray(3 * firstVertex, 3 * lastVertex),
		normals: stem.normals.subarray(3 * firstVertex, 3 * lastVertex),
		uvs: stem.uvs.subarray(2 * firstVertex, 2 * lastVertex),
		indices: stem.indices.subarray(firstIndex, firstIndex + indexCount).map((index) => index - firstVertex),
	};
}

/** Colours to multiply the skin with: white, brown at the tip scar. Four bytes a vertex. */
function scarColours(berry: Mesh): Uint8Array {
	const colours = new Uint8Array((berry.positions.length / 3) * 4).fill(255);
	for (let vertex = 0; vertex < colours.length / 4; vertex++) {
		const share = scarShare(berry.uvs[2 * vertex + 1]);
		if (share === 0) continue;
		SCAR_TINT.forEach((tint, channel) => {
			colours[4 * vertex + channel] = Math.round(255 * (1 + (tint - 1) * share));
		});
	}
	return colours;
}

/** glTF forbids empty lists: leaves them out. */
function filled(lists: Record<string, unknown[]>): Json {
	return Object.fromEntries(Object.entries(lists).filter(([, list]) => list.length > 0));
}
