/** Reading exports back: with three.js's loaders, and piece by piece. */
import { type Issue, validateBytes } from "gltf-validator";
import type { Group, Mesh } from "three";
import { type GLTF, GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { linear } from "../../../web/src/plant/colour";
import { readPng } from "./reading_png";

export async function load(glb: Uint8Array): Promise<GLTF> {
	return new GLTFLoader().parseAsync(unpictured(glb).buffer as ArrayBuffer, "");
}

export interface Node {
	name: string;
	mesh?: number;
	children?: number[];
	translation?: number[];
	rotation?: number[];
	scale?: number[];
	extensions?: { EXT_mesh_gpu_instancing?: { attributes: Record<string, number> } };
	extras?: object;
}

/** The parts of a glTF document that the tests look at. */
export interface Document {
	asset: { generator: string; copyright?: string; extras: Record<string, unknown> };
	extensionsUsed?: string[];
	extensionsRequired?: string[];
	nodes: Node[];
	meshes?: { name: string; primitives: { attributes: Record<string, number>; indices: number; material: number }[] }[];
	materials?: {
		name: string;
		pbrMetallicRoughness: { baseColorFactor: number[]; baseColorTexture?: { index: number } };
		extensions?: object;
	}[];
	textures?: { name: string; source: number; sampler: number }[];
	images?: { mimeType: string; bufferView: number }[];
	samplers?: object[];
	accessors?: { bufferView: number; count: number; componentType: number; min?: number[]; max?: number[] }[];
	bufferViews?: { byteOffset: number; byteLength: number; target?: number }[];
}

/** The JSON chunk. */
export function documentOf(glb: Uint8Array): Document {
	const length = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
	return JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)));
}

/** Base colours of materials by name, linear: the factor, times the picture where that is of one pixel. */
export function basesOf(glb: Uint8Array): Record<string, number[]> {
	const { materials = [], textures = [], images = [], bufferViews = [] } = documentOf(glb);
	const binary = 28 + new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
	const bases = materials.map(({ name, pbrMetallicRoughness: { baseColorFactor, baseColorTexture } }) => {
		if (!baseColorTexture) return [name, baseColorFactor];
		const { byteOffset, byteLength } = bufferViews[images[textures[baseColorTexture.index].source].bufferView];
		const picture = readPng(glb.subarray(binary + byteOffset, binary + byteOffset + byteLength));
		if (picture.width * picture.height > 1) return [name, baseColorFactor];
		const [red, green, blue] = linear(Buffer.from(picture.pixels).toString("hex"));
		return [name, [red, green, blue, 1].map((value, k) => Number((value * baseColorFactor[k]).toFixed(6)))];
	});
	return Object.fromEntries(bases);
}

/** The same file without pictures, a pixel in its material's factor: three.js's loader makes pictures in a page alone. */
export function unpictured(glb: Uint8Array): Uint8Array {
	const { textures: _, images: __, samplers: ___, ...document } = documentOf(glb);
	const bases = basesOf(glb);
	for (const { name, pbrMetallicRoughness: reported } of document.materials ?? [])
		reported.baseColorFactor = bases[name];
	const bare = JSON.stringify(document, (key, value) => (/Texture$/.test(key) ? undefined : value));
	const file = glb.slice();
	const length = new DataView(file.buffer).getUint32(12, true);
	file.set(new TextEncoder().encode(bare.padEnd(length)).subarray(0, length), 20);
	return file;
}

/** Extensions that Khronos' validator does not know. */
const UNKNOWN = ["EXT_mesh_gpu_instancing", "KHR_materials_diffuse_transmission"];

/**
 * Issues of the Khronos validator, except those that every such file has: hardly anything is textured (the
 * texture coordinates are for people painting the bunch), it does not know KHR_materials_diffuse_transmission, and it does not look
 * inside EXT_mesh_gpu_instancing, so data that is used only there seems unused. Errors and warnings are never left out.
 */
export async function complaints(glb: Uint8Array): Promise<Issue[]> {
	const { issues } = await validateBytes(glb, { maxIssues: 0 });
	const instances = instanceAccessors(documentOf(glb));
	return issues.messages.filter(({ code, severity, pointer = "", message }) => {
		if (severity < 2) return true;
		if (code === "UNSUPPORTED_EXTENSION") return !UNKNOWN.some((name) => message.includes(name));
		return code !== "UNUSED_OBJECT" || !(pointer.endsWith("/attributes/TEXCOORD_0") || instances.includes(pointer));
	});
}

function instanceAccessors({ nodes }: Document): string[] {
	return nodes
		.flatMap(({ extensions }) => Object.values(extensions?.EXT_mesh_gpu_instancing?.attributes ?? {}))
		.map((accessor) => `/accessors/${accessor}`);
}

export function meshesOf(group: Group): Mesh[] {
	const meshes: Mesh[] = [];
	group.traverse((object) => {
		if ("isMesh" in object) meshes.push(object as Mesh);
	});
	return meshes;
}
