/** Reads binary glTF: the triangles of its scene, placed by its nodes. */
import { text } from "../messages.generated";
import { type Mat4, Matrix } from "./matrix";
import { bounded, MeshFileError, type Soup } from "./soup";

const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const TRIANGLES = 4;
const FLOAT = 5126;

interface Accessor {
	bufferView?: number;
	byteOffset?: number;
	componentType: number;
	count: number;
	type: string;
	sparse?: unknown;
}

interface Primitive {
	attributes: Record<string, number>;
	indices?: number;
	mode?: number;
}

interface GltfNode {
	mesh?: number;
	children?: number[];
	matrix?: number[];
	translation?: number[];
	rotation?: number[];
	scale?: number[];
}

interface Gltf {
	accessors?: Accessor[];
	bufferViews?: { buffer: number; byteOffset?: number; byteLength: number; byteStride?: number }[];
	meshes?: { primitives: Primitive[] }[];
	nodes?: GltfNode[];
	scenes?: { nodes?: number[] }[];
	scene?: number;
	extensionsRequired?: string[];
}

/** Largest number of mesh parts placed by nodes; more would take too long to read. */
const MAX_PARTS = 100_000;

/**
 * Reads the triangles of all meshes of a binary glTF 2.0 file, placed by its nodes. Counts, strides and offsets are checked against the buffer before reading; only points used by triangles are read.
 * @throws MeshFileError if the file is damaged or uses an unsupported compression
 */
export function readGlb(bytes: ArrayBuffer): Soup {
	try {
		const { gltf, binary } = chunksOf(bytes);
		const packed = gltf.extensionsRequired?.filter((name) => !/^KHR_(materials|texture)/.test(name)) ?? [];
		if (packed.length > 0) throw new MeshFileError(text.message("glb_compressed", { extensions: packed.join(", ") }));
		return collectTriangles(gltf, binary);
	} catch (error) {
		if (error instanceof MeshFileError) throw error;
		throw damaged();
	}
}

/** Returns the error of a file that does not follow the format. */
const damaged = () => new MeshFileError(text.message("glb_damaged"));

/** Splits the file into its JSON and its binary chunk, which is empty if the file has none. */
function chunksOf(bytes: ArrayBuffer): { gltf: Gltf; binary: DataView } {
	const view = new DataView(bytes);
	if (view.getUint32(0, true) !== MAGIC) throw new MeshFileError(text.message("glb_of_another_kind"));
	const length = view.getUint32(12, true);
	if (view.getUint32(16, true) !== JSON_CHUNK) throw new MeshFileError(text.message("glb_without_json"));
	const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length))) as Gltf;
	const start = 20 + length;
	const binary =
		start + 8 <= bytes.byteLength
			? new DataView(bytes, start + 8, view.getUint32(start, true))
			: new DataView(new ArrayBuffer(0));
	return { gltf, binary };
}

/** Returns the indices of nodes without parents: the roots of a file that names no scene. */
function rootNodes({ nodes = [] }: Gltf): number[] {
	const children = new Set(nodes.flatMap((node) => node.children ?? []));
	return [...nodes.keys()].filter((index) => !children.has(index));
}

/**
 * Collects the triangles of all nodes below the scene's roots, in depth-first order.
 * @throws MeshFileError if the nodes are no tree, or there are too many parts
 */
function collectTriangles(gltf: Gltf, binary: DataView): Soup {
	const soup: Soup = { points: [], triangles: [] };
	const roots = gltf.scenes?.[gltf.scene ?? 0]?.nodes ?? rootNodes(gltf);
	const open = roots.map((index) => ({ index, above: Matrix.identity })).reverse();
	const seen = new Set<number>();
	let parts = 0;
	for (let next = open.pop(); next; next = open.pop()) {
		const node = gltf.nodes?.[next.index];
		// A node visited twice may be part of a cycle.
		if (!node || seen.has(next.index)) throw new MeshFileError(text.message("glb_nodes_no_tree"));
		seen.add(next.index);
		const place = Matrix.times(next.above, node.matrix ?? Matrix.of(node));
		const primitives = node.mesh === undefined ? [] : (gltf.meshes?.[node.mesh].primitives ?? []);
		parts += primitives.length;
		if (parts > MAX_PARTS) throw new MeshFileError(text.message("glb_too_many_parts", { most: MAX_PARTS }));
		for (const primitive of primitives) {
			if ((primitive.mode ?? TRIANGLES) === TRIANGLES) addPrimitive(gltf, binary, primitive, place, soup);
		}
		for (const index of (node.children ?? []).toReversed()) open.push({ index, above: place });
	}
	return soup;
}

