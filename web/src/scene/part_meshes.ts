/** Parts as three's meshes. */
import {
	BufferAttribute,
	BufferGeometry,
	InstancedBufferAttribute,
	InstancedMesh,
	Matrix4,
	Mesh,
	type MeshStandardMaterial,
} from "three";
import type { Material } from "../plant/material";
import { everyPart, type Part, type PartMesh, TRANSFORM } from "../plant/part";
import { grainChunk } from "./grain";
import type { LightUniforms } from "./light_shader";
import { standardMaterial } from "./standard_material";

export type PartObject = Mesh<BufferGeometry, MeshStandardMaterial>;

/** The transform of instance `index` as a matrix. */
export function matrixOf(transforms: Float32Array, index: number, matrix = new Matrix4()): Matrix4 {
	writeMatrix(transforms, TRANSFORM * index, matrix.elements, 0);
	return matrix;
}

/** Place, turn and size as 4 × 4 numbers, column by column; of many instances, without an object for each. */
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
			if (shape.material.grain !== undefined) geometry.setAttribute("uv", new BufferAttribute(mesh.uvs, 2));
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
		const detail = material.grain === undefined ? undefined : grainChunk(material.grain);
		const made = kinds.get(kind) ?? standardMaterial(material, { light: this.#light, coloured, sky, detail });
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
	const matrices = object.instanceMatrix.array;
	for (let i = 0; i < count; i++) writeMatrix(transforms, TRANSFORM * i, matrices, 16 * i);
	return object;
}
