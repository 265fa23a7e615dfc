import {
	Box3,
	Color,
	InstancedMesh,
	type Mesh,
	MeshPhysicalMaterial,
	type MeshStandardMaterial,
	type Object3D,
} from "three";
import { describe, expect, it } from "vitest";
import { toObject3D } from "../../../web/src/library/three";
import { load } from "../formats/reading";
import { type Grown, grow, SMALL, toGLB } from "./growing";

type Drawn = Mesh<Mesh["geometry"], MeshStandardMaterial>;

function meshesOf(object: Object3D): Drawn[] {
	const meshes: Drawn[] = [];
	object.traverse((each) => {
		if ((each as Drawn).isMesh) meshes.push(each as Drawn);
	});
	return meshes;
}

/** The detailed GLB as three's own loader reads it, and the group. */
async function both(grown: Grown) {
	const { scene } = await load(await toGLB(grown));
	return { read: meshesOf(scene), group: await toObject3D(grown), scene };
}

const called = ({ name }: Object3D) => name.replaceAll(" ", "_");
const corners = (object: Object3D) => {
	const { min, max } = new Box3().setFromObject(object);
	return [...min.toArray(), ...max.toArray()];
};
/** The visible colour of a vertex: the material's colour times its own. */
function colourAt({ material, geometry }: Drawn, vertex: number): number[] {
	const { color } = geometry.attributes;
	const own = material.vertexColors ? new Color().fromBufferAttribute(color as never, vertex) : new Color(1, 1, 1);
	return material.color.clone().multiply(own).toArray();
}

describe("a plant as a group of three’s", () => {
	it("has the parts, places, colours and materials that the GLB has", async () => {
		const grown = await grow(SMALL);
		const { read, group, scene } = await both(grown);
		const drawn = meshesOf(group);
		expect(group.name).toBe("bunch redcurrant");
		expect(group.userData).toEqual({ link: grown.link, fingerprint: grown.fingerprint });
		expect(drawn.map(called).sort()).toEqual(read.map(({ name }) => name).sort());
		corners(scene).forEach((value, i) => void expect(corners(group)[i]).toBeCloseTo(value, 5));
		for (const own of drawn) {
			const other = read.find(({ name }) => name === called(own)) as Drawn;
			expect(own.geometry.index?.count).toBe(other.geometry.index?.count);
			expect(own.material.name).toBe(other.material.name);
			expect(own.material.roughness).toBeCloseTo(other.material.roughness, 5);
			expect(own.material.side).toBe(other.material.side);
			expect(own.geometry.attributes.sky).toBeUndefined();
			const vertices = own.geometry.attributes.position.count;
			for (let vertex = 0; vertex < vertices; vertex += Math.ceil(vertices / 7)) {
				const [mine, its] = [colourAt(own, vertex), colourAt(other, vertex)];
				mine.forEach((value, channel) => void expect(Math.abs(value - its[channel])).toBeLessThan(0.006));
			}
		}
		const skin = drawn.map(({ material }) => material).find((material) => material instanceof MeshPhysicalMaterial);
		expect(skin).toBeDefined();
	});

	it("draws what stands many times as instances, where the GLB has a node for each", async () => {
		const { read, group, scene } = await both(await grow("?v=1&preset=short-conical&seed=2"));
		const instanced = meshesOf(group).filter((mesh): mesh is InstancedMesh & Drawn => mesh instanceof InstancedMesh);
		expect(instanced).toHaveLength(1);
		expect(read.length).toBe(meshesOf(group).length - 1 + instanced[0].count);
		corners(scene).forEach((value, i) => void expect(corners(group)[i]).toBeCloseTo(value, 4));
	});

	it("has a tree’s leaves as instances in their shade, as many triangles as the GLB has of them", async () => {
		const { read, group, scene } = await both(await grow({ model: "tree", n: 60 }));
		const trianglesOf = (mesh: Drawn) =>
			((mesh.geometry.index?.count ?? 0) / 3) * (mesh instanceof InstancedMesh ? mesh.count : 1);
		const sum = (meshes: Drawn[]) => meshes.reduce((all, mesh) => all + trianglesOf(mesh), 0);
		expect(sum(meshesOf(group))).toBe(sum(read));
		corners(scene).forEach((value, i) => void expect(corners(group)[i]).toBeCloseTo(value, 3));
		const leaves = meshesOf(group).filter((mesh): mesh is InstancedMesh & Drawn => mesh instanceof InstancedMesh);
		expect(leaves.length).toBeGreaterThan(0);
		for (const { count, instanceColor } of leaves) {
			const tints = [...(instanceColor?.array ?? [])];
			expect(tints).toHaveLength(3 * count);
			expect(Math.max(...tints)).toBeLessThanOrEqual(1);
			expect(Math.min(...tints)).toBeLessThan(0.9);
			expect(Math.min(...tints)).toBeGreaterThan(0);
		}
	});

	it("lays a leaf’s pictures on it", async () => {
		const leaf = meshesOf(await toObject3D(await grow({ model: "leaf", preset: "oak", n: 60 })));
		expect(leaf.some(({ material, geometry }) => material.map !== null && geometry.attributes.uv !== undefined)).toBe(
			true,
		);
	});
});
