/** Parts as three's meshes. */
import {
	BufferAttribute,
	BufferGeometry,
	InstancedBufferAttribute,
	InstancedMesh,
	Matrix4,
	Mesh,
	type MeshStandardMaterial,
	Quaternion,
	Vector3,
} from "three";
import type { Material } from "../plant/material";
import { everyPart, type Part, type PartMesh, TRANSFORM } from "../plant/part";
import type { LightUniforms } from "./light_shader";
import { standardMaterial } from "./standard_material";

export type PartObject = Mesh<BufferGeometry, MeshStandardMaterial>;

/** The transform of instance `index` as a matrix. */
export function matrixOf(transforms: Float32Array, index: number, matrix = new Matrix4()): Matrix4 {
	const [x, y, z, qx, qy, qz, qw, scale] = transforms.subarray(TRANSFORM * index, TRANSFORM * (index + 1));
	return matrix.compose(new Vector3(x, y, z), new Quaternion(qx, qy, qz, qw), new Vector3(scale, scale, scale));
}

/** The meshes of all parts that have a shape; geometries and materials are shared as the parts share theirs. */
export class PartMeshes {
	readonly objects: PartObject[] = [];
	readonly #light: LightUniforms;
	readonly #geometries = new Map<PartMesh, BufferGeometry>();
	/** Those with something of their instances in them, which nobody shares. */
	readonly #own: BufferGeometry[] = [];
	/** By what else tells two apart: whether they have colours, and skies. */
	readonly #materials = new Map<Material, Map<string, MeshStandardMaterial>>();

	constructor(parts: Iterable<Part>, light: LightUniforms) {
		this.#light = light;
		for (const { name, shape } of everyPart(parts)) {
			if (!shape) continue;
			const { mesh, instances } = shape;
			const geometry = this.#geometryOf(mesh, instances?.sky);
			const coloured = mesh.colours !== undefined;
			const material = this.#materialOf(shape.material, coloured, geometry.hasAttribute("sky"));
			const object = instances ? instanced(geometry, material, instances.transforms) : new Mesh(geometry, material);
			object.name = name;
			object.castShadow = true;
			object.receiveShadow = true;
			this.objects.push(object);
		}
	}

	dispose(): void {
		for (const geometry of [...this.#geometries.values(), ...this.#own]) geometry.dispose();
		for (const kinds of this.#materials.values()) for (const material of kinds.values()) material.dispose();
		for (const object of this.objects) if (object instanceof InstancedMesh) object.dispose();
	}

	#geometryOf(mesh: PartMesh, skies?: Uint8Array): BufferGeometry {
		const known = this.#geometries.get(mesh) ?? geometryOf(mesh);
		this.#geometries.set(mesh, known);
		if (!skies || mesh.sky) return known;
		const own = new BufferGeometry();
		for (const [name, attribute] of Object.entries(known.attributes)) own.setAttribute(name, attribute);
		own.setAttribute("sky", new InstancedBufferAttribute(skies, 1, true));
		own.setIndex(known.index);
		this.#own.push(own);
		return own;
	}

	#materialOf(material: Material, coloured: boolean, sky: boolean): MeshStandardMaterial {
		const kinds = this.#materials.get(material) ?? new Map<string, MeshStandardMaterial>();
		this.#materials.set(material, kinds);
		const kind = `${coloured} ${sky}`;
		const made = kinds.get(kind) ?? standardMaterial(material, { light: this.#light, coloured, sky });
		kinds.set(kind, made);
		return made;
	}
}

function geometryOf({ positions, normals, colours, sky, indices }: PartMesh): BufferGeometry {
	const geometry = new BufferGeometry();
	geometry.setAttribute("position", new BufferAttribute(positions, 3));
	geometry.setAttribute("normal", new BufferAttribute(normals, 3));
	if (colours) geometry.setAttribute("color", new BufferAttribute(colours, 3));
	if (sky) geometry.setAttribute("sky", new BufferAttribute(sky, 1, true));
	geometry.setIndex(new BufferAttribute(indices, 1));
	return geometry;
}

function instanced(geometry: BufferGeometry, material: MeshStandardMaterial, transforms: Float32Array): PartObject {
	const count = transforms.length / TRANSFORM;
	const object = new InstancedMesh(geometry, material, count);
	const matrix = new Matrix4();
	for (let i = 0; i < count; i++) object.setMatrixAt(i, matrixOf(transforms, i, matrix));
	return object;
}