/**
 * Adds a primitive's triangles to a mesh, transformed by `place`; only points that triangles use.
 * @throws MeshFileError if there are too many triangles, or an index or a point is invalid
 */
function addPrimitive(gltf: Gltf, binary: DataView, { attributes, indices }: Primitive, place: Mat4, soup: Soup): void {
	const corners = gltf.accessors?.[indices ?? attributes.POSITION].count ?? 0;
	bounded((soup.triangles.length + corners) / 3);
	const positions = numbersOf(gltf, binary, attributes.POSITION, "VEC3");
	const order = indices === undefined ? undefined : numbersOf(gltf, binary, indices, "SCALAR");
	const numbers = new Map<number, number>();
	/** Returns the index of a corner's point in the soup; the point is added, in its place, on first use. */
	const number = (corner: number): number => {
		if (corner >= positions.count) throw new MeshFileError(text.message("glb_triangle_without_point"));
		const known = numbers.get(corner);
		if (known !== undefined) return known;
		const added = soup.points.length / 3;
		const [x, y, z] = [0, 1, 2].map((k) => positions.at(corner, k));
		const point = Matrix.point(place, x, y, z);
		if (!point.every(Number.isFinite)) throw new MeshFileError(text.message("glb_point_invalid"));
		soup.points.push(...point);
		numbers.set(corner, added);
		return added;
	};
	// A mirroring node reverses the orientation of triangles.
	const turned = Matrix.mirrors(place);
	for (let i = 0; i + 3 <= corners; i += 3) {
		const [a, b, c] = [i, i + 1, i + 2].map((k) => number(order ? order.at(k, 0) : k));
		soup.triangles.push(a, turned ? c : b, turned ? b : c);
	}
}

/** Size of a number type in bytes, and its reader. */
const READ: Readonly<Record<number, readonly [bytes: number, read: (view: DataView, at: number) => number]>> = {
	5121: [1, (view, at) => view.getUint8(at)],
	5123: [2, (view, at) => view.getUint16(at, true)],
	5125: [4, (view, at) => view.getUint32(at, true)],
	[FLOAT]: [4, (view, at) => view.getFloat32(at, true)],
};

/** An accessor's values, read one at a time. */
interface Numbers {
	readonly count: number;
	at(row: number, column: number): number;
}

/** Returns whether a value can be a size or an offset: a whole number from 0. */
const isCount = (value: unknown): value is number => Number.isSafeInteger(value) && (value as number) >= 0;

/**
 * Reads the numbers of an accessor: positions (VEC3 of floats) or indices (SCALAR).
 * @throws MeshFileError if some values lie outside the accessor's part of the buffer
 */
function numbersOf(
	{ accessors = [], bufferViews = [] }: Gltf,
	binary: DataView,
	index: number,
	wanted: "VEC3" | "SCALAR",
): Numbers {
	const { bufferView, byteOffset = 0, componentType, count, type, sparse } = accessors[index];
	const isPlain = sparse === undefined && bufferView !== undefined && (componentType === FLOAT) === (wanted === "VEC3");
	if (!isPlain || type !== wanted) throw new MeshFileError(text.message("glb_points_packed"));
	const { byteOffset: start = 0, byteLength, byteStride } = bufferViews[bufferView];
	const [bytes, read] = READ[componentType];
	const width = (wanted === "VEC3" ? 3 : 1) * bytes;
	const stride = byteStride ?? width;
	if (![byteOffset, count, start, byteLength, stride].every(isCount) || stride < width) throw damaged();
	const end = count === 0 ? 0 : byteOffset + (count - 1) * stride + width;
	if (end > byteLength || start + byteLength > binary.byteLength) throw damaged();
	return { count, at: (row, column) => read(binary, start + byteOffset + row * stride + column * bytes) };
}
