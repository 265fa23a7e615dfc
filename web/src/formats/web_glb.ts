/**
 * The *web* form: as small as possible without a visible difference, for pages. Readers must know meshoptimizer's
 * compression, as three.js does.
 */
import { MeshoptEncoder } from "meshoptimizer/encoder";
import type { Part, PartMesh } from "../plant/part";
import type { About } from "./about";
import { exportGlb } from "./glb";
import { lightParts } from "./light";
import { taken } from "./simplified";

const PIXELS = 512;

/**
 * Writes the file: at most 5 draw calls, KHR_mesh_quantization and EXT_meshopt_compression.
 * @param compressed without it the same values in the same order are written uncompressed, for readers without the
 * extension
 */
export async function webGlb(parts: Iterable<Part>, about: About, compressed = true): Promise<Uint8Array<ArrayBuffer>> {
	await MeshoptEncoder.ready;
	const light = (await lightParts(parts, { pixels: PIXELS })).map(reorder);
	return exportGlb(light, about, compressed ? { encoder: MeshoptEncoder } : { compact: true });
}

/** Orders triangles and vertices for compression. */
function reorder(part: Part): Part {
	if (!part.shape) return part;
	const { mesh } = part.shape;
	const indices = mesh.indices.slice();
	// reorderMesh overwrites the triangles, in their new order and with their new vertices.
	const [to, count] = MeshoptEncoder.reorderMesh(indices, true, true);
	const from = new Uint32Array(count);
	for (const [vertex, index] of to.entries()) if (index < count) from[index] = vertex;
	const reordered: PartMesh = { ...taken(mesh, from), indices };
	return { ...part, shape: { ...part.shape, mesh: reordered } };
}
