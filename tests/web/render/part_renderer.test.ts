import {
	type DirectionalLight,
	Group,
	type InstancedBufferAttribute,
	InstancedMesh,
	Matrix4,
	type Mesh,
	type MeshBasicMaterial,
	type MeshPhysicalMaterial,
	PerspectiveCamera,
	type Texture,
	Vector3,
} from "three";
import { describe, expect, it } from "vitest";
import type { Material, Picture } from "../../../web/src/plant/material";
import type { Part } from "../../../web/src/plant/part";
import { partsOf } from "../../../web/src/plant/parts_of";
import type { Plant } from "../../../web/src/plant/plant";
import { rigOf } from "../../../web/src/render/light";
import { PAPER } from "../../../web/src/render/model_renderer";
import { PaperShadow } from "../../../web/src/render/paper_shadow";
import { partRenderer } from "../../../web/src/render/part_renderer";
import { StageLight } from "../../../web/src/render/stage_light";
import { windUniforms } from "../../../web/src/render/wind_shader";
import { fruits, PULP, tetrahedron } from "../formats/toy_parts";
import { toyPlant } from "../plant/toy_plant";

const plant = toyPlant();

function staged() {
	const stage = {
		root: new Group(),
		light: new StageLight(),
		shadow: new PaperShadow(),
		wind: windUniforms(),
		setting: PAPER,
	};
	const renderer = partRenderer<unknown, Plant>((grown) => partsOf(grown))(stage);
	const meshes = () => stage.root.children.filter((child): child is Mesh => "isMesh" in child);
	return { stage, renderer, meshes };
}

