/**
 * Limits of one file (docs/export.md), so that a small text or link cannot take all memory. The core has limits of its
 * own (wasm-core/src/foundation/limits.hpp).
 */
import { everyPart, type Part, type PartMesh, TRANSFORM } from "../plant/part";
import { FileTooLargeError } from "./file_error";

/** The most bytes of meshes in a file, counting every copy. */
export const MAX_MESH_BYTES = 320_000_000;
/** The most bytes of a text file (JSON, OBJ, CSV), or of the text in a file (USDZ, 3MF). */
export const MAX_TEXT_BYTES = 200_000_000;

/**
 * How a file writes instances: each mesh once (`shared`); named instances as nodes that share a mesh, all others as
 * meshes (`nodes`); all as meshes (`meshes`).
 */
export type WrittenInstances = "shared" | "nodes" | "meshes";

/**
 * Checks the size of a file's meshes before it is made.
 * @throws FileTooLargeError where a file would hold more bytes of meshes than `MAX_MESH_BYTES`
 */
export function checkMeshBytes(parts: Iterable<Part>, instances: WrittenInstances): void {
	const bytes = meshBytes(parts, instances);
	if (bytes > MAX_MESH_BYTES) throw new FileTooLargeError(bytes, MAX_MESH_BYTES, instances !== "shared");
}

/**
 * Returns the bytes of the meshes in a file. Meshes that parts share count once where instances are not written as
 * meshes.
 */
export function meshBytes(parts: Iterable<Part>, instances: WrittenInstances): number {
	const counted = new Set<PartMesh>();
	let bytes = 0;
	for (const { shape } of everyPart(parts)) {
		if (!shape) continue;
		const { mesh } = shape;
		const isShared = instances === "shared" || (instances === "nodes" && shape.instances?.each !== undefined);
		if (isShared && counted.has(mesh)) continue;
		if (isShared) counted.add(mesh);
		const copies = isShared || !shape.instances ? 1 : shape.instances.transforms.length / TRANSFORM;
		bytes += copies * bytesOf(mesh);
	}
	return bytes;
}

/** Returns the bytes of a mesh's arrays. */
function bytesOf({ positions, normals, uvs, indices }: PartMesh): number {
	return positions.byteLength + normals.byteLength + uvs.byteLength + indices.byteLength;
}
