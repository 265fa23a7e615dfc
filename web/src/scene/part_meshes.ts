/** Parts as three's meshes. */
import {
	BufferAttribute,
	BufferGeometry,
	InstancedMesh,
	Matrix4,
	Mesh,
	type MeshPhysicalMaterial,
	Quaternion,
	Vector3,
} from "three";
import type { Material } from "../plant/material";
import { everyPart, type Part, type PartMesh, TRANSFORM } from "../plant/part";
import { standardMaterial } from "./standard_material";

export type PartObject = Mesh<BufferGeometry, MeshPhysicalMaterial>;

/** The transform of instance `index` as a matrix. */
export function matrixOf(transforms: Float32Array, index: number, matrix = new Matrix4()): Matrix4 {
	const [x, y, z, qx, qy, qz, qw, scale] = transforms.subarray(TRANSFORM * index, TRANSFORM * (index + 1));
	return matrix.compose(new Vector3(x, y, z), new Quaternion(qx, qy, qz, qw), new Vector3(scale, scale, scale));
}

/** The meshes of all parts that have a shape; geometries and materials are shared as the parts share theirs. */
export class PartMeshes {
	readonly objects: PartObject[] = [];
	readonly #geometries = new Map<PartMesh, BufferGeometry>();
	readonly #materials = new Map<Material, Map<boolean, MeshPhysicalMaterial>>();

	constructor(parts: Iterable<Part>) {
		for (const { name, shape } of everyPart(parts)) {
			if (!shape) continue;
			const geometry = this.#geometryOf(shape.mesh);
			const material = this.#materialOf(shape.material, shape.mesh.colours !== undefined);
			const object = shape.instances
				? instanced(geometry, material, shape.instances.transforms)
				: new Mesh(geometry, material);
			object.name = name;
			this.objects.push(object);
		}
	}

	dispose(): void {
		for (const geometry of this.#geometries.values()) geometry.dispose();
		for (const kinds of this.#materials.values()) for (const material of kinds.values()) material.dispose();
		for (const object of this.objects) if (object instanceof InstancedMesh) object.dispose();
	}

	#geometryOf(mesh: PartMesh): BufferGeometry {
		const known = this.#geometries.get(mesh);
		if (known) return known;
		const geometry = new BufferGeometry();
		geometry.setAttribute("position", new BufferAttribute(mesh.positions, 3));
		geometry.setAttribute("normal", new BufferAttribute(mesh.normals, 3));
		if (mesh.colours) geometry.setAttribute("color", new BufferAttribute(mesh.colours, 3));
		geometry.setIndex(new BufferAttribute(mesh.indices, 1));
		this.#geometries.set(mesh, geometry);
		return geometry;
	}

	#materialOf(material: Material, coloured: boolean): MeshPhysicalMaterial {
		const kinds = this.#materials.get(material) ?? new Map<boolean, MeshPhysicalMaterial>();
		this.#materials.set(material, kinds);
		const made = kinds.get(coloured) ?? standardMaterial(material, coloured);
		kinds.set(coloured, made);
		return made;
	}
}

function instanced(geometry: BufferGeometry, material: MeshPhysicalMaterial, transforms: Float32Array): PartObject {
	const count = transforms.length / TRANSFORM;
	const object = new InstancedMesh(geometry, material, count);
	const matrix = new Matrix4();
	for (let i = 0; i < count; i++) object.setMatrixAt(i, matrixOf(transforms, i, matrix));
	return object;
}