describe("the renderer of parts", () => {
	it("draws every part, with instances, and their shadows", () => {
		const { stage, renderer, meshes } = staged();
		renderer.show(plant, {});
		expect(meshes().map(({ name }) => name)).toEqual(["Trunk", "Branch", "Bract", "Leaf"]);
		expect((meshes()[3] as InstancedMesh).count).toBe(3);
		expect(stage.shadow.hard.children).toHaveLength(4);
		renderer.show({ ...plant, meshes: plant.meshes.slice(0, 1) }, {});
		expect(meshes()).toHaveLength(2);
		expect(stage.shadow.hard.children).toHaveLength(2);
	});

	it("reuses materials between plants, and disposes of materials that many plants did not use", () => {
		const { renderer, meshes } = staged();
		renderer.show(plant, {});
		const worn = meshes().map(({ material }) => material as MeshPhysicalMaterial);
		const gone: string[] = [];
		for (const material of worn) material.addEventListener("dispose", () => gone.push(material.name));
		renderer.show(structuredClone(plant), {});
		expect(meshes().every(({ material }, index) => material === worn[index])).toBe(true);
		expect(gone).toEqual([]);
		const bare = { ...plant, meshes: [] };
		for (let i = 0; i < 5; i++) renderer.show(bare, {});
		renderer.show(plant, {});
		expect(meshes().map(({ material }) => material)).toEqual(worn);
		const other = (i: number) => ({ ...plant, meshes: [{ ...plant.meshes[0], material: `bark ${i}`, runs: [] }] });
		for (let i = 0; i < 20; i++) renderer.show(other(i), {});
		expect(gone).toEqual([]);
		for (let i = 20; i < 30; i++) renderer.show(other(i), {});
		expect(new Set(gone)).toEqual(new Set(worn.map(({ name }) => name)));
	});

	it("shows pictures on textured parts, and replaces them in the same materials", () => {
		const stage = {
			root: new Group(),
			light: new StageLight(),
			shadow: new PaperShadow(),
			wind: windUniforms(),
			setting: PAPER,
		};
		const renderer = partRenderer<unknown, Part[]>((parts) => parts)(stage);
		const meshes = () => stage.root.children.filter((child): child is Mesh => "isMesh" in child);
		const picture = (shade: number): Picture => ({ width: 2, height: 1, pixels: new Uint8Array(6).fill(shade) });
		const normal = picture(128);
		const sheet = (shade: number): Part => {
			const material: Material = { ...PULP, colour: [shade, 0, 0], textures: { colour: picture(shade), normal } };
			const mesh = tetrahedron([0, 0, 0], 1, new Array(12).fill(0.5));
			return { name: `Sheet ${shade}`, shape: { mesh, material } };
		};
		renderer.show([sheet(10), sheet(20)], {});
		const worn = meshes().map(({ material }) => material as MeshPhysicalMaterial);
		const shown = () => worn.map(({ map }) => [...((map as Texture).image as { data: Uint8Array }).data]);
		expect(shown()).toEqual([10, 20].map((shade) => [shade, shade, shade, 255, shade, shade, shade, 255]));
		expect(worn.map(({ color, vertexColors }) => [color.r, vertexColors])).toEqual([
			[1, true],
			[1, true],
		]);
		expect(worn[0].map?.colorSpace).toBe("srgb");
		// The first row is v = 0; green points against v, three's up.
		expect(worn[0].map?.flipY).toBe(false);
		expect(worn[0].normalScale.toArray()).toEqual([1, -1]);
		expect(meshes().every(({ geometry }) => geometry.hasAttribute("uv"))).toBe(true);
		const [before, normalMap] = [worn[0].map, worn[0].normalMap];
		const gone: string[] = [];
		before?.addEventListener("dispose", () => gone.push("colour"));
		normalMap?.addEventListener("dispose", () => gone.push("normal"));
		renderer.show([sheet(30), sheet(40)], {});
		expect(meshes().map(({ material }) => material)).toEqual(worn);
		expect(shown().map(([red]) => red)).toEqual([30, 40]);
		expect(gone).toEqual(["colour"]);
		expect(worn[0].normalMap).toBe(normalMap);
		renderer.dispose();
		expect(gone).toEqual(["colour", "normal"]);
	});

	it("computes a bounding sphere of every mesh and its instances", () => {
		const { renderer, meshes } = staged();
		renderer.show(plant, {});
		const corner = new Vector3();
		const place = new Matrix4();
		for (const mesh of meshes()) {
			const many = mesh instanceof InstancedMesh ? mesh.count : 1;
			const ball = mesh instanceof InstancedMesh ? mesh.boundingSphere : mesh.geometry.boundingSphere;
			for (let i = 0; i < many; i++) {
				if (mesh instanceof InstancedMesh) mesh.getMatrixAt(i, place);
				const positions = mesh.geometry.getAttribute("position");
				for (let k = 0; k < positions.count; k++) {
					corner.fromBufferAttribute(positions, k);
					if (mesh instanceof InstancedMesh) corner.applyMatrix4(place);
					expect(ball?.distanceToPoint(corner)).toBeLessThan(1e-6);
				}
			}
		}
	});

	it("has bounds that contain the whole plant", () => {
		const { renderer } = staged();
		renderer.show(plant, {});
		const { spheres, points } = renderer.bounds();
		expect(spheres).toHaveLength(4 * 3);
		// A blade reaches √1.25 from its foot.
		expect(spheres[3]).toBeCloseTo(0.05 * Math.sqrt(1.25), 6);
		expect(points).toHaveLength(3 * (8 + 8 + 4));
	});

	it("returns pick ids of meshes that have them, and numbers other parts behind the last id", () => {
		const stage = {
			root: new Group(),
			light: new StageLight(),
			shadow: new PaperShadow(),
			wind: windUniforms(),
			setting: PAPER,
		};
		const renderer = partRenderer<unknown, Part[]>((parts) => parts)(stage);
		const meshes = () => stage.root.children.filter((child): child is Mesh => "isMesh" in child);
		const part = (x: number, pickIds?: Uint32Array): Part => ({
			name: `At ${x}`,
			shape: { mesh: { ...tetrahedron([x, 0, 0], 1), ...(pickIds && { pickIds }) }, material: PULP },
		});
		renderer.show([part(-5), part(0, Uint32Array.of(1, 1, 1, 1)), part(5), part(10, Uint32Array.of(2, 2, 2, 2))], {});
		const pickAt = (x: number) => renderer.pick({ origin: [x, 0.1, 9], direction: [0, 0, -1] });
		expect([-5, 0, 5, 10].map(pickAt)).toEqual([3, 1, 4, 2]);
		for (const [picked, x] of [3, 1, 4, 2].map((picked, i) => [picked, 5 * i - 5] as const)) {
			renderer.mark(picked);
			const marks = meshes().slice(4);
			expect(marks).toHaveLength(1);
			marks[0].geometry.computeBoundingBox();
			expect(marks[0].geometry.boundingBox?.getCenter(new Vector3()).x).toBeCloseTo(x, 5);
		}
		// Members of the same group are marked more softly, and each triangle is marked once.
		renderer.mark(1, new Set([1, 2]));
		const marks = meshes().slice(4);
		expect(marks.map(({ geometry }) => geometry.index?.count)).toEqual([12, 12]);
		const [own, others] = marks.map(({ material }) => (material as MeshBasicMaterial).opacity);
		expect(others).toBeLessThan(own);
	});

	it("picks the first part along a ray, with instances separately, and marks it", () => {
		const { renderer, meshes } = staged();
		renderer.show(plant, {});
		// The first leaf stands upright at (0, 0.1 … 0.15, 0), before the branch.
		const leaf = renderer.pick({ origin: [0.02, 0.14, 1], direction: [0, 0, -3] });
		expect(leaf).toBe(3);
		expect(renderer.pick({ origin: [0, 0.05, 1], direction: [0, 0, -1] })).toBe(0);
		expect(renderer.pick({ origin: [-0.03, 0.05, 1], direction: [0, 0, -1] })).toBe(2);
		expect(renderer.pick({ origin: [0.9, 0.05, 1], direction: [0, 0, -1] })).toBeUndefined();
		renderer.mark(leaf);
		const mark = meshes().at(-1) as Mesh;
		expect((mark.material as MeshPhysicalMaterial).emissive.r).toBeGreaterThan(0.1);
		expect(mark.position.toArray().map((value) => Math.round(1000 * value))).toEqual([0, 100, 0]);
		renderer.mark(undefined);
		expect(meshes()).toHaveLength(4);
		renderer.mark(99);
		expect(meshes()).toHaveLength(4);
	});

	it("disposes of all its objects", () => {
		const { stage, renderer } = staged();
		renderer.show(plant, {});
		renderer.mark(0);
		renderer.dispose();
		expect(stage.root.children).toEqual([]);
		expect(stage.shadow.hard.children).toEqual([]);
	});

	it("is lit by the stage's light", () => {
		const { stage, renderer } = staged();
		stage.light.setRig(rigOf("dark"));
		const camera = new PerspectiveCamera();
		camera.updateMatrixWorld();
		stage.light.aim(camera);
		renderer.prepare(camera);
		const lamps = stage.root.children[0].children as unknown as { color: { r: number }; position: { x: number } }[];
		expect(lamps[0].color.r).toBe(stage.light.rig.key.irradiance[0]);
		expect(lamps[0].position.x).toBeCloseTo(stage.light.rig.key.direction.x, 9);
	});

	it("casts the key light's shadow on itself, redrawn after changes of plant or light, or after a lost context", () => {
		const { stage, renderer, meshes } = staged();
		renderer.show(plant, {});
		expect(meshes().every(({ castShadow, receiveShadow }) => castShadow && receiveShadow)).toBe(true);
		const key = stage.root.children[0].children[0] as DirectionalLight;
		const camera = new PerspectiveCamera();
		const aimed = () => {
			key.shadow.needsUpdate = false;
			camera.updateMatrixWorld();
			stage.light.aim(camera);
			renderer.prepare(camera);
			return key.shadow.needsUpdate;
		};
		expect([key.castShadow, key.shadow.autoUpdate, key.shadow.needsUpdate]).toEqual([true, false, true]);
		expect([aimed(), aimed()]).toEqual([true, false]);
		camera.rotation.y = 0.2;
		expect([aimed(), aimed()]).toEqual([true, false]);
		renderer.restored?.();
		expect(key.shadow.needsUpdate).toBe(true);
		// The whole plant is in front of the shadow's camera.
		const { left, right, near, far } = key.shadow.camera;
		expect(right - left).toBeGreaterThan(0.18);
		expect(far - near).toBeCloseTo(right - left, 9);
		const middle = key.target.position;
		expect(key.position.distanceTo(middle)).toBeCloseTo((near + far) / 2, 9);
	});

	it("darkens parts by their visible sky: vertices separately, organs one by one", () => {
		const { renderer, meshes } = staged();
		const trunk = { ...plant.meshes[0], sky: new Uint8Array(plant.meshes[0].positions.length / 3).fill(51) };
		const organs = { ...plant.organs, sky: Uint8Array.from({ length: plant.organs.count }, (_, i) => 85 * i) };
		renderer.show({ ...plant, meshes: [trunk, ...plant.meshes.slice(1)], organs }, {});
		const skyOf = (index: number) => meshes()[index].geometry.getAttribute("sky");
		expect(skyOf(0).getX(3)).toBeCloseTo(0.2, 6);
		const leaves = skyOf(3) as InstancedBufferAttribute;
		expect([leaves.isInstancedBufferAttribute, leaves.count]).toEqual([true, 3]);
		expect(leaves.getX(1)).toBeCloseTo(1 / 3, 6);
	});

	it("shows a fully visible sky by default, in the same materials", () => {
		const { renderer, meshes } = staged();
		const sky = (vertices: Float32Array) => new Uint8Array(vertices.length / 3).fill(51);
		const organs = { ...plant.organs, sky: new Uint8Array(plant.organs.count) };
		renderer.show(
			{ ...plant, meshes: plant.meshes.map((mesh) => ({ ...mesh, sky: sky(mesh.positions) })), organs },
			{},
		);
		const worn = meshes().map(({ material }) => material);
		renderer.show(plant, {});
		expect(meshes().map(({ material }) => material)).toEqual(worn);
		for (const mesh of meshes()) {
			const open = mesh.geometry.getAttribute("sky") as InstancedBufferAttribute;
			expect([open.count, open.getX(0)]).toEqual([1, 1]);
			expect(open.meshPerAttribute).toBe(mesh instanceof InstancedMesh ? mesh.count : 1);
		}
	});

	it("shows a material's picture on its mesh, with the same texture for the same picture", () => {
		const stage = {
			root: new Group(),
			light: new StageLight(),
			shadow: new PaperShadow(),
			wind: windUniforms(),
			setting: PAPER,
		};
		const colour = { width: 1, height: 1, pixels: Uint8Array.of(1, 2, 3) };
		const renderer = partRenderer<unknown, Plant>((grown) =>
			[...partsOf(grown)].map(({ shape, ...part }) => ({
				...part,
				...(shape ? { shape: { ...shape, material: { ...shape.material, textures: { colour } } } } : {}),
			})),
		)(stage);
		renderer.show(plant, {});
		const [trunk] = stage.root.children.filter((child): child is Mesh => "isMesh" in child);
		const material = trunk.material as MeshPhysicalMaterial;
		expect(material.map?.image).toMatchObject({ width: 1, height: 1 });
		const uvs = trunk.geometry.getAttribute("uv");
		expect(uvs.count).toBe(trunk.geometry.getAttribute("position").count);
		expect([...uvs.array]).toEqual([...plant.meshes[0].uvs.subarray(0, 2 * uvs.count)]);
		renderer.show(structuredClone(plant), {});
		const [again] = stage.root.children.filter((child): child is Mesh => "isMesh" in child);
		expect(again.material).toBe(material);
		renderer.dispose();
	});

	it("shows vertex colours in place of the material's colour", () => {
		const stage = {
			root: new Group(),
			light: new StageLight(),
			shadow: new PaperShadow(),
			wind: windUniforms(),
			setting: PAPER,
		};
		const renderer = partRenderer(() => fruits())(stage);
		renderer.show({}, {});
		const [fruit, , tuft] = stage.root.children.filter((child): child is Mesh => "isMesh" in child);
		const of = (mesh: Mesh) => mesh.material as MeshPhysicalMaterial;
		expect([of(fruit).vertexColors, of(fruit).color.r, of(fruit).sheen]).toEqual([true, 1, 1]);
		expect([of(tuft).vertexColors, of(tuft).color.r]).toEqual([false, 0.9]);
		expect(fruit.geometry.getAttribute("color").getX(0)).toBeCloseTo(0.8, 6);
	});
});
