/** Encodes areas and path as blocks of a request (wasm-core/src/models/grammar/areas.hpp). */
import type { Block } from "../../../core/container";
import { AREA_KINDS, type WithAreas } from "./area";

/** Encodes areas and the path through them for the core; blocks that would be empty are left out. */
export function areaBlocks({ areas = [], path = [], from = [] }: WithAreas): Block[] {
	const blocks: Block[] = [];
	if (areas.length > 0) {
		blocks.push({ name: "areas.kinds", data: Uint32Array.from(areas, ({ kind }) => AREA_KINDS.indexOf(kind)) });
		const places = areas.flatMap(({ centre, size, rotation }) => [...centre, ...size, ...rotation]);
		blocks.push({ name: "areas.places", data: Float32Array.from(places), width: 10 });
	}
	const meshes = areas.map(({ mesh }) => mesh ?? { points: [], triangles: [] });
	if (meshes.some(({ triangles }) => triangles.length > 0)) {
		const counts = meshes.flatMap(({ points, triangles }) => [points.length / 3, triangles.length / 3]);
		blocks.push({ name: "areas.meshes", data: Uint32Array.from(counts), width: 2 });
		blocks.push({ name: "areas.points", data: Float32Array.from(meshes.flatMap(({ points }) => points)), width: 3 });
		blocks.push({
			name: "areas.triangles",
			data: Uint32Array.from(meshes.flatMap(({ triangles }) => triangles)),
			width: 3,
		});
	}
	if (path.length > 0) blocks.push({ name: "path", data: Float32Array.from(path), width: 3 });
	if (path.length > 0 && from.length === path.length / 3)
		blocks.push({ name: "path.from", data: Uint32Array.from(from) });
	return blocks;
}
