/** Binary glTF: the triangles of its scene, as its nodes place them. */
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

interface Node {
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
	nodes?: Node[];
	scenes?: { nodes?: number[] }[];
	scene?: number;
	extensionsRequired?: string[];
}

/** @throws MeshFileError where it is damaged or packed in a way that is not read here */
export function readGlb(bytes: ArrayBuffer): Soup {
	try {
		const { gltf, binary } = chunksOf(bytes);
		const packed = gltf.extensionsRequired?.filter((name) => !/^KHR_(materials|texture)/.test(name)) ?? [];
		if (packed.length > 0) {
			throw new MeshFileError(`The GLB is packed by ${packed.join(", ")}: export it again without compression.`);
		}
		const soup: Soup = { points: [], triangles: [] };
		const roots = gltf.scenes?.[gltf.scene ?? 0]?.nodes ?? nobodysChildren(gltf);
		const seen = new Set<number>();
		for (const root of roots) gather(gltf, binary, root, Matrix.identity, soup, seen);
		return soup;
	} catch (error) {
		if (error instanceof MeshFileError) throw error;
		throw new MeshFileError("The GLB is damaged or unfinished: export it again.");
	}
}

function chunksOf(bytes: ArrayBuffer): { gltf: Gltf; binary: DataView } {
	const view = new DataView(bytes);
	if (view.getUint32(0, true) !== MAGIC) throw new MeshFileError("This is no GLB.");
	const length = view.getUint32(12, true);
	if (view.getUint32(16, true) !== JSON_CHUNK) throw new MeshFileError("The GLB does not begin with its JSON.");
	const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length))) as Gltf;
	const start = 20 + length;
	const binary =
		start + 8 <= bytes.byteLength
			? new DataView(bytes, start + 8, view.getUint32(start, true))
			: new DataView(new ArrayBuffer(0));
	return { gltf, binary };
}

/** The roots, where no scene names them. */
function nobodysChildren({ nodes = [] }: Gltf): number[] {
	const children = new Set(nodes.flatMap((node) => node.children ?? []));
	return [...nodes.keys()].filter((index) => !children.has(index));
}

/** @param seen nodes that were met before: the same one twice may be met without end */
function gather(gltf: Gltf, binary: DataView, index: number, above: Mat4, soup: Soup, seen: Set<number>): void {
	const node = gltf.nodes?.[index];
	if (!node || seen.has(index)) throw new MeshFileError("The GLB's nodes do not form a tree.");
	seen.add(index);
	const place = Matrix.times(above, node.matrix ?? Matrix.of(node));
	for (const primitive of node.mesh === undefined ? [] : (gltf.meshes?.[node.mesh].primitives ?? [])) {
		if ((primitive.mode ?? TRIANGLES) === TRIANGLES) add(gltf, binary, primitive, place, soup);
	}
	for (const child of node.children ?? []) gather(gltf, binary, child, place, soup, seen);
}

function add(gltf: Gltf, binary: DataView, { attributes, indices }: Primitive, place: Mat4, soup: Soup): void {
	bounded((soup.triangles.length + (gltf.accessors?.[indices ?? attributes.POSITION].count ?? 0)) / 3);
	const positions = numbersOf(gltf, binary, attributes.POSITION);
	const first = soup.points.length / 3;
	const count = positions.length / 3;
	for (let i = 0; i < positions.length; i += 3) {
		soup.points.push(...Matrix.point(place, positions[i], positions[i + 1], positions[i + 2]));
	}
	const order = indices === undefined ? Array.from({ length: count }, (_, i) => i) : numbersOf(gltf, binary, indices);
	if (order.some((corner) => corner >= count)) throw new MeshFileError("The GLB has triangles without points.");
	// A mirrored node turns its triangles inside out.
	const turned = Matrix.mirrors(place);
	for (let i = 0; i + 3 <= order.length; i += 3) {
		const [a, b, c] = [order[i], order[i + 1], order[i + 2]].map((corner) => first + corner);
		soup.triangles.push(a, turned ? c : b, turned ? b : c);
	}
}

/** Bytes of a number, and how it is read. */
const READ: Readonly<Record<number, readonly [bytes: number, read: (view: DataView, at: number) => number]>> = {
	5121: [1, (view, at) => view.getUint8(at)],
	5123: [2, (view, at) => view.getUint16(at, true)],
	5125: [4, (view, at) => view.getUint32(at, true)],
	[FLOAT]: [4, (view, at) => view.getFloat32(at, true)],
};

function numbersOf({ accessors = [], bufferViews }: Gltf, binary: DataView, index: number): number[] {
	const { bufferView, byteOffset = 0, componentType, count, type, sparse } = accessors[index];
	const width = type === "VEC3" ? 3 : 1;
	if (sparse || bufferView === undefined || (width === 3 && componentType !== FLOAT)) {
		throw new MeshFileError("The GLB's points are not plain numbers: export it again without compression.");
	}
	const { byteOffset: start = 0, byteStride } = (bufferViews ?? [])[bufferView];
	const [bytes, read] = READ[componentType];
	const stride = byteStride ?? width * bytes;
	const numbers = new Array<number>(width * count);
	for (let i = 0; i < count; i++) {
		for (let k = 0; k < width; k++) numbers[width * i + k] = read(binary, start + byteOffset + i * stride + k * bytes);
	}
	return numbers;
}
