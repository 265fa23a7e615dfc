/** Converts parts to three.js meshes. */
import {
	BufferAttribute,
	BufferGeometry,
	InstancedBufferAttribute,
	InstancedMesh,
	Matrix4,
	Mesh,
	type MeshStandardMaterial,
	Sphere,
	Vector3,
} from "three";
import { everyPart, type Instances, type Part, type PartMesh, TRANSFORM } from "../plant/part";
import type { MaterialCache } from "./material_cache";

export type PartObject = Mesh<BufferGeometry, MeshStandardMaterial>;

/**
 * Returns the transform of instance `index` as a matrix.
 * @param matrix matrix to write to
 */
export function matrixOf(transforms: Float32Array, index: number, matrix = new Matrix4()): Matrix4 {
	writeMatrix(transforms, TRANSFORM * index, matrix.elements, 0);
	return matrix;
}

/**
 * Writes one transform as a column-major 4 × 4 matrix, without an object for each instance.
 * @param transforms position (3), quaternion (4) and scale (1) of each instance
 * @param from index of the transform's first number
 * @param into array of the matrix
 * @param at index in `into` of the matrix's first number
 */
function writeMatrix(transforms: Float32Array, from: number, into: { [index: number]: number }, at: number): void {
	const qx = transforms[from + 3];
	const qy = transforms[from + 4];
	const qz = transforms[from + 5];
	const qw = transforms[from + 6];
	const scale = transforms[from + 7];
	into[at] = scale * (1 - 2 * (qy * qy + qz * qz));
	into[at + 1] = scale * 2 * (qx * qy + qw * qz);
	into[at + 2] = scale * 2 * (qx * qz - qw * qy);
	into[at + 3] = 0;
	into[at + 4] = scale * 2 * (qx * qy - qw * qz);
	into[at + 5] = scale * (1 - 2 * (qx * qx + qz * qz));
	into[at + 6] = scale * 2 * (qy * qz + qw * qx);
	into[at + 7] = 0;
	into[at + 8] = scale * 2 * (qx * qz + qw * qy);
	into[at + 9] = scale * 2 * (qy * qz - qw * qx);
	into[at + 10] = scale * (1 - 2 * (qx * qx + qy * qy));
	into[at + 11] = 0;
	into[at + 12] = transforms[from];
	into[at + 13] = transforms[from + 1];
	into[at + 14] = transforms[from + 2];
	into[at + 15] = 1;
}

/** Meshes of all parts with a shape; geometries and materials are shared as in the parts. */
export class PartMeshes {
	readonly objects: PartObject[] = [];
	readonly #geometries = new Map<PartMesh, BufferGeometry>();
	/** Geometries that contain data of their instances, and so are not shared. */
	readonly #own: BufferGeometry[] = [];

	/** @param materials cache of the meshes' materials, which the caller owns */
	constructor(parts: Iterable<Part>, materials: Pick<MaterialCache, "materialOf">) {
		for (const { name, shape } of everyPart(parts)) {
			if (!shape) continue;
			const { mesh, instances } = shape;
			const geometry = this.#geometryOf(mesh, instances);
			if (shape.material.textures) geometry.setAttribute("uv", new BufferAttribute(mesh.uvs, 2));
			const coloured = mesh.colours !== undefined;
			const material = materials.materialOf(shape.material, coloured, mesh.widths !== undefined);
			const object = instances ? instancedMesh(geometry, material, instances.transforms) : new Mesh(geometry, material);
			object.name = name;
			object.userData.pickIds = mesh.pickIds;
			object.castShadow = true;
			object.receiveShadow = true;
			// The plant is in view; culling many instances would take longer than drawing them.
			object.frustumCulled = false;
			this.objects.push(object);
		}
	}

