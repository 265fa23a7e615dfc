/**
 * Any plant's parts → Wavefront OBJ with MTL: metres, +Y up, every instance baked. The objects have the names of the GLB's
 * nodes, with underscores for spaces. What is in the files is in docs/export.md.
 */
import { placeVectors, rows } from "../plant/orientation";
import { everyPart, type Part, type PartMesh, type Shape, TRANSFORM } from "../plant/part";
import type { About } from "./about";
import { GENERATOR } from "./generator";
import { writeMtl } from "./mtl";
import { ObjMaterials } from "./obj_materials";
import { ObjWriter } from "./obj_writer";

/** What a vertex is likely to take with its share of the faces, in bytes; only a guess to begin with. */
const BYTES_PER_VERTEX = 160;
const ORIGIN = [0, 0, 0];

/** The two texts. `name` is what the files are called without their endings: the OBJ asks for `name.mtl`. */
export function exportObj(parts: Iterable<Part>, about: About, name: string): { obj: string; mtl: string } {
	const all = [...everyPart(parts)];
	const writer = new ObjWriter(BYTES_PER_VERTEX * verticesOf(all));
	writer.line(`# ${GENERATOR}: ${about.name}, metres, +Y up`);
	writer.line(`# ${about.link}`);
	writer.line(`mtllib ${name}.mtl`);
	const materials = new ObjMaterials();
	for (const part of all) {
		if (part.shape) writeShape(writer, part.name, part.shape, materials.nameOf(part.shape));
	}
	return { obj: writer.toString(), mtl: writeMtl(materials.all()) };
}

function verticesOf(parts: readonly Part[]): number {
	return parts.reduce((sum, { shape }) => {
		const times = shape?.instances ? shape.instances.transforms.length / TRANSFORM : 1;
		return sum + (times * (shape?.mesh.positions.length ?? 0)) / 3;
	}, 0);
}

function writeShape(writer: ObjWriter, name: string, { mesh, instances }: Shape, material: string): void {
	if (!instances) {
		writer.object(name, mesh, material);
		return;
	}
	const { transforms, each } = instances;
	for (let i = 0; i < transforms.length / TRANSFORM; i++) {
		const transform = transforms.subarray(TRANSFORM * i, TRANSFORM * (i + 1));
		writer.object(each ? each(i).name : name, baked(mesh, transform), material);
	}
}

/** A mesh where one of its instances stands; texture coordinates and triangles are its own. */
function baked(mesh: PartMesh, [x, y, z, qx, qy, qz, qw, scale]: Float32Array) {
	const turn = rows({ x: qx, y: qy, z: qz, w: qw });
	const positions = new Float64Array(mesh.positions.length);
	const normals = new Float64Array(mesh.normals.length);
	placeVectors(mesh.positions, turn, scale, [x, y, z], positions);
	placeVectors(mesh.normals, turn, 1, ORIGIN, normals);
	return { positions, normals, uvs: mesh.uvs, indices: mesh.indices };
}
