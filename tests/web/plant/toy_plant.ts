/** A plant of no model: a stem in two runs, a bract on its own, and a leaf drawn three times. */
import type { Plant, PlantMesh } from "../../../web/src/plant/plant";

export function toyPlant(): Plant {
	return {
		segments: {
			count: 2,
			parent: Int32Array.from([-1, 0]),
			tag: new Uint32Array(2),
			tags: ["shoot"],
			ends: Float32Array.from([0, 0, 0, 0, 0.1, 0, 0, 0.1, 0, 0.03, 0.18, 0]),
			radii: Float32Array.from([0.004, 0.003, 0.003, 0.002]),
		},
		organs: {
			count: 4,
			tag: Uint32Array.from([0, 0, 1, 0]),
			tags: ["leaf", "scar"],
			segment: Int32Array.from([0, 1, -1, 1]),
			mesh: Int32Array.from([2, 2, -1, 2]),
			transforms: Float32Array.from([
				...[0, 0.1, 0, 0, 0, 0, 1, 0.05],
				...[0.03, 0.18, 0, 0, Math.SQRT1_2, 0, Math.SQRT1_2, 0.04],
				...[0, 0, 0, 0, 0, 0, 1, 1],
				...[0.01, 0.15, 0, 0, 1, 0, 0, 0.03],
			]),
		},
		meshes: [stem(), bract(), blade("leaf")],
		counts: { leaves: 3 },
		notes: [],
		fingerprint: "0000000000000001",
		timings: { grow: 1 },
	};
}

/** Two three-sided tubes, one run each, and a run of which nothing is left. */
function stem(): PlantMesh {
	const positions: number[] = [];
	const normals: number[] = [];
	const uvs: number[] = [];
	const indices: number[] = [];
	for (const [first, bottom, top] of [
		[0, 0, 0.1],
		[8, 0.1, 0.18],
	]) {
		for (let k = 0; k <= 3; k++) {
			const [x, z] = [Math.cos((2 * Math.PI * k) / 3), Math.sin((2 * Math.PI * k) / 3)];
			positions.push(0.004 * x, bottom, 0.004 * z, 0.003 * x, top, 0.003 * z);
			normals.push(x, 0, z, x, 0, z);
			uvs.push(k / 3, 0, k / 3, 1);
			const at = first + 2 * k;
			if (k < 3) indices.push(at, at + 1, at + 2, at + 1, at + 3, at + 2);
		}
	}
	const run = { vertexCount: 8, indexCount: 18 };
	return {
		...meshOf(positions, normals, uvs, indices),
		name: "stem",
		material: "bark",
		runs: [
			{ ...run, name: "trunk", firstVertex: 0, firstIndex: 0 },
			{ ...run, name: "branch", firstVertex: 8, firstIndex: 18 },
			{ name: "stub", firstVertex: 16, vertexCount: 0, firstIndex: 36, indexCount: 0 },
		],
	};
}

/** A small square beside the stem. */
function bract(): PlantMesh {
	const square = blade("bract");
	return { ...square, positions: square.positions.map((value, i) => 0.02 * value + [-0.03, 0.04, 0][i % 3]) };
}

/** A unit square in the plane of x and y, its foot at the origin. */
function blade(name: string): PlantMesh {
	const corners = [-0.5, 0, 0, 0.5, 0, 0, 0.5, 1, 0, -0.5, 1, 0];
	const facing = [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1];
	return {
		...meshOf(corners, facing, [0, 0, 1, 0, 1, 1, 0, 1], [0, 1, 2, 0, 2, 3]),
		name,
		material: "blade",
		runs: [],
	};
}

function meshOf(positions: number[], normals: number[], uvs: number[], indices: number[]) {
	return {
		positions: Float32Array.from(positions),
		normals: Float32Array.from(normals),
		uvs: Float32Array.from(uvs),
		indices: Uint32Array.from(indices),
	};
}