	/** Frees all geometries and instance buffers; the cache owns the materials. */
	dispose(): void {
		for (const geometry of [...this.#geometries.values(), ...this.#own]) geometry.dispose();
		for (const object of this.objects) if (object instanceof InstancedMesh) object.dispose();
	}

	/**
	 * Returns a mesh's geometry, created once. Instances with a share of the sky of their own get a second geometry that
	 * shares all attributes but `sky`.
	 */
	#geometryOf(mesh: PartMesh, instances?: Instances): BufferGeometry {
		const known = this.#geometries.get(mesh) ?? geometryOf(mesh);
		this.#geometries.set(mesh, known);
		if (!instances || mesh.sky) return known;
		const own = new BufferGeometry();
		for (const [name, attribute] of Object.entries(known.attributes)) own.setAttribute(name, attribute);
		own.setAttribute("sky", instances.sky ? new InstancedBufferAttribute(instances.sky, 1, true) : openSky(instances));
		own.setIndex(known.index);
		own.boundingSphere = known.boundingSphere;
		this.#own.push(own);
		return own;
	}
}

/**
 * Returns an attribute with a fully visible sky for all vertices of all instances, for parts without computed sky:
 * previews then use the programs of the final parts. Each call makes an attribute of its own, because disposing of a
 * geometry frees its attributes on the graphics card.
 */
function openSky(instances?: Instances): InstancedBufferAttribute {
	const count = (instances?.transforms.length ?? 0) / TRANSFORM;
	return new InstancedBufferAttribute(Uint8Array.of(255), 1, true, Math.max(1, count));
}

/** Creates a geometry with three's attribute names; without computed sky, `sky` is fully visible. */
function geometryOf({ positions, normals, colours, sky, widths, indices }: PartMesh): BufferGeometry {
	const geometry = new BufferGeometry();
	geometry.setAttribute("position", new BufferAttribute(positions, 3));
	geometry.setAttribute("normal", new BufferAttribute(normals, 3));
	if (colours) geometry.setAttribute("color", new BufferAttribute(colours, 3));
	if (widths) geometry.setAttribute("width", new BufferAttribute(widths, 1));
	geometry.setAttribute("sky", sky ? new BufferAttribute(sky, 1, true) : openSky());
	geometry.setIndex(new BufferAttribute(indices, 1));
	geometry.boundingSphere = sphereAbout(positions, 3 * Math.max(1, Math.floor(positions.length / 3 / MAX_SAMPLED)));
	return geometry;
}

/** Largest number of vertices sampled for the size of a mesh. */
const MAX_SAMPLED = 20_000;

/**
 * Returns a bounding sphere about the middle of the points' box, ten times as fast as three's own; of radius −1 if
 * there are no points.
 * @param points x y z at the start of every `stride` numbers
 * @param reach added to the radius: how far bodies extend from their points
 */
function sphereAbout(points: Float32Array, stride: number, reach = 0): Sphere {
	let [lowX, lowY, lowZ, highX, highY, highZ] = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
	for (let i = 0; i < points.length; i += stride) {
		const x = points[i];
		const y = points[i + 1];
		const z = points[i + 2];
		if (x < lowX) lowX = x;
		if (x > highX) highX = x;
		if (y < lowY) lowY = y;
		if (y > highY) highY = y;
		if (z < lowZ) lowZ = z;
		if (z > highZ) highZ = z;
	}
	if (!(lowX <= highX)) return new Sphere(new Vector3(), -1);
	const centre = new Vector3(lowX + highX, lowY + highY, lowZ + highZ).multiplyScalar(0.5);
	return new Sphere(centre, reach + 0.5 * Math.hypot(highX - lowX, highY - lowY, highZ - lowZ));
}

/** Returns how far any instance extends from its position: the mesh's bounding sphere times the largest scale. */
function reachOf({ boundingSphere }: BufferGeometry, transforms: Float32Array): number {
	let largest = 0;
	for (let scaleAt = 7; scaleAt < transforms.length; scaleAt += TRANSFORM)
		largest = Math.max(largest, transforms[scaleAt]);
	return largest * (boundingSphere ? boundingSphere.radius + boundingSphere.center.length() : 0);
}

/** Creates an InstancedMesh from transforms (position, quaternion, scale; TRANSFORM numbers per instance). */
function instancedMesh(geometry: BufferGeometry, material: MeshStandardMaterial, transforms: Float32Array): PartObject {
	const count = transforms.length / TRANSFORM;
	const matrices = new Float32Array(16 * count);
	for (let i = 0; i < count; i++) writeMatrix(transforms, TRANSFORM * i, matrices, 16 * i);
	// Created with 0 instances, else three.js would first write that many identity matrices.
	const object = new InstancedMesh(geometry, material, 0);
	object.instanceMatrix = new InstancedBufferAttribute(matrices, 16);
	object.count = count;
	object.boundingSphere = sphereAbout(transforms, TRANSFORM, reachOf(geometry, transforms));
	return object;
}
