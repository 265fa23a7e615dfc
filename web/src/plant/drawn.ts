/**
 * Geometry that a plant's modules have drawn, one by one, for picking and highlighting in a view. Segments and organs
 * are numbered as in `DerivationTrace.segments` and `organs`. Metres.
 */
import { TRANSFORM } from "./part";
import type { MeshRun, Plant, PlantMesh } from "./plant";

/** An organ's surface. */
export interface DrawnSurface {
	/** 3 × points. */
	readonly positions: Float32Array;
	/** 3 × triangles. */
	readonly indices: ArrayLike<number>;
	/** Its triangles within the mesh; all where absent. */
	readonly run?: Pick<MeshRun, "firstIndex" | "indexCount">;
	/** Position x y z, rotation x y z w, scale; identity where absent. */
	readonly transform?: Float32Array | undefined;
}

export interface DrawnGeometry {
	/** 6 × segments: start x y z, end x y z. */
	readonly ends: Float32Array;
	/** 2 × segments: radius at the start, at the end. */
	readonly radii: Float32Array;
	/** The number of organs. */
	readonly organs: number;
	/** The surface of an organ; undefined where it has none. */
	surface(organ: number): DrawnSurface | undefined;
}

/**
 * Returns the drawn geometry of any plant: its segments, and a surface per organ that has one.
 * @param runs for meshes whose runs are organs, by the mesh's name: the organ of each run
 */
export function drawnOf(
	{ segments, organs, meshes }: Pick<Plant, "segments" | "organs" | "meshes">,
	runs: Readonly<Record<string, Uint32Array>> = {},
): DrawnGeometry {
	const apart = new Map<number, { mesh: PlantMesh; run: MeshRun }>();
	for (const mesh of meshes) {
		runs[mesh.name]?.forEach((organ, index) => {
			apart.set(organ, { mesh, run: mesh.runs[index] });
		});
	}
	return {
		ends: segments.ends,
		radii: segments.radii,
		organs: organs.count,
		surface(organ) {
			const own = apart.get(organ);
			if (own) return { positions: own.mesh.positions, indices: own.mesh.indices, run: own.run };
			const mesh = meshes[organs.mesh[organ]];
			if (!mesh) return undefined;
			const transform = organs.transforms.subarray(TRANSFORM * organ, TRANSFORM * (organ + 1));
			return { positions: mesh.positions, indices: mesh.indices, transform };
		},
	};
}

/** Returns the corners of a surface's triangles after its transform: 9 × triangles. */
export function trianglesOf({ positions, indices, run, transform }: DrawnSurface): Float32Array {
	const { firstIndex = 0, indexCount = indices.length } = run ?? {};
	const corners = new Float32Array(3 * indexCount);
	const [x, y, z, qx, qy, qz, qw, scale] = transform ?? [0, 0, 0, 0, 0, 0, 1, 1];
	for (let i = 0; i < indexCount; i++) {
		const at = 3 * indices[firstIndex + i];
		const [px, py, pz] = [scale * positions[at], scale * positions[at + 1], scale * positions[at + 2]];
		// Rotate by the quaternion: p + 2 q × (q × p + w p).
		const cx = qy * pz - qz * py + qw * px;
		const cy = qz * px - qx * pz + qw * py;
		const cz = qx * py - qy * px + qw * pz;
		corners[3 * i] = x + px + 2 * (qy * cz - qz * cy);
		corners[3 * i + 1] = y + py + 2 * (qz * cx - qx * cz);
		corners[3 * i + 2] = z + pz + 2 * (qx * cy - qy * cx);
	}
	return corners;
}
