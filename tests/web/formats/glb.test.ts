import { Matrix4, type Mesh, type MeshPhysicalMaterial, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { exportGlb, type GlbOptions } from "../../../web/src/formats/glb";
import { standardMaterial } from "../../../web/src/plant/material";
import type { Part, Shape } from "../../../web/src/plant/part";
import { bounced } from "../../../web/src/plant/shade";
import { toyPlant } from "../plant/toy_plant";
import { basesOf, complaints, documentOf, load, meshesOf } from "./reading";
import { ABOUT, CENTRES, fruits, HAIR, PULP, plain, tetrahedron } from "./toy_parts";

const FORMS: GlbOptions[] = [{}, { compact: true }, { instancing: true }, { compact: true, instancing: true }];
const plant = toyPlant();

async function named(parts: Part[], options?: GlbOptions): Promise<Map<string, Mesh>> {
	const { scene } = await load(exportGlb(parts, ABOUT, options));
	scene.updateMatrixWorld(true);
	return new Map(meshesOf(scene).map((mesh) => [mesh.userData.name, mesh]));
}

const placeOf = (mesh: Mesh, vertex: number) =>
	new Vector3().fromBufferAttribute(mesh.geometry.attributes.position, vertex).applyMatrix4(mesh.matrixWorld);

describe.each(FORMS)("the GLB of a plant of no model (%o)", (form) => {
	it.each([
		["in standard materials", plain],
		["with colours, centres and children", fruits],
		["with nothing in it but groups", () => [{ name: "Empty", children: [{ name: "Void" }] }]],
	])("gives Khronos' validator nothing to say %s", async (_, parts) => {
		const found = await complaints(exportGlb(parts(), ABOUT, form));
		expect(found.filter(({ code }) => code !== "NODE_EMPTY")).toEqual([]);
	});

	it("puts every vertex where it grew", async () => {
		const branch = (await named(plain(), form)).get("Branch");
		const { positions } = plant.meshes[0];
		for (let vertex = 0; vertex < 8; vertex++) {
			const grew = new Vector3().fromArray(positions, 3 * (8 + vertex));
			expect(placeOf(branch as Mesh, vertex).distanceTo(grew)).toBeLessThan(form.compact ? 2e-6 : 1e-8);
		}
	});

	it("stands what hangs on a part where it grew, whatever the part's node does", async () => {
		const tuft = (await named(fruits(), form)).get("Tuft") as Mesh;
		expect(tuft.parent?.userData.name).toBe("Fruit 2");
		// Half a turn about Y (0, 1, 0; 0) takes (x, y, z) to (−x, y, −z); the mesh reaches 2, the instance is a thousandth.
		const [x, y, z] = CENTRES[1];
		expect(placeOf(tuft, 0).distanceTo(new Vector3(x - 0.002, y + 0.002, z - 0.002))).toBeLessThan(1e-6);
	});
});

describe.each(FORMS)("one mesh in two materials (%o)", (form) => {
	it("is drawn in both", async () => {
		const mesh = tetrahedron([0, 0, 0], 1);
		const worn = (name: string, x: number): Part => ({
			name,
			shape: {
				mesh,
				material: { ...HAIR, name: `${name} hair` },
				instances: {
					transforms: Float32Array.of(x, 0, 0, 0, 0, 0, 1, 1),
					each: () => ({ name: `${name} 1` }),
				},
			},
		});
		const { meshes = [], materials = [] } = documentOf(exportGlb([worn("Left", -1), worn("Right", 1)], ABOUT, form));
		expect(meshes.map(({ primitives }) => materials[primitives[0].material].name)).toEqual(["Left hair", "Right hair"]);
	});
});

describe.each(FORMS)("the shade in which vertices stand (%o)", (form) => {
	const sky = Uint8Array.from([255, 255, 102, 0]);
	const albedo = [0.6, 0.3, 0.2];
	const dressed = (mesh: object): Part[] => [
		{
			name: "Body",
			shape: { mesh: { ...tetrahedron([0, 0, 0], 1), ...mesh }, material: { ...HAIR, colour: [0.6, 0.3, 0.2] } },
		},
	];
	/** The colour that a reader computes from material and vertex. */
	async function seen(parts: Part[]): Promise<number[][]> {
		const body = (await named(parts, form)).get("Body") as Mesh;
		const { color } = body.material as MeshPhysicalMaterial;
		const attribute = body.geometry.attributes.color;
		return [0, 1, 2, 3].map((v) => color.toArray().map((value, k) => value * (attribute?.getComponent(v, k) ?? 1)));
	}

	it.each([
		["of a mesh with colours", { sky, colours: Float32Array.from([...albedo, ...albedo, ...albedo, ...albedo]) }],
		["of a mesh with its material's colour alone", { sky }],
	])("is in the colours %s", async (_, mesh) => {
		const colours = await seen(dressed(mesh));
		for (const [k, value] of albedo.entries()) {
			expect(colours[0][k]).toBeCloseTo(value, 2);
			expect(colours[2][k]).toBeCloseTo(value * bounced(0.4, value), 2);
			expect(colours[3][k]).toBe(0);
		}
	});

	it("leaves what nobody has looked at as it is", async () => {
		expect(await seen(dressed({}))).toEqual(
			[albedo, albedo, albedo, albedo].map((colour) => colour.map((value) => expect.closeTo(value, 6))),
		);
	});
});

describe("the GLB of any parts", () => {
	it("names the plant and its parts, instances one node each, with what is known of them", () => {
		const { nodes, meshes, materials } = documentOf(exportGlb(plain(), ABOUT));
		const names = (indices: number[] = []) => indices.map((index) => nodes[index].name);
		expect(nodes[0].name).toBe("Toy one");
		expect(names(nodes[0].children)).toEqual(["Trunk", "Branch", "Bract", "Leaf"]);
		const leaves = nodes.find(({ name }) => name === "Leaf");
		expect(names(leaves?.children)).toEqual(["Leaf 001", "Leaf 002", "Leaf 003"]);
		expect(nodes.find(({ name }) => name === "Leaf 003")?.extras).toEqual({ segment: 1 });
		expect(meshes).toHaveLength(4);
		expect(materials?.map(({ name }) => name)).toEqual(["Bark", "Blade"]);
	});

	it("turns, moves and scales each instance as it grew", async () => {
		for (const compact of [false, true]) {
			const leaf = (await named(plain(), { compact })).get("Leaf 002") as Mesh;
			// A quarter turn about Y takes the blade's width, along +X, to −Z.
			expect(placeOf(leaf, 1).distanceTo(new Vector3(0.03, 0.18, -0.02))).toBeLessThan(1e-6);
			expect(placeOf(leaf, 2).distanceTo(new Vector3(0.03, 0.22, -0.02))).toBeLessThan(1e-6);
		}
	});

	it("draws instances with one node where that is asked for, all else as ever", async () => {
		const glb = exportGlb(plain(), ABOUT, { instancing: true });
		expect(documentOf(glb).extensionsRequired).toEqual(["EXT_mesh_gpu_instancing"]);
		const { scene } = await load(glb);
		const leaves = meshesOf(scene).at(-1) as Mesh & { count: number; getMatrixAt(i: number, m: Matrix4): void };
		expect(leaves.count).toBe(3);
		const matrix = new Matrix4();
		leaves.getMatrixAt(2, matrix);
		expect(new Vector3().setFromMatrixPosition(matrix).distanceTo(new Vector3(0.01, 0.15, 0))).toBeLessThan(1e-7);
		for (const compact of [false, true]) {
			const [part] = plain().slice(-1);
			const { mesh, material } = part.shape as Shape;
			const transforms = Float32Array.from([0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 2.5]);
			const each = (i: number) => ({ name: `Leaf ${i}` });
			const two = [{ name: "Leaves", shape: { mesh, material, instances: { transforms, each } } }];
			const [drawn] = meshesOf(
				(await load(exportGlb(two, ABOUT, { instancing: true, compact }))).scene,
			) as (typeof leaves)[];
			const sizes = [0, 1].map((i) => {
				drawn.getMatrixAt(i, matrix);
				return matrix.getMaxScaleOnAxis();
			});
			expect(sizes[1] / sizes[0]).toBeCloseTo(2.5, 5);
		}
		expect(exportGlb(fruits(), ABOUT, { instancing: true })).toEqual(exportGlb(fruits(), ABOUT));
	});

	it("keeps an instance's children from turning with its mesh", async () => {
		const [{ children = [] }] = fruits();
		const tuft = children[1].children?.[0] as Part;
		const held: Part = { name: "Bead", shape: { mesh: tetrahedron([0, 0.3, 0], 0.001), material: PULP } };
		const bead = (await named([{ ...tuft, children: [held] }])).get("Bead") as Mesh;
		expect(bead.parent?.userData.name).toBe("Tuft");
		expect(placeOf(bead, 0).distanceTo(new Vector3(0.001, 0.301, 0.001))).toBeLessThan(1e-7);
	});

	it("shares arrays, meshes and materials as the parts do", () => {
		const { meshes, materials, accessors } = documentOf(exportGlb(fruits(), ABOUT));
		const [one, other] = (meshes ?? []).map(({ primitives }) => primitives[0]);
		expect(one.indices).toBe(other.indices);
		expect(one.attributes.TEXCOORD_0).toBe(other.attributes.TEXCOORD_0);
		expect(one.attributes.POSITION).not.toBe(other.attributes.POSITION);
		expect(materials?.map(({ name }) => name)).toEqual(["Pulp", "Hair"]);
		expect(accessors?.length).toBeGreaterThan(5);
	});

	it("says the brightest by a picture of one pixel, too, for readers that know no factor beside colours of vertices", async () => {
		const glb = exportGlb(fruits(), ABOUT);
		const { materials = [], images } = documentOf(glb);
		expect(
			materials.map(({ pbrMetallicRoughness: reported }) => [reported.baseColorFactor, reported.baseColorTexture]),
		).toEqual([
			[[1, 1, 1, 1], { index: 0 }],
			[[...HAIR.colour, 1], undefined],
		]);
		expect(images).toHaveLength(1);
		const { Pulp } = basesOf(glb);
		for (const [k, value] of [0.8, 0.6, 0.1].entries()) {
			expect(Pulp[k]).toBeGreaterThanOrEqual(value - 1e-6);
			expect(Pulp[k]).toBeLessThan(value + 0.01);
		}
		// Where a mesh has no place to look it up, the factor stays.
		const [first, ...others] = fruits()[0].children ?? [];
		const shape = first.shape as Shape;
		const bare = [{ ...first, shape: { ...shape, mesh: { ...shape.mesh, uvs: new Float32Array(0) } } }, ...others];
		expect(documentOf(exportGlb(bare, ABOUT)).images).toBeUndefined();
	});

	it("says colours of vertices as shares of the brightest, and the material's where there are none", async () => {
		const compact = exportGlb(fruits(), ABOUT, { compact: true });
		expect(documentOf(compact).textures).toBeUndefined();
		expect(basesOf(compact).Pulp).toEqual([0.8, 0.6, 0.1, 1].map((value) => expect.closeTo(value, 6)));
		expect(basesOf(compact).Hair).toEqual([...HAIR.colour, 1]);
		const meshes = await named(fruits());
		const { color } = (meshes.get("Fruit 1") as Mesh).geometry.attributes;
		const { Pulp } = basesOf(exportGlb(fruits(), ABOUT));
		expect(color.getX(0) * Pulp[0]).toBeCloseTo(0.8, 2);
		expect(color.getX(1) * Pulp[0]).toBeCloseTo(0.4, 2);
		expect(color.getY(1) * Pulp[1]).toBeCloseTo(0.2, 2);
		expect((meshes.get("Tuft") as Mesh).geometry.attributes.color).toBeUndefined();
	});

	it("dresses a material's parts apart where some have colours and some have none", async () => {
		const bare: Part = { name: "Bare", shape: { mesh: tetrahedron([0, 0, 0], 0.01), material: PULP } };
		const meshes = await named([...fruits(), bare]);
		const { r, g, b } = ((meshes.get("Bare") as Mesh).material as MeshPhysicalMaterial).color;
		expect([r, g, b].map((value) => Math.round(1000 * value) / 1000)).toEqual(PULP.colour);
	});

	it("writes float32 as they read best and other numbers as they are", () => {
		const { nodes } = documentOf(exportGlb(fruits(), ABOUT));
		expect(nodes.find(({ name }) => name === "Fruit 1")?.extras).toEqual({ weight: 0.1, label: "a", exact: 0.1 });
	});

	it("holds where it came from", () => {
		expect(documentOf(exportGlb(plain(), ABOUT)).asset.extras).toEqual({ link: ABOUT.link, ...ABOUT.extras });
	});

	it("leaves the parts as they were, and writes the same bytes again", () => {
		const parts = [...plain(), ...fruits()];
		const first = exportGlb(parts, ABOUT, { compact: true });
		expect(exportGlb(parts, ABOUT, { compact: true })).toEqual(first);
		expect(exportGlb([...plain(), ...fruits()], ABOUT, { compact: true })).toEqual(first);
	});
});

describe("standard materials in a GLB", () => {
	it("come back through three.js", async () => {
		const petal: Part = {
			name: "Petal",
			shape: { mesh: tetrahedron([0, 0, 0], 1), material: standardMaterial("petal") },
		};
		const material = (await named([petal])).get("Petal")?.material as MeshPhysicalMaterial;
		expect(material.side).toBe(2);
		expect(material.sheenColor.r).toBeCloseTo(0.12, 5);
		expect(material.roughness).toBeCloseTo(0.65, 5);
	});
});
