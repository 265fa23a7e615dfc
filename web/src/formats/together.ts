/**
 * Merges instances that are no parts by themselves, such as thousands of leaves, into meshes. Readers take minutes to
 * open one node per instance, and one node for all needs an extension.
 */
import { placeVectors, rotationMatrix } from "../plant/orientation";
import { type Instances, type Part, type PartMesh, type Shape, TRANSFORM } from "../plant/part";

/** The most vertices of a mesh, for 16-bit indices. */
const MAX_VERTICES = 65_535;
const ORIGIN = [0, 0, 0] as const;

/** Returns the part and its children, with a mesh in place of such instances, or a child for each of several meshes. */
export function together(part: Part): Part {
	const children = part.children?.map(together);
	const held = children ? { ...part, children } : part;
	const { name, shape } = part;
	if (!shape?.instances || shape.instances.each || countOf(shape.instances) < 2) return held;
	const shapes = [...shapesOf(shape, shape.instances)];
	if (shapes.length === 1) return { ...held, shape: shapes[0] };
	const own = shapes.map((each, index) => ({ name: `${name} ${index + 1}`, shape: each }));
	const { shape: _, ...rest } = held;
	return { ...rest, children: [...own, ...(children ?? [])] };
}

/** Merges the instances into as few meshes as MAX_VERTICES allows. */
function* shapesOf({ instances: _, ...shape }: Shape, instances: Instances): Generator<Shape> {
	const { mesh } = shape;
	const atOnce = Math.max(1, Math.floor((MAX_VERTICES * 3) / mesh.positions.length));
	const count = countOf(instances);
	// Meshes of equal size, rather than full ones and a rest.
	const each = Math.ceil(count / Math.ceil(count / atOnce));
	for (let from = 0; from < count; from += each) {
		yield { ...shape, mesh: mergedInstances(mesh, instances, from, Math.min(count, from + each)) };
	}
}

/** Merges the instances from index `from` to before `to` into one mesh. */
function mergedInstances(mesh: PartMesh, { transforms, sky }: Instances, from: number, to: number): PartMesh {
	const vertices = mesh.positions.length / 3;
	const merged = {
		positions: new Float32Array(3 * vertices * (to - from)),
		normals: new Float32Array(3 * vertices * (to - from)),
		uvs: repeated(mesh.uvs, to - from),
		indices: new Uint32Array(mesh.indices.length * (to - from)),
		...(mesh.colours ? { colours: repeated(mesh.colours, to - from) } : {}),
		...(sky ? { sky: new Uint8Array(vertices * (to - from)) } : {}),
	};
	for (let i = from; i < to; i++) {
		const vertex = vertices * (i - from);
		const { positions, normals } = placed(mesh, transforms.subarray(TRANSFORM * i, TRANSFORM * (i + 1)));
		merged.positions.set(positions, 3 * vertex);
		merged.normals.set(normals, 3 * vertex);
		const at = mesh.indices.length * (i - from);
		for (let k = 0; k < mesh.indices.length; k++) merged.indices[at + k] = mesh.indices[k] + vertex;
		if (sky) merged.sky?.fill(sky[i], vertex, vertex + vertices);
	}
	return merged;
}

/** Returns the positions and normals of a mesh after the transform of one of its instances. */
export function placed(mesh: PartMesh, [x, y, z, qx, qy, qz, qw, scale]: Float32Array) {
	const turn = rotationMatrix({ x: qx, y: qy, z: qz, w: qw });
	const positions = new Float64Array(mesh.positions.length);
	const normals = new Float64Array(mesh.normals.length);
	placeVectors(mesh.positions, turn, scale, [x, y, z], positions);
	placeVectors(mesh.normals, turn, 1, ORIGIN, normals);
	return { positions, normals };
}

/** Returns the values several times, one copy after the other. */
function repeated(values: Float32Array, times: number): Float32Array {
	const all = new Float32Array(values.length * times);
	for (let i = 0; i < times; i++) all.set(values, values.length * i);
	return all;
}

/** Returns the number of instances. */
const countOf = ({ transforms }: Instances) => transforms.length / TRANSFORM;
