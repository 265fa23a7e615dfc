import { describe, expect, it } from "vitest";
import { leafTints } from "../../../../web/src/plant/leaf_colours";
import { EMPTY_PLANT } from "../../../../web/src/plant/plant";
import { attachedParts, woodenParts } from "../../../../web/src/plant/wood/wooden_parts";

const BRANCHES = 40;
const LEAVES = 4000;

/** A trunk with thin branches, and as many leaves on each of them. */
function plant() {
	const count = 1 + BRANCHES;
	const mesh = {
		name: "leaf",
		material: "blade",
		positions: new Float32Array(9),
		normals: new Float32Array(9),
		uvs: new Float32Array(6),
		indices: Uint32Array.of(0, 1, 2),
		runs: [],
	};
	return {
		...EMPTY_PLANT,
		meshes: [mesh],
		segments: {
			...EMPTY_PLANT.segments,
			count,
			ends: Float32Array.from({ length: 6 * count }, (_, i) => i),
			parent: Int32Array.from({ length: count }, (_, i) => (i === 0 ? -1 : 0)),
			radii: Float32Array.from({ length: 2 * count }, (_, i) => (i < 2 ? 1 : 0.01)),
		},
		organs: {
			...EMPTY_PLANT.organs,
			count: LEAVES,
			tags: ["leaf"],
			tag: new Uint32Array(LEAVES),
			mesh: new Int32Array(LEAVES),
			segment: Int32Array.from({ length: LEAVES }, (_, i) => 1 + (i % BRANCHES)),
			transforms: Float32Array.from({ length: 8 * LEAVES }, (_, i) => Math.sin(i * i)),
		},
	};
}

const MATERIALS = leafTints({ leaf: "4a7030", autumn: "a8702c", season: 0.4 });

describe("attachedParts", () => {
	const parts = [...attachedParts(plant(), { blade: MATERIALS })];
	const counts = parts.map(({ shape }) => (shape?.instances?.transforms.length ?? 0) / 8);

	it("gives each tint about as many leaves as the others", () => {
		expect(parts).toHaveLength(MATERIALS.length);
		for (const count of counts) {
			expect(count).toBeGreaterThan((0.6 * LEAVES) / MATERIALS.length);
			expect(count).toBeLessThan((1.4 * LEAVES) / MATERIALS.length);
		}
	});

	it("gives the leaves of a branch tints that are alike", () => {
		const { organs } = plant();
		const branchAt = new Map<string, number>();
		for (let i = 0; i < LEAVES; i++)
			branchAt.set([0, 1, 2].map((k) => Math.round(1e4 * organs.transforms[8 * i + k])).join(), organs.segment[i]);
		const tints = new Map<number, number[]>();
		parts.forEach(({ shape }, tint) => {
			const transforms = shape?.instances?.transforms ?? [];
			for (let at = 0; at < transforms.length; at += 8) {
				const branch = branchAt.get([0, 1, 2].map((k) => Math.round(1e4 * transforms[at + k])).join()) ?? -1;
				tints.set(branch, [...(tints.get(branch) ?? []), tint]);
			}
		});
		const variance = (values: readonly number[]) => {
			const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
			return values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length;
		};
		const within = [...tints.values()].map(variance);
		const overall = variance([...tints.values()].flat());
		expect(within.reduce((sum, value) => sum + value, 0) / within.length).toBeLessThan(0.7 * overall);
	});
});

describe("woodenParts", () => {
	it("gives each vertex of the wood the diameter of its stem", () => {
		const { meshes, ...bare } = plant();
		const wood = { ...meshes[0], name: "stems", material: "bark" };
		const grown = { ...bare, meshes: [wood], organs: EMPTY_PLANT.organs, vertexSegments: Uint32Array.of(0, 1, 1) };
		const bark = { old: [0, 0, 0], young: [0, 0, 0], from: 0, to: 1 } as const;
		const material = { name: "Bark", colour: [0.1, 0.1, 0.1] as [number, number, number], roughness: 1 };
		const [part] = woodenParts(grown, {
			wood: material,
			bark: { ...bark, old: [0, 0, 0], young: [0, 0, 0] },
			tints: {},
		});
		const widths = [...(part.shape?.mesh.widths ?? [])];
		expect(widths[0]).toBeCloseTo(2);
		expect(widths[1]).toBeCloseTo(0.02);
		expect(widths).toHaveLength(3);
	});
});
